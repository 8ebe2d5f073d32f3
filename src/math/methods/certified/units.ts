import type { Answers, Rays } from '../../batch/batch.ts';
import { AT_LATTICE, FAITHFUL_ONCE, type Lattice, UNIT_OF_DIRECTION } from './numbers.ts';

/** Rays of a block that fit the first cache together with what the passes hand on. */
export const BLOCK = 256;

/**
 * What the passes over a block hand to each other, one value for each ray that is hit. The passes
 * are closures over these arrays, made once: so V8 knows the arrays when it compiles them and reads
 * and writes without looking up map, length and base each time, which costs more than the
 * arithmetic.
 */
export interface Scratch {
  /** The ray's place in the batch. */
  readonly index: Int32Array;
  /** d and E. */
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
  readonly ex: Float64Array;
  readonly ey: Float64Array;
  readonly ez: Float64Array;
  /**
   * A, √D with A's sign roughly, 1/(2√D), the roots roughly, and how far the relative error of a
   * step may go.
   */
  readonly A: Float64Array;
  readonly slope: Float64Array;
  readonly half: Float64Array;
  readonly near: Float64Array;
  readonly far: Float64Array;
  readonly slack: Float64Array;
  /**
   * The roots' whole parts, f there, g at the nearer one, what bounds g's error, and how far those
   * points are from the centre.
   */
  readonly wholeNear: Float64Array;
  readonly wholeFar: Float64Array;
  readonly fNear: Float64Array;
  readonly fFar: Float64Array;
  readonly g: Float64Array;
  readonly reach: Float64Array;
  readonly spread: Float64Array;
  readonly spreadFar: Float64Array;
  /**
   * Places of rays that pass 1 could not judge, of clear hits that pass 3 could not settle, and of
   * rays that start on the surface or near it.
   */
  readonly doubtful: Int32Array;
  readonly unsettled: Int32Array;
  readonly starting: Int32Array;
  /** How many there are: hits, doubtful, unsettled, starting. */
  readonly count: Int32Array;
}

/** Indices into `Scratch.count`. */
export const HITS = 0;
export const DOUBTS = 1;
export const UNSETTLED = 2;
export const STARTING = 3;

/** Scratch for one block. */
export function createScratch(): Scratch {
  const array = (): Float64Array => new Float64Array(BLOCK);
  return {
    index: new Int32Array(BLOCK),
    x: array(),
    y: array(),
    z: array(),
    ex: array(),
    ey: array(),
    ez: array(),
    A: array(),
    slope: array(),
    half: array(),
    g: array(),
    reach: array(),
    near: array(),
    far: array(),
    slack: array(),
    fNear: array(),
    fFar: array(),
    wholeNear: array(),
    wholeFar: array(),
    spread: array(),
    spreadFar: array(),
    doubtful: new Int32Array(BLOCK),
    unsettled: new Int32Array(BLOCK),
    starting: new Int32Array(BLOCK),
    count: new Int32Array(4),
  };
}

/*
 * Pass 1: is it hit, and roughly where. In halves, u = 2^-53, Q = Am·Cm:
 *
 *   quantity         bound                reason
 *   D = b² − AC      27u·Q                class.ts
 *   underflow        ≪ `smallest`         Am is neither tiny nor huge; what overflows fails the
 *                                         comparisons
 *   √D               27u·2^19 < 2^-29 √D  D > CLEAR_ROUGH·Q; so |b|/√D ≤ 2^10, too
 *   A                3u·Am + u|A|         squares u, their sum u; a·y² 3u; the difference
 *                    ≤ 200u|A|            |A| > LEAST·Am; so A ≠ 0
 *   −b/A             2^-36 of the roots'  5u√Q/|A|, and what 1/A is off
 *                    distance
 *   rough roots      2^-28.9 of it        √D's, and the middle's
 *                    < 2^-7 units of t    pass 3 asks for points within 2^24 units of the centre,
 *                                         and |d| has 2^4 at least: the distance is < 2^21
 *   t, the nearest   0.51 units from      1/2, and 2^-7
 *   whole number     the root
 *
 * Where A·D overflows, 1/(A·D) is 0, and so is half the distance of the rough roots: pass 3 asks
 * for a gap between them, and leaves such a ray open.
 */
/** Least D of a clear hit, largest D of a clear miss, both in Q; least |A| in Am. */
export const CLEAR_ROUGH = 2 ** -20;
export const CERTAIN = -28 * 2 ** -53;
export const LEAST = 2 ** -6;

/**
 * The relative error of a step in pass 3 is (4 Am/|A| + 14)u at most, and more by what g is
 * off; pass 1 has Am/|A| at hand.
 */
export const SLACK_A = 4 * 2 ** -53;
export const SLACK = 14 * 2 ** -53;

/**
 * What pass 1 leaves open goes to recentred.ts if b² is that many times D, its roots much nearer to
 * each other than to E; else to refined.ts at once. A matter of speed only.
 */
const FARTHER = 2 ** 10;

/**
 * Where |AC| is that small a share of b², a root is so near to 0 that pass 3 would not settle it:
 * such a ray goes to from-surface.ts at once. Again a matter of speed only.
 */
const NEARLY = 2 ** -13;

/** What the loops of pass 1 take before they begin. */
export const AT_ROUGH = {
  clearly: 0,
  certain: 1,
  least: 2,
  slackA: 3,
  slack0: 4,
  farther: 5,
  nearly: 6,
} as const;
/** In the order of AT_ROUGH. */
export const ROUGH_BOUNDS: readonly number[] = [
  CLEAR_ROUGH,
  CERTAIN,
  LEAST,
  SLACK_A,
  SLACK,
  FARTHER,
  NEARLY,
];

/**
 * Pass 1 over rays `from` to `to` of a batch: puts misses into `out`, hits and lists into Scratch.
 */
export type CoarsePass = (
  lattice: Lattice,
  rays: Rays,
  out: Answers,
  from: number,
  to: number,
) => void;

/** For shapes with a term in y. */
export function coarseInSpace(s: Scratch): CoarsePass {
  const { index, x: xs, y: ys, z: zs, ex: exs, ey: eys, ez: ezs } = s;
  const { doubtful, unsettled, starting, count } = s;
  const { A: As, slope: slopes, half: halves, near, far, slack } = s;
  return (lattice, { Ex, Ey, Ez, dx, dy, dz }, { t0, t1 }, from, to) => {
    const Cx = lattice[AT_LATTICE.Cx] as number;
    const Cy = lattice[AT_LATTICE.Cy] as number;
    const Cz = lattice[AT_LATTICE.Cz] as number;
    const a = lattice[AT_LATTICE.a] as number;
    const rho = lattice[AT_LATTICE.rho] as number;
    const smallest = lattice[AT_LATTICE.smallest] as number;
    const largestDirection = lattice[AT_LATTICE.largestDirection] as number;
    const smallestDirection = lattice[AT_LATTICE.smallestDirection] as number;
    const clearly = ROUGH_BOUNDS[AT_ROUGH.clearly] as number;
    const certain = ROUGH_BOUNDS[AT_ROUGH.certain] as number;
    const least = ROUGH_BOUNDS[AT_ROUGH.least] as number;
    const slackA = ROUGH_BOUNDS[AT_ROUGH.slackA] as number;
    const slack0 = ROUGH_BOUNDS[AT_ROUGH.slack0] as number;
    const farther = ROUGH_BOUNDS[AT_ROUGH.farther] as number;
    const nearly = ROUGH_BOUNDS[AT_ROUGH.nearly] as number;
    let hits = 0;
    let doubts = 0;
    let close = 0;
    let starts = 0;
    for (let i = from; i < to; i++) {
      const x = dx[i] as number;
      const y = dy[i] as number;
      const z = dz[i] as number;
      const ex = Ex[i] as number;
      const ey = Ey[i] as number;
      const ez = Ez[i] as number;
      const px = ex - Cx;
      const py = ey - Cy;
      const pz = ez - Cz;
      const round = x * x + z * z;
      const ayy = a * (y * y);
      const wide = px * px + pz * pz;
      const app = a * (py * py);
      const A = round - ayy;
      const Am = round + Math.abs(ayy);
      const b = x * px + z * pz - a * (y * py);
      const bb = b * b;
      const AC = A * (wide - app - rho);
      const D = bb - AC;
      const Cm = wide + Math.abs(app) + rho;
      const Q = Am * Cm;
      const fits = Am > smallestDirection && Am < largestDirection;
      const clear =
        D > clearly * Q + smallest &&
        fits &&
        Math.abs(A) > least * Am &&
        Math.abs(AC) > nearly * bb;
      const missed = D < certain * Q - smallest && fits;
      if (clear) {
        // One division beside the root, not after it: 1/(A·D) gives 1/A and 1/√D.
        const root = Math.sqrt(D);
        const inverse = 1 / (A * D);
        const over = inverse * D;
        const h = root * Math.abs(over);
        const middle = -b * over;
        index[hits] = i;
        xs[hits] = x;
        ys[hits] = y;
        zs[hits] = z;
        exs[hits] = ex;
        eys[hits] = ey;
        ezs[hits] = ez;
        As[hits] = A;
        const signed = A * h;
        slopes[hits] = signed;
        halves[hits] = 0.5 * (signed * (inverse * A));
        near[hits] = middle - h;
        far[hits] = middle + h;
        slack[hits] = slackA * (Am * Math.abs(over)) + slack0;
        hits += 1;
      } else if (missed) {
        t0[i] = Number.NaN;
        t1[i] = Number.NaN;
      } else {
        const beside = Math.abs(AC) <= nearly * bb;
        const remote = bb > farther * D;
        if (beside) starting[starts++] = i;
        else if (remote) doubtful[doubts++] = i;
        else unsettled[close++] = i;
      }
    }
    count[HITS] = hits;
    count[DOUBTS] = doubts;
    count[UNSETTLED] = close;
    count[STARTING] = starts;
  };
}

/** For cylinders, whose formula does not look at y. */
export function coarseAroundAxis(s: Scratch): CoarsePass {
  const { index, x: xs, z: zs, ex: exs, ez: ezs, doubtful, unsettled, starting, count } = s;
  const { A: As, slope: slopes, half: halves, near, far, slack } = s;
  return (lattice, { Ex, Ez, dx, dz }, { t0, t1 }, from, to) => {
    const Cx = lattice[AT_LATTICE.Cx] as number;
    const Cz = lattice[AT_LATTICE.Cz] as number;
    const rho = lattice[AT_LATTICE.rho] as number;
    const smallest = lattice[AT_LATTICE.smallest] as number;
    const largestDirection = lattice[AT_LATTICE.largestDirection] as number;
    const smallestDirection = lattice[AT_LATTICE.smallestDirection] as number;
    const clearly = ROUGH_BOUNDS[AT_ROUGH.clearly] as number;
    const certain = ROUGH_BOUNDS[AT_ROUGH.certain] as number;
    const slackA = ROUGH_BOUNDS[AT_ROUGH.slackA] as number;
    const slack0 = ROUGH_BOUNDS[AT_ROUGH.slack0] as number;
    const farther = ROUGH_BOUNDS[AT_ROUGH.farther] as number;
    const nearly = ROUGH_BOUNDS[AT_ROUGH.nearly] as number;
    let hits = 0;
    let doubts = 0;
    let close = 0;
    let starts = 0;
    for (let i = from; i < to; i++) {
      const x = dx[i] as number;
      const z = dz[i] as number;
      const ex = Ex[i] as number;
      const ez = Ez[i] as number;
      const px = ex - Cx;
      const pz = ez - Cz;
      const A = x * x + z * z;
      const wide = px * px + pz * pz;
      const b = x * px + z * pz;
      const bb = b * b;
      const AC = A * (wide - rho);
      const D = bb - AC;
      const Cm = wide + rho;
      const Q = A * Cm;
      const fits = A > smallestDirection && A < largestDirection;
      const clear = D > clearly * Q + smallest && fits && Math.abs(AC) > nearly * bb;
      const missed = D < certain * Q - smallest && fits;
      if (clear) {
        const root = Math.sqrt(D);
        const inverse = 1 / (A * D);
        const over = inverse * D;
        const h = root * over;
        const middle = -b * over;
        index[hits] = i;
        xs[hits] = x;
        zs[hits] = z;
        exs[hits] = ex;
        ezs[hits] = ez;
        As[hits] = A;
        const signed = A * h;
        slopes[hits] = signed;
        halves[hits] = 0.5 * (signed * (inverse * A));
        near[hits] = middle - h;
        far[hits] = middle + h;
        slack[hits] = slackA + slack0;
        hits += 1;
      } else if (missed) {
        t0[i] = Number.NaN;
        t1[i] = Number.NaN;
      } else {
        const beside = Math.abs(AC) <= nearly * bb;
        const remote = bb > farther * D;
        if (beside) starting[starts++] = i;
        else if (remote) doubtful[doubts++] = i;
        else unsettled[close++] = i;
      }
    }
    count[HITS] = hits;
    count[DOUBTS] = doubts;
    count[UNSETTLED] = close;
    count[STARTING] = starts;
  };
}

/*
 * Pass 2: f = q·q − ρ, q = p + t d, at the whole numbers t next to the rough roots, and g = q·d at
 * the nearer one. In units (y times `up`), for lift = |t| + 2, l = lift/2 and s = Σ|qh|:
 *
 *   quantity              bound                  reason
 *   d = dh + dl, E = eh+el |dl|, |el| ≤ 1/2      cut to whole units, exactly
 *   ph = eh − Ch, qh      exact                  qh = ph + t·dh in whole units
 *   ql = (el−Cl) + t·dl   |ql| ≤ |t|/2 + 1 = l   halves of units
 *                         |δql| ≤ 2u·l           three roundings: u, u|t|/2, u·l
 *   S = Σ|qh + ql|        ≤ s + 1.5 lift = size  so is Σ|2qh + ql|/2
 *   H = Σqh² − ρh − …     u|H| ≤ u(|f| + |L|)    exact but for the last subtraction: size ≤ 2^24
 *                                                keeps terms below 2^48; x² + z² − a1·y² − ρh
 *                                                counts in 32nds, a2·y² in 2^-11, ≤ 2^53 of them
 *   L = Σ ql(2qh + ql)    |L| ≤ 2l·S
 *                         10u·2l·S               δql 2, bracket 1, product 1, for y a's rounding
 *                         = 10u·lift·size        and its product 1 each, four sums; H's share
 *   a3·y²                 3u·2^-12 s²            |a3| ≤ 2^-12: its rounding, product and a sum,
 *                         < u·2^-10.4 s²
 *   rest of ρ, all added  3u|f|                  the rest is ≤ 1/2
 *
 * So |δf| ≤ ε + 3u|f|, ε = u·size(10·lift + 2^-10.4 size). And g: q is rounded, u, and off by 2u·l;
 * the products u, a twice more; two sums: |δg| ≤ 6u·reach, where reach is the sum of the products'
 * sizes, and what ql adds is far less.
 *
 * Math.abs is taken of numbers with a fraction where there is a choice: of whole ones V8 expects
 * int32.
 */

/** Pass 2 over the hits in Scratch. */
export type ResidualPass = (lattice: Lattice) => void;

/** For shapes with a term in y. */
export function residualsInSpace(s: Scratch): ResidualPass {
  const { x: xs, y: ys, z: zs, ex: exs, ey: eys, ez: ezs, near, far, count } = s;
  const { wholeNear, wholeFar, g: gs, reach, fNear, fFar, spread, spreadFar } = s;
  return (lattice) => {
    const cutD = lattice[AT_LATTICE.cutD] as number;
    const cutE = lattice[AT_LATTICE.cutE] as number;
    const cutT = lattice[AT_LATTICE.cutT] as number;
    const wholeX = lattice[AT_LATTICE.wholeX] as number;
    const cutDy = lattice[AT_LATTICE.cutDy] as number;
    const cutEy = lattice[AT_LATTICE.cutEy] as number;
    const up = lattice[AT_LATTICE.up] as number;
    const wholeY = lattice[AT_LATTICE.wholeY] as number;
    const wholeZ = lattice[AT_LATTICE.wholeZ] as number;
    const restX = lattice[AT_LATTICE.restX] as number;
    const restY = lattice[AT_LATTICE.restY] as number;
    const restZ = lattice[AT_LATTICE.restZ] as number;
    const a = lattice[AT_LATTICE.a] as number;
    const a1 = lattice[AT_LATTICE.a1] as number;
    const a2 = lattice[AT_LATTICE.a2] as number;
    const wholeRho = lattice[AT_LATTICE.wholeRho] as number;
    const a3 = lattice[AT_LATTICE.a3] as number;
    const restRho = lattice[AT_LATTICE.restRho] as number;
    const hits = count[HITS] as number;
    for (let j = 0; j < hits; j++) {
      const x = xs[j] as number;
      const y = ys[j] as number;
      const z = zs[j] as number;
      const ex = exs[j] as number;
      const ey = eys[j] as number;
      const ez = ezs[j] as number;
      const xh = x + cutD - cutD;
      const yh = y + cutDy - cutDy;
      const zh = z + cutD - cutD;
      const xl = x - xh;
      const yl = y - yh;
      const zl = z - zh;
      const exh = ex + cutE - cutE;
      const eyh = ey + cutEy - cutEy;
      const ezh = ez + cutE - cutE;
      const pxh = exh - wholeX;
      const pyh = eyh - wholeY;
      const pzh = ezh - wholeZ;
      const pxl = ex - exh - restX;
      const pyl = ey - eyh - restY;
      const pzl = ez - ezh - restZ;
      const t = (near[j] as number) + cutT - cutT;
      const qx = pxh + t * xh;
      const qy = pyh + t * yh;
      const qz = pzh + t * zh;
      const qxl = pxl + t * xl;
      const qyl = pyl + t * yl;
      const qzl = pzl + t * zl;
      const atX = qx + qxl;
      const atY = qy + qyl;
      const atZ = qz + qzl;
      const gx = atX * x;
      const gy = a * (atY * y);
      const gz = atZ * z;
      gs[j] = gx + gz - gy;
      reach[j] = Math.abs(gx) + Math.abs(gz) + Math.abs(gy);
      const round = qx * qx + qz * qz;
      const yy = qy * qy;
      fNear[j] =
        round -
        a1 * yy -
        wholeRho -
        a2 * yy +
        (qxl * (qx + atX) + qzl * (qz + atZ) - a * (qyl * (qy + atY)) - a3 * yy - restRho);
      const v = (far[j] as number) + cutT - cutT;
      const wx = pxh + v * xh;
      const wy = pyh + v * yh;
      const wz = pzh + v * zh;
      const wxl = pxl + v * xl;
      const wyl = pyl + v * yl;
      const wzl = pzl + v * zl;
      const wide = wx * wx + wz * wz;
      const vv = wy * wy;
      fFar[j] =
        wide -
        a1 * vv -
        wholeRho -
        a2 * vv +
        (wxl * (wx + wx + wxl) +
          wzl * (wz + wz + wzl) -
          a * (wyl * (wy + wy + wyl)) -
          a3 * vv -
          restRho);
      wholeNear[j] = t;
      wholeFar[j] = v;
      spread[j] = Math.abs(qx) + up * Math.abs(qy) + Math.abs(qz);
      spreadFar[j] = Math.abs(wx) + up * Math.abs(wy) + Math.abs(wz);
    }
  };
}

/** For cylinders, whose formula does not look at y. */
export function residualsAroundAxis(s: Scratch): ResidualPass {
  const { x: xs, z: zs, ex: exs, ez: ezs, near, far, count } = s;
  const { wholeNear, wholeFar, g: gs, reach, fNear, fFar, spread, spreadFar } = s;
  return (lattice) => {
    const cutD = lattice[AT_LATTICE.cutD] as number;
    const cutE = lattice[AT_LATTICE.cutE] as number;
    const cutT = lattice[AT_LATTICE.cutT] as number;
    const wholeX = lattice[AT_LATTICE.wholeX] as number;
    const wholeZ = lattice[AT_LATTICE.wholeZ] as number;
    const restX = lattice[AT_LATTICE.restX] as number;
    const restZ = lattice[AT_LATTICE.restZ] as number;
    const wholeRho = lattice[AT_LATTICE.wholeRho] as number;
    const restRho = lattice[AT_LATTICE.restRho] as number;
    const hits = count[HITS] as number;
    for (let j = 0; j < hits; j++) {
      const x = xs[j] as number;
      const z = zs[j] as number;
      const ex = exs[j] as number;
      const ez = ezs[j] as number;
      const xh = x + cutD - cutD;
      const zh = z + cutD - cutD;
      const xl = x - xh;
      const zl = z - zh;
      const exh = ex + cutE - cutE;
      const ezh = ez + cutE - cutE;
      const pxh = exh - wholeX;
      const pzh = ezh - wholeZ;
      const pxl = ex - exh - restX;
      const pzl = ez - ezh - restZ;
      const t = (near[j] as number) + cutT - cutT;
      const qx = pxh + t * xh;
      const qz = pzh + t * zh;
      const qxl = pxl + t * xl;
      const qzl = pzl + t * zl;
      const atX = qx + qxl;
      const atZ = qz + qzl;
      const gx = atX * x;
      const gz = atZ * z;
      gs[j] = gx + gz;
      reach[j] = Math.abs(gx) + Math.abs(gz);
      const round = qx * qx + qz * qz;
      fNear[j] = round - wholeRho + (qxl * (qx + atX) + qzl * (qz + atZ) - restRho);
      const v = (far[j] as number) + cutT - cutT;
      const wx = pxh + v * xh;
      const wz = pzh + v * zh;
      const wxl = pxl + v * xl;
      const wzl = pzl + v * zl;
      const wide = wx * wx + wz * wz;
      fFar[j] = wide - wholeRho + (wxl * (wx + wx + wxl) + wzl * (wz + wz + wzl) - restRho);
      wholeNear[j] = t;
      wholeFar[j] = v;
      spread[j] = Math.abs(qx) + Math.abs(qz);
      spreadFar[j] = Math.abs(wx) + Math.abs(wz);
    }
  };
}

/*
 * Pass 3. At a whole number a the quadratic has the value f and half the slope g = A·a + b, and D =
 * g² − A f whatever a is. So with S = ±√D, of A's sign,
 *
 *   the smaller root is a + fa/(S − g),     the larger one b − fb/(S + g + A(b − a)),
 *
 * and S is had from the rough √D by Newton's step, which squares its error of 2^-29 (pass 1). With
 * w = Am/|A|, R = reach/|S|, the steps δ ≤ 0.51 units and a gap b − a of at least LEAST_GAP units:
 * |A f|/D ≤ 4·0.51·1.03/20 < 0.11, and |g| is between 0.94|S| and 1.06|S|.
 *
 *   quantity        bound                     reason
 *   S               6.4uR + (0.2w + 2.9)u     g² 12.7uR and 1.1u; A f 3u + (3w + 2)u, times 0.11;
 *                                             the difference u; half of all that; the step's
 *                                             roundings 1.5u
 *   S − g           6.4uR + (0.1w + 2.5)u     ≥ 1.94|S|: 6.4uR + 6uR + (0.2w + 2.9)u of |S|, and u
 *   S + g + A·gap   6.4uR + (3.5w + 6)u       the same, and A·gap ≤ 2.12|S| with (3w + 2)u, two
 *                                             roundings
 *   quotients       7u                        f 3u, and four roundings (of one quotient for both,
 *                                             1/(product of the divisors), in which each divisor
 *                                             cancels)
 *   each step δ     (6.5R + 4w + 14)u|δ|      together: SLACK_G, SLACK_A, SLACK
 *     from its ε    1.06 ε/(2|S|)             ε/1.94|S|, and through S a fortieth of that
 *     from εa, of   0.03 εa/(2|S|)            through S into the larger root's step: |A|εa/(2|S|)
 *     the larger                              /(1.94|S|)·|δb|, |A δb| ≤ 0.055|S|: SHARE
 *
 * A root is rounded once: it is faithful, and the root itself where that is a double, if it was off
 * by less than u|t|/2 before, since neighbours of t are at least u|t| apart. FAITHFUL_ONCE leaves a
 * tenth for evaluating the bound. NaN and what overflows fail the comparisons.
 */
/** Bounds of the tables of passes 2 and 3, with room: ε (two), δ in reach, εa's share in b. */
export const ROUNDING = 11 * 2 ** -53 * UNIT_OF_DIRECTION;
export const SMALL = 2 ** -11 * 2 ** -53;
export const SLACK_G = 13 * 2 ** -53;
export const SHARE = 2 ** -5;
/** What the loop of pass 3 takes before it begins. */
export const AT_SOLVE = {
  rounding: 0,
  small: 1,
  faithful: 2,
  slackG: 3,
  threeHalves: 4,
  share: 5,
} as const;
/** In the order of AT_SOLVE. */
export const SOLVE_BOUNDS: readonly number[] = [
  ROUNDING,
  SMALL,
  FAITHFUL_ONCE,
  SLACK_G,
  1.5 * UNIT_OF_DIRECTION,
  SHARE,
];

/** Pass 3 over the hits in Scratch: puts settled roots into `out`, and lists the others. */
export type SolvePass = (lattice: Lattice, out: Answers) => void;

/** Pass 3 for all curved shapes. */
export function solvePass(s: Scratch): SolvePass {
  const { index, A: As, slope: slopes, half: halves, slack, unsettled, count } = s;
  const { wholeNear, wholeFar, g: gs, reach, fNear, fFar, spread, spreadFar } = s;
  return (lattice, { t0, t1 }) => {
    const two = lattice[AT_LATTICE.two] as number;
    const largest = lattice[AT_LATTICE.largestSize] as number;
    const leastGap = lattice[AT_LATTICE.leastGap] as number;
    const hits = count[HITS] as number;
    let left = count[UNSETTLED] as number;
    const rounding = SOLVE_BOUNDS[AT_SOLVE.rounding] as number;
    const small = SOLVE_BOUNDS[AT_SOLVE.small] as number;
    const faithful = SOLVE_BOUNDS[AT_SOLVE.faithful] as number;
    const slackG = SOLVE_BOUNDS[AT_SOLVE.slackG] as number;
    const threeHalves = SOLVE_BOUNDS[AT_SOLVE.threeHalves] as number;
    const share = SOLVE_BOUNDS[AT_SOLVE.share] as number;
    for (let j = 0; j < hits; j++) {
      const a = wholeNear[j] as number;
      const b = wholeFar[j] as number;
      const A = As[j] as number;
      const slope = slopes[j] as number;
      const half = halves[j] as number;
      const g = gs[j] as number;
      const fA = fNear[j] as number;
      const fB = fFar[j] as number;
      const gap = b - a;
      const root = slope + (g * g - A * fA - slope * slope) * half;
      const downA = root - g;
      const downB = root + (g + A * gap);
      const over = 1 / (downA * downB);
      const stepA = fA * (downB * over);
      const stepB = fB * (downA * over);
      const rootA = a + stepA;
      const rootB = b - stepB;
      const liftA = Math.abs(a) + two;
      const liftB = Math.abs(b) + two;
      const sizeA = (spread[j] as number) + threeHalves * liftA;
      const sizeB = (spreadFar[j] as number) + threeHalves * liftB;
      const weight = Math.abs(half);
      const loss = (slack[j] as number) + slackG * ((reach[j] as number) * weight);
      const lostA = Math.abs(stepA);
      const lostB = Math.abs(stepB);
      const epsilonA = sizeA * (rounding * liftA + small * sizeA);
      const epsilonB = sizeB * (rounding * liftB + small * sizeB);
      const errorA = weight * epsilonA;
      const errorB = weight * (epsilonB + share * epsilonA);
      const settled =
        errorA + loss * lostA <= faithful * Math.abs(rootA) &&
        errorB + loss * lostB <= faithful * Math.abs(rootB) &&
        gap >= leastGap &&
        sizeA < largest &&
        sizeB < largest;
      const i = index[j] as number;
      if (settled) {
        t0[i] = rootA;
        t1[i] = rootB;
      } else unsettled[left++] = i;
    }
    count[UNSETTLED] = left;
  };
}

/** All three passes over rays `from` to `to`. */
export type OrdinaryRoots = (
  lattice: Lattice,
  hasY: boolean,
  rays: Rays,
  out: Answers,
  from: number,
  to: number,
) => void;

/**
 * Both roots of the rays of a block, but for the first count[DOUBTS] of `doubtful` and the first
 * count[UNSETTLED] of `unsettled`, which the scratch holds until the next block.
 */
export function ordinaryRootsWith(scratch: Scratch): OrdinaryRoots {
  const coarse = [coarseAroundAxis(scratch), coarseInSpace(scratch)] as const;
  const residuals = [residualsAroundAxis(scratch), residualsInSpace(scratch)] as const;
  const solve = solvePass(scratch);
  return (lattice, hasY, rays, out, from, to) => {
    const form = hasY ? 1 : 0;
    coarse[form](lattice, rays, out, from, to);
    residuals[form](lattice);
    solve(lattice, out);
  };
}
