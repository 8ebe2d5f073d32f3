import type { Answers, Rays } from '../../batch/batch.ts';
import { AT_LATTICE, type Lattice } from './quadric-numbers.ts';

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
  /** Places of rays that pass 1 could not judge, and of clear hits that pass 3 could not settle. */
  readonly doubtful: Int32Array;
  readonly unsettled: Int32Array;
  /** How many there are: hits, doubtful, unsettled. */
  readonly count: Int32Array;
}

export const HITS = 0;
export const DOUBTS = 1;
export const UNSETTLED = 2;

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
    count: new Int32Array(3),
  };
}

/*
 * Pass 1: is it hit, and roughly where. u = 2^-53. D = b² − AC, in halves, is off by 27u·Q at most,
 * Q = Am·Cm (class.ts). Where Am is neither tiny nor huge, what underflows is far below `smallest`;
 * what overflows fails the comparisons.
 *
 * D > CLEAR_ROUGH·Q: √D is known to 27u·2^19 < 2^-29 of itself, and |b|/√D ≤ 2^10. |A| > LEAST·Am:
 * |δA| ≤ 3u·Am + u|A| (squares u, their sum u; a·y² 3u; the difference), so A is known to 200u, and
 * not 0.
 *
 * So the middle of the rough roots, off by 5u√Q/|A| and by what 1/A is off, is known to 2^-36 of
 * their distance and each of them to 2^-28.9. That is less than 2^-7 units of t, since pass 3 asks
 * of both points to be within 2^24 units of the centre and |d| has at least 2^4, so their distance
 * is below 2^21: the whole number next to a rough root is at most 0.51 units from the root.
 *
 * Where A·D overflows, 1/(A·D) is 0, and so is half the distance of the rough roots: pass 3 asks
 * for a gap between them, and leaves such a ray open.
 */
const CLEAR_ROUGH = 2 ** -20;
const CERTAIN = -28 * 2 ** -53;
const LEAST = 2 ** -6;

/**
 * The relative error of a step in units-roots.ts is (4 Am/|A| + 14)u at most, and more by what g is
 * off; pass 1 has Am/|A| at hand.
 */
const SLACK_A = 4 * 2 ** -53;
const SLACK = 14 * 2 ** -53;

/**
 * What pass 1 leaves open goes to recentred.ts if b² is that many times D, its roots much nearer to
 * each other than to E; else to refined.ts at once. A matter of speed only.
 */
const FARTHER = 2 ** 10;

/**
 * The loops take their bounds from here: of a module's constants a bundler makes variables, which
 * V8 looks up at each use.
 */
export const ROUGH_BOUNDS = Float64Array.of(CLEAR_ROUGH, CERTAIN, LEAST, SLACK_A, SLACK, FARTHER);

export type CoarsePass = (
  lattice: Lattice,
  rays: Rays,
  out: Answers,
  from: number,
  to: number,
) => void;

/** For shapes with a term in y. */
export function coarseInSpace(s: Scratch): CoarsePass {
  const { index, x: xs, y: ys, z: zs, ex: exs, ey: eys, ez: ezs, doubtful, unsettled, count } = s;
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
    const clearly = ROUGH_BOUNDS[0] as number;
    const certain = ROUGH_BOUNDS[1] as number;
    const least = ROUGH_BOUNDS[2] as number;
    const slackA = ROUGH_BOUNDS[3] as number;
    const slack0 = ROUGH_BOUNDS[4] as number;
    const farther = ROUGH_BOUNDS[5] as number;
    let hits = 0;
    let doubts = 0;
    let close = 0;
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
      const D = b * b - A * (wide - app - rho);
      const Cm = wide + Math.abs(app) + rho;
      const Q = Am * Cm;
      const fits = Am > smallestDirection && Am < largestDirection;
      const clear = D > clearly * Q + smallest && fits && Math.abs(A) > least * Am;
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
        const remote = b * b > farther * D;
        if (remote) doubtful[doubts++] = i;
        else unsettled[close++] = i;
      }
    }
    count[HITS] = hits;
    count[DOUBTS] = doubts;
    count[UNSETTLED] = close;
  };
}

/** For cylinders, whose formula does not look at y. */
export function coarseAroundAxis(s: Scratch): CoarsePass {
  const { index, x: xs, z: zs, ex: exs, ez: ezs, doubtful, unsettled, count } = s;
  const { A: As, slope: slopes, half: halves, near, far, slack } = s;
  return (lattice, { Ex, Ez, dx, dz }, { t0, t1 }, from, to) => {
    const Cx = lattice[AT_LATTICE.Cx] as number;
    const Cz = lattice[AT_LATTICE.Cz] as number;
    const rho = lattice[AT_LATTICE.rho] as number;
    const smallest = lattice[AT_LATTICE.smallest] as number;
    const largestDirection = lattice[AT_LATTICE.largestDirection] as number;
    const smallestDirection = lattice[AT_LATTICE.smallestDirection] as number;
    const clearly = ROUGH_BOUNDS[0] as number;
    const certain = ROUGH_BOUNDS[1] as number;
    const slackA = ROUGH_BOUNDS[3] as number;
    const slack0 = ROUGH_BOUNDS[4] as number;
    const farther = ROUGH_BOUNDS[5] as number;
    let hits = 0;
    let doubts = 0;
    let close = 0;
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
      const D = b * b - A * (wide - rho);
      const Cm = wide + rho;
      const Q = A * Cm;
      const fits = A > smallestDirection && A < largestDirection;
      const clear = D > clearly * Q + smallest && fits;
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
        const remote = b * b > farther * D;
        if (remote) doubtful[doubts++] = i;
        else unsettled[close++] = i;
      }
    }
    count[HITS] = hits;
    count[DOUBTS] = doubts;
    count[UNSETTLED] = close;
  };
}
