import type { Quadric } from '../../batch/quadric.ts';
import { SPLITTER as HALVES, productError, sumError } from '../../float/eft.ts';
import type { CurvedDetails, Hit, Intersection, Sign } from '../../intersection.ts';
import { lazily } from '../../lazily.ts';
import type { Ray } from '../../ray.ts';
import { createFound, type Found, T0, T1 } from './found.ts';
import { AT_SCALED, BOX, type CertifiedQuadric, FAITHFUL_ONCE } from './numbers.ts';
import { findRoots } from './one-ray.ts';

/** What the passes of this file hand to each other, and where in it each number is. */
export type Grid = Float64Array;

/** A `Grid` of zeros. */
export const createGrid = (): Grid => new Float64Array(33);

/** A, b = B/2, C and D/4, rounded, and what b and D/4 are more than that. */
export const GRID_A = 0;
export const GRID_B = 1;
export const GRID_C = 2;
export const GRID_D = 3;
export const GRID_B_LOW = 4;
export const GRID_D_LOW = 5;
/** A in 26 bits, and the rest of it; 1/A. */
export const GRID_A_HEAD = 6;
export const GRID_A_REST = 7;
export const GRID_OVER_A = 8;
/** √D/4 with the sign of A, and what it is more than that. */
export const GRID_ROOT = 9;
export const GRID_ROOT_LOW = 10;
/** |d|, |E − C| and their like, and the error of D/4: see below. */
export const GRID_REACH_D = 11;
export const GRID_REACH_P = 12;
export const GRID_OFF_D = 13;
/** d, its part on the grid and the rest; E in two parts likewise; how far a point may be off. */
export const GRID_DX = 14;
export const GRID_DY = 15;
export const GRID_DZ = 16;
export const GRID_XH = 17;
export const GRID_YH = 18;
export const GRID_ZH = 19;
export const GRID_XL = 20;
export const GRID_YL = 21;
export const GRID_ZL = 22;
export const GRID_EXH = 23;
export const GRID_EYH = 24;
export const GRID_EZH = 25;
export const GRID_EXL = 26;
export const GRID_EYL = 27;
export const GRID_EZL = 28;
export const GRID_OFF_X = 29;
export const GRID_OFF_Y = 30;
export const GRID_OFF_Z = 31;
/** What cuts t. */
export const GRID_CUT_T = 32;

/*
 * A, b = B/2, C and D/4 = b² − AC, each as a double and a small rest, for a ray and a shape in the
 * box. x = xh + xl with xh = (x + σ) − σ and σ = 2^27 S, S ≥ Σ|x|: xh is a whole multiple of a
 * power of two g ≥ 2^-26 S, Σ|xh| ≤ (2^26 + 4) g, and |xl| ≤ hS, h = 2^-26, exactly (refined.ts).
 * So sums of three squares or products of such parts are below 2^53 of their units and exact, and
 * only what has an xl in it is rounded, by uh a time; η = 2^-77 = 4uh.
 *
 *   quantity            bound          reason
 *   D = |dx| + |dz| + w|dy|, P = |px| + |pz| + w|py|: S of the grids; w = max(1, k), so that k y is
 *                                      counted, too
 *   pl of p = E − C     ≤ hP, off uhP  (p − ph) + (what E − C lost), rounded once
 *   yl of k y           ≤ 3hS, off     y in 26 bits y1 and the rest, k1 y1 exact, its part beyond
 *                       8uhS, of p     the grid h, k1(y − y1) and k2 y h of k|y| each, k2 off by uh
 *                       9uhP           k: 1 + 1 + 1, sums 2 + 3; for p, what E − C lost is one
 *                                      rounding of h more
 *   A                   37uh D²        xl(x + xh) 2 + 2; y, the most: 2·8, yh + yl + yh times yl
 *                                      3·(1 + 2), the product 6, the last sum 6
 *   b                   38uh DP        of y: yh pl 9 + 3, yl p 8 + 3 + 3, their sum 6, the last sum
 *                                      6
 *   C                   46uh P²        of y: 2·9, p + ph times pl 3·(1 + 2), the product 6, the
 *                                      last two sums 6 each; C0 − ρ is split without loss but for
 *                                      u² of ρ, which C is near where that is far above P²
 *   D/4 = b² − AC       12uh (b² +     with 26-bit heads bt, At, Ct: bt² − At Ct without loss, what
 *                       |AC|), and     has a rest in it; and 2|b|δb + |A|δC + |C|δA
 *                       inherited
 *
 * ERROR = 48uh for all of them, and for 2|b|DP + |A|P² + |C|D²: the tests have the sums. hi + lo is
 * sorted without a comparison (Fast2Sum): where a number passes the test of gridQuadric, it is
 * 2^-20 of its bound's scale at least, and the second summand below 2^-23 of that.
 */
/** Bound of the table, 48uh, for A, b, C and D/4. */
export const ERROR = 12 * 2 ** -77;
/** (x + CUT·S) − CUT·S cuts x to the grid of S. */
export const CUT = 2 ** 27;

/** Puts A, b, C, D/4 and their bounds for a ray into the grid; `numbers` by AT_SCALED. */
export type CoefficientsPass = (numbers: Float64Array, ray: Ray) => void;

/**
 * A closure over its scratch and constants, as in units.ts, and in one piece: a call that is
 * not inlined boxes its doubles.
 */
export function coefficientsPass(grid: Grid): CoefficientsPass {
  const NUMBER = AT_SCALED;
  const GRID = CUT;
  const SPLITTER = HALVES;
  const BOUND = ERROR;
  return (numbers, { origin: E, direction: d }) => {
    const k = numbers[NUMBER.k] as number;
    const sign = numbers[NUMBER.sign] as number;
    const rho = numbers[NUMBER.rho] as number;
    const wide = numbers[NUMBER.wide] as number;
    const Cx = numbers[NUMBER.Cx] as number;
    const Cz = numbers[NUMBER.Cz] as number;
    const x = d[0];
    const y = d[1];
    const z = d[2];
    const ex = E[0];
    const ey = E[1];
    const ez = E[2];
    // A shape that does not look at y has k = 0; so has a hyperboloid with a = 0.
    const Cy = k === 0 ? ey : (numbers[NUMBER.Cy] as number);
    const px = ex - Cx;
    const py = ey - Cy;
    const pz = ez - Cz;
    const reachD = Math.abs(x) + Math.abs(z) + wide * Math.abs(y);
    const reachP = Math.abs(px) + Math.abs(pz) + wide * Math.abs(py);
    const cutD = GRID * reachD;
    const cutP = GRID * reachP;
    const xh = x + cutD - cutD;
    const xl = x - xh;
    const zh = z + cutD - cutD;
    const zl = z - zh;
    const onGrid = y + cutD - cutD;
    const pxh = px + cutP - cutP;
    const pxl = px - pxh + sumError(ex, -Cx, px);
    const pzh = pz + cutP - cutP;
    const pzl = pz - pzh + sumError(ez, -Cz, pz);
    const k1 = numbers[NUMBER.k1] as number;
    const k2 = numbers[NUMBER.k2] as number;
    let big = SPLITTER * y;
    const y1 = big - (big - y);
    const rise = k1 * y1;
    const yh = rise + cutD - cutD;
    const yl = rise - yh + (k1 * (y - y1) + k2 * y);
    big = SPLITTER * py;
    const p1 = big - (big - py);
    const above = k1 * p1;
    const ph = above + cutP - cutP;
    const pl = above - ph + (k1 * (py - p1 + sumError(ey, -Cy, py)) + k2 * py);
    const p = ph + pl;
    const sh = sign * yh;
    const sl = sign * yl;

    const A0 = xh * xh + zh * zh - sh * yh;
    const A1 = xl * (x + xh) + zl * (z + zh) - sl * (yh + yl + yh);
    const A = A0 + A1;
    const Al = A1 - (A - A0);
    const b0 = xh * pxh + zh * pzh - sh * ph;
    const b1 = xh * pxl + xl * px + (zh * pzl + zl * pz) - (sh * pl + sl * p);
    const b = b0 + b1;
    const bl = b1 - (b - b0);
    const wideC = pxh * pxh + pzh * pzh - sign * (ph * ph);
    const C0 = wideC - rho;
    const C1 =
      pxl * (px + pxh) +
      pzl * (pz + pzh) -
      sign * (pl * (p + ph)) +
      (sumError(wideC, -rho, C0) - (numbers[NUMBER.rhoLow] as number));
    const C = C0 + C1;
    const Cl = C1 - (C - C0);

    big = SPLITTER * A;
    const At = big - (big - A);
    const Ar = A - At + Al;
    big = SPLITTER * C;
    const Ct = big - (big - C);
    const Cr = C - Ct + Cl;
    big = SPLITTER * b;
    const bt = big - (big - b);
    const br = b - bt + bl;
    const bb = bt * bt;
    const AC = At * Ct;
    const D0 = bb - AC;
    const D1 = sumError(bb, -AC, D0) + (br * (b + bt) - (At * Cr + Ar * C));
    const D = D0 + D1;
    grid[GRID_A] = A;
    grid[GRID_B] = b;
    grid[GRID_C] = C;
    grid[GRID_D] = D;
    grid[GRID_B_LOW] = bl;
    grid[GRID_D_LOW] = D1 - (D - D0);
    grid[GRID_A_HEAD] = At;
    grid[GRID_A_REST] = Ar;
    grid[GRID_REACH_D] = reachD;
    grid[GRID_REACH_P] = reachP;
    grid[GRID_OFF_D] =
      BOUND *
      (2 * Math.abs(b) * reachD * reachP +
        Math.abs(A) * reachP * reachP +
        Math.abs(C) * reachD * reachD);
    grid[GRID_DX] = x;
    grid[GRID_DY] = y;
    grid[GRID_DZ] = z;
    grid[GRID_XH] = xh;
    grid[GRID_YH] = onGrid;
    grid[GRID_ZH] = zh;
    grid[GRID_XL] = xl;
    grid[GRID_YL] = y - onGrid;
    grid[GRID_ZL] = zl;
  };
}

/*
 * Points and normals of two hits, from the double t that is certified for each. A t* + b ± √(D/4) =
 * 0 gives t* = t − (A t + b ± √(D/4))/A: no more than that remainder is needed, and not exactly. L
 * = |E|₁ + max|t| D, T = L/D ≥ |t|; D, P, h, η and the grids are those above, uh = η/4.
 *
 *   quantity            bound          reason
 *   √(D/4)              δD/2s + 2uh s  D − sh² exact, (s − sh)(s + sh) 2 roundings of 2h D/4, the
 *                                      linear step
 *   t = th + tl         exact          grid 2^27 T: th ≤ (2^26 + 1/2) units, |tl| ≤ hT
 *   A t + b ± √         13uh |A|T      At th is exact, its sum with b is split without loss, ±√
 *                                      takes away all but 2h |A|T of it: that rounding 2, At tl 1,
 *                                      Ar 1, times t 1, three sums 2 each, and √'s own 2
 *   δ = t* − t          offT           by what A, b and √ are off, over A: 37uh DL, and 38uh DP
 *                                      with √'s own 2uh |b|, by ERROR; and δD/2s
 *   X = eh + th xh      exact          th xh is a multiple of a power of two ≥ 2^-52 L, eh of one
 *                                      that is, too, their sum below 2^53 of them
 *   low = el + th xl    20uh L +       13, 1 (tl + δ) + 1 (times dx) + 1 (th xl) + 2 + 2 (sums)
 *   + (tl + δ) dx       |dx| offT
 *   n = (X − C) + low   2uh L, and     the difference split without loss, |low| ≤ 2h L; y: a hi +
 *                       what low is    lo, times that, 8u²|ny| more
 *
 * POINT = 24uh for all of it: the tests have the sums. A coordinate X + low is rounded once:
 * faithful, and itself where it is a double, if it was off by less than u|x|/2; FAITHFUL_ONCE
 * leaves a tenth. Where d has no component, X + low is E's own. A normal's component likewise,
 * which is more than is promised of its direction: one that is exactly zero would come out as
 * something like 1e-23, and the next scale of the same ray might say otherwise.
 */
/** Bound of the table, 24uh, on a point in L. */
export const POINT = 6 * 2 ** -77;
/** What cuts t and E to their grids, in T and L. */
export const CUT_TIME = 2 ** 27;
export const CUT_ORIGIN = 2 ** 2;

/** Once `found` holds the roots. */
export type RootsPass = (ray: Ray) => void;
/**
 * The hit at root `k` of `found`, `turn` 1 for the near and −1 for the far one; null where a
 * coordinate, or the way of the normal, stays open.
 */
export type PlacePass = (numbers: Float64Array, k: number, turn: number) => Hit | null;

/** √D/4 and what is common to both hits. */
export function rootsPass(grid: Grid, found: Found): RootsPass {
  const SPLITTER = HALVES;
  const GRID_T = CUT_TIME;
  const GRID_E = CUT_ORIGIN;
  const BOUND = ERROR;
  const BOUND_POINT = POINT;
  return ({ origin: E }) => {
    const A = grid[GRID_A] as number;
    const D = grid[GRID_D] as number;
    const reachD = grid[GRID_REACH_D] as number;
    const reachP = grid[GRID_REACH_P] as number;
    const dx = grid[GRID_DX] as number;
    const dy = grid[GRID_DY] as number;
    const dz = grid[GRID_DZ] as number;
    const ex = E[0];
    const ey = E[1];
    const ez = E[2];
    const s = Math.sqrt(D);
    const overTwo = 0.5 / s;
    const big = SPLITTER * s;
    const sh = big - (big - s);
    const low = (D - sh * sh - (s - sh) * (s + sh) + (grid[GRID_D_LOW] as number)) * overTwo;
    const overA = 1 / A;
    const t = Math.max(Math.abs(found[T0] as number), Math.abs(found[T1] as number));
    const reach = Math.abs(ex) + Math.abs(ey) + Math.abs(ez) + t * reachD;
    const cut = GRID_E * reach;
    const exh = ex + cut - cut;
    const eyh = ey + cut - cut;
    const ezh = ez + cut - cut;
    const off = BOUND_POINT * reach;
    const offT =
      Math.abs(overA) *
      (BOUND * (reachD * (reach + reachP)) + (grid[GRID_OFF_D] as number) * overTwo);
    grid[GRID_OVER_A] = overA;
    grid[GRID_ROOT] = A > 0 ? s : -s;
    grid[GRID_ROOT_LOW] = A > 0 ? low : -low;
    grid[GRID_EXH] = exh;
    grid[GRID_EYH] = eyh;
    grid[GRID_EZH] = ezh;
    grid[GRID_EXL] = ex - exh;
    grid[GRID_EYL] = ey - eyh;
    grid[GRID_EZL] = ez - ezh;
    grid[GRID_OFF_X] = dx === 0 ? 0 : off + offT * Math.abs(dx);
    grid[GRID_OFF_Y] = dy === 0 ? 0 : off + offT * Math.abs(dy);
    grid[GRID_OFF_Z] = dz === 0 ? 0 : off + offT * Math.abs(dz);
    grid[GRID_CUT_T] = GRID_T * (reach / reachD);
  };
}

/** The pass that makes a hit of a root, after `rootsPass`. */
export function placePass(grid: Grid, found: Found): PlacePass {
  const NUMBER = AT_SCALED;
  const SURE = FAITHFUL_ONCE;
  return (numbers, k, turn) => {
    const t = found[k] as number;
    const cut = grid[GRID_CUT_T] as number;
    const th = t + cut - cut;
    const tl = t - th;
    const At = grid[GRID_A_HEAD] as number;
    const b = grid[GRID_B] as number;
    const p = At * th;
    const v = p + b;
    const bPart = v - p;
    const residual =
      v +
      turn * (grid[GRID_ROOT] as number) +
      (p -
        (v - bPart) +
        (b - bPart) +
        (At * tl + (grid[GRID_A_REST] as number) * t) +
        ((grid[GRID_B_LOW] as number) + turn * (grid[GRID_ROOT_LOW] as number)));
    const rest = tl - residual * (grid[GRID_OVER_A] as number);
    const X = (grid[GRID_EXH] as number) + th * (grid[GRID_XH] as number);
    const Y = (grid[GRID_EYH] as number) + th * (grid[GRID_YH] as number);
    const Z = (grid[GRID_EZH] as number) + th * (grid[GRID_ZH] as number);
    const lowX =
      (grid[GRID_EXL] as number) +
      (th * (grid[GRID_XL] as number) + rest * (grid[GRID_DX] as number));
    const lowY =
      (grid[GRID_EYL] as number) +
      (th * (grid[GRID_YL] as number) + rest * (grid[GRID_DY] as number));
    const lowZ =
      (grid[GRID_EZL] as number) +
      (th * (grid[GRID_ZL] as number) + rest * (grid[GRID_DZ] as number));
    const pointX = X + lowX;
    const pointY = Y + lowY;
    const pointZ = Z + lowZ;
    const a = numbers[NUMBER.flare] as number;
    const Cx = numbers[NUMBER.Cx] as number;
    const Cz = numbers[NUMBER.Cz] as number;
    const awayX = X - Cx;
    const awayZ = Z - Cz;
    const normalX = awayX + (sumError(X, -Cx, awayX) + lowX);
    const normalZ = awayZ + (sumError(Z, -Cz, awayZ) + lowZ);
    let normalY = 0;
    if (a !== 0) {
      const Cy = numbers[NUMBER.Cy] as number;
      const awayY = Y - Cy;
      const rise = sumError(Y, -Cy, awayY) + lowY;
      const above = awayY + rise;
      const down = a * above;
      const rest = a * (rise - (above - awayY)) + (numbers[NUMBER.flareLow] as number) * above;
      normalY = 0 - (down + (productError(a, above, down) + rest));
    }
    const offX = grid[GRID_OFF_X] as number;
    const offY = grid[GRID_OFF_Y] as number;
    const offZ = grid[GRID_OFF_Z] as number;
    const settled =
      offX <= SURE * Math.abs(pointX) &&
      offY <= SURE * Math.abs(pointY) &&
      offZ <= SURE * Math.abs(pointZ) &&
      offX <= SURE * Math.abs(normalX) &&
      Math.abs(a) * offY <= SURE * Math.abs(normalY) &&
      offZ <= SURE * Math.abs(normalZ);
    if (!settled) return null;
    return {
      t,
      point: [pointX, pointY, pointZ],
      normal: [normalX, normalY, normalZ],
      singular: false,
    };
  };
}

/*
 * One ray against a curved shape in one go, by parts on grids: class, A, B, C, D, points and
 * normals to some 75 bits, which settles 99 of 100 rays of a picture in half the time of
 * plainQuadric with its 106 bits. The roots are the batch's own. Null for the rest, and beyond
 * the box.
 *
 * D > 0 within its bound makes two hits, if A ≠ 0 is certain; a coordinate is not, where A is not,
 * so that A's test only saves the roots. D and P are above 1/BOX, |A| ≥ 2^-20 D², and so on, where
 * they pass, and D/4 ≥ 2^-38 D²P²: the filter of the batch kernels would have been sure of that.
 * What underflows (2^-1074, times factors of the box) is far below η of any of the scales. What
 * overflows makes D/4's bound infinite, or D/4 NaN by its splitting, and both fail a comparison; so
 * does the NaN of a root that is not there.
 */
const signOf = (x: number): Sign => (x > 0 ? 1 : -1);

type Answer = (q: Quadric, c: CertifiedQuadric, ray: Ray) => Intersection | null;

/** The answer for one ray and a curved shape, by grids; null if a bound is not met. */
export const gridQuadric: Answer = (q, c, ray) => ownGrids()(q, c, ray);
const ownGrids = lazily(onGrids);

function onGrids(): Answer {
  const grid = createGrid();
  const putCoefficients = coefficientsPass(grid);
  const found = createFound();
  const putRoots = rootsPass(grid, found);
  const hitAt = placePass(grid, found);
  const BOUND = ERROR;
  const SURE = FAITHFUL_ONCE;
  const SMALL = 1 / BOX;
  return (q, c, ray) => {
    if (!c.inBox) return null;
    putCoefficients(c.numbers, ray);
    const A = grid[GRID_A] as number;
    const b = grid[GRID_B] as number;
    const C = grid[GRID_C] as number;
    const D = grid[GRID_D] as number;
    const reachD = grid[GRID_REACH_D] as number;
    const reachP = grid[GRID_REACH_P] as number;
    const both = reachD * reachP;
    const sure =
      BOUND * (reachD * reachD) <= SURE * Math.abs(A) &&
      BOUND * both <= SURE * Math.abs(b) &&
      BOUND * (reachP * reachP) <= SURE * Math.abs(C) &&
      (grid[GRID_OFF_D] as number) <= SURE * Math.abs(D) &&
      reachD > SMALL &&
      reachP > SMALL;
    if (!sure) return null;
    const details: CurvedDetails = {
      family: 'curved',
      A,
      B: 2 * b,
      C,
      D: 4 * D,
      signs: { A: signOf(A), B: signOf(b), C: signOf(C), D: signOf(D) },
    };
    if (D < 0)
      return { class: 'none', hits: [], method: 'certified', decidedBy: 'filter', details };
    findRoots(q, ray, found, c);
    putRoots(ray);
    const near = hitAt(c.numbers, T0, 1);
    const far = near && hitAt(c.numbers, T1, -1);
    return (
      far && { class: 'two', hits: [near, far], method: 'certified', decidedBy: 'filter', details }
    );
  };
}
