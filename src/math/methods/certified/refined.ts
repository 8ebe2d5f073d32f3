import type { Answers, Rays } from '../../batch/batch.ts';
import { SPLITTER } from '../../float/eft.ts';
import { LEAST_A, MOMENT_ERROR, RHO_ERROR, SMALLEST_D, SQUARE_ERROR } from './class.ts';
import { AT_SCALED, BOX, FAITHFUL, GRID_25, GRID_26, GRID_P } from './numbers.ts';

/*
 * Each root by a step from a rough one with all its 53 bits. That is slower than the stages before
 * it, and what remains is the few rays that these leave because a root lies near 0 or the numbers
 * are not ordinary. First it must be a clear hit, by the bound of class.ts:
 *
 *   quantity      bound              reason
 *   √D            2^-18 of it        D > 2^17 δD
 *   rough roots   2^-7 √D/|A|        D > 2^-84 S²: b's rounding error, ≤ 8uS = 2^-50 S, and t's are
 *                                    below 2^-7 √D, so each is nearer to its own root
 *   A             2^-30 of it        |A| > 2^-20 Am, known to 6u·2^20; so A ≠ 0
 */
/** D is a clear hit above this many bounds of D, and above APART of S². */
export const CLEAR_REFINED = 2 ** 17;
export const APART = 2 ** -84;

/*
 * Then Newton's step on grids. (x + σ) − σ is x rounded to a whole multiple of g = ulp(σ)/2; for
 * |x| ≤ S and σ = 2^m S it has |x|/g < 2^(54−m) and what is left over is ≤ 2^(m−52) S, exactly
 * (Sterbenz; Rump, Ogita, Oishi 2008 call it ExtractVector).
 *
 * For each rough root t let L = |t||d|₁ + |p|₁ be its reach, T = L/|d|₁ and w = 2^-75 L. d = dh +
 * dl and t = th + tl are on grids for |d|₁ and T (m = 29: 25 bits), p = ph + pl on one for both
 * reaches together (m = 6), and q = qh + ql on one for Sq = |q|₁ of the leading parts (m = 28: 26
 * bits). W = Sq + L, Q = Sq + 2^-20.3 W.
 *
 *   quantity                 bound              reason
 *   q = p + t d              (ph + th dh) + (th dl + tl d + pl)
 *   ph + th dh               exact              th dh is a multiple of G ≥ 2^-50 L with ≤ 2^50
 *                                               units, ph (grid > 2^-48 L) of G, too; together
 *                                               ≤ 2L < 2^53 G
 *   th dl + tl d + pl        ≤ 2^-21 L          each coordinate
 *     x, z                   3w each            th·dl ½, tl·d ½, their sum 1, + pl 1
 *     y                      10w                dl ¾, k·dy's rounding ½ more, pl: k·(p's lower
 *                                               half) 1¾ + 1, a larger sum 2
 *   pl                       ≤ 2^-46 of both    its rounding, 2^-99 of them, is negligible as long
 *                            reaches            as they are ≤ 2^20 |p|₁ ≤ 2^20 L: SPREAD
 *   q in all                 16w = 2^-71 L
 *   fh = qxh² + qzh² ∓ qyh²  exact              ≤ 2^52 units, partial sums too
 *   fh − ρ                   u|fh|              the result is small
 *   ql                       ≤ 2^-21 W          2^-24 Sq + 2^-22 L + 2^-45 L; where Sq is 0 that is
 *                                               all there is of q: |q|₁ ≤ Q
 *   Σ ql(2qh + ql)           8 · 2^-73 WQ       ql 1, the bracket 1, the product 1, three sums 3,
 *                                               k's own error 1, fh 1
 *   what q is off, in f      8 · 2^-73 WQ       2^-71 L · 2Q
 *   f                        2^-69 WQ + 2u|f|   together
 *   step f/(2√D̂)             2^-16 of it        from b' = b + A·t, b'² = D/4 + A f exactly, the
 *                                               step is ∓f/(√(D/4 + A f) + √(D/4)): off by |A f|/D
 *                                               ≤ 2^-17, that is STEP_SHARE, √D's 2^-18, rounding
 *   step in all              (2^-69 WQ + 2^-16|f|)/(2√(D/4))
 *
 * The root is faithful when t + δ is rounded once and that is below u|t|/2 (neighbours of t are
 * u|t| apart, at least).
 */
/** Bound of the table on f, in WQ, with room. */
export const RESIDUAL_ERROR = 2 ** -68;
/** RESIDUAL_ERROR has 2^-68 for 2^-69, so of the 2^-20.3 in Q half is enough. */
export const NARROW_REFINED = 2 ** -21;
/** Largest |A f|/D; the step's relative error; largest ratio of both reaches to |p|₁. */
export const STEP_SHARE = 2 ** -17;
export const STEP_ERROR = 2 ** -16;
export const SPREAD = 2 ** 20;

/** What the loop takes before it begins. */
export const AT_REFINED = {
  grid25: 0,
  grid26: 1,
  gridOfP: 2,
  splitter: 3,
  residualError: 4,
  stepError: 5,
  faithful: 6,
  spread: 7,
  step: 8,
  clearly: 9,
  apart: 10,
  leastA: 11,
  box: 12,
  momentError: 13,
  squareError: 14,
  rhoError: 15,
  smallestD: 16,
  narrow: 17,
} as const;
/** In the order of AT_REFINED. */
export const REFINED_BOUNDS: readonly number[] = [
  GRID_25,
  GRID_26,
  GRID_P,
  SPLITTER,
  RESIDUAL_ERROR,
  STEP_ERROR,
  FAITHFUL,
  SPREAD,
  STEP_SHARE,
  CLEAR_REFINED,
  APART,
  LEAST_A,
  BOX,
  MOMENT_ERROR,
  SQUARE_ERROR,
  RHO_ERROR,
  SMALLEST_D,
  NARROW_REFINED,
];

/**
 * Settles what it can of the `count` rays at `places`, moves the others to the front and returns
 * how many these are. One loop for both kinds of shapes: about an axis y and k are 0. It is long
 * because what it hands on are forty numbers, which a call between two halves would send through
 * memory.
 */
export function refine(
  numbers: Float64Array,
  hasY: boolean,
  { Ex, Ey, Ez, dx, dy, dz }: Rays,
  { t0, t1 }: Answers,
  places: Int32Array,
  count: number,
): number {
  const Cx = numbers[AT_SCALED.Cx] as number;
  const Cy = numbers[AT_SCALED.Cy] as number;
  const Cz = numbers[AT_SCALED.Cz] as number;
  const k = numbers[AT_SCALED.k] as number;
  const k1 = numbers[AT_SCALED.k1] as number;
  const k2 = numbers[AT_SCALED.k2] as number;
  const sign = numbers[AT_SCALED.sign] as number;
  const rho = numbers[AT_SCALED.rho] as number;
  const rhoLow = numbers[AT_SCALED.rhoLow] as number;
  const grid25 = REFINED_BOUNDS[AT_REFINED.grid25] as number;
  const grid26 = REFINED_BOUNDS[AT_REFINED.grid26] as number;
  const gridOfP = REFINED_BOUNDS[AT_REFINED.gridOfP] as number;
  const splitter = REFINED_BOUNDS[AT_REFINED.splitter] as number;
  const residualError = REFINED_BOUNDS[AT_REFINED.residualError] as number;
  const stepError = REFINED_BOUNDS[AT_REFINED.stepError] as number;
  const faithful = REFINED_BOUNDS[AT_REFINED.faithful] as number;
  const spread = REFINED_BOUNDS[AT_REFINED.spread] as number;
  const step = REFINED_BOUNDS[AT_REFINED.step] as number;
  const clearly = REFINED_BOUNDS[AT_REFINED.clearly] as number;
  const apart = REFINED_BOUNDS[AT_REFINED.apart] as number;
  const leastA = REFINED_BOUNDS[AT_REFINED.leastA] as number;
  const box = REFINED_BOUNDS[AT_REFINED.box] as number;
  const momentError = REFINED_BOUNDS[AT_REFINED.momentError] as number;
  const squareError = REFINED_BOUNDS[AT_REFINED.squareError] as number;
  const rhoError = REFINED_BOUNDS[AT_REFINED.rhoError] as number;
  const smallestD = REFINED_BOUNDS[AT_REFINED.smallestD] as number;
  const narrow = REFINED_BOUNDS[AT_REFINED.narrow] as number;
  let left = 0;
  for (let j = 0; j < count; j++) {
    const i = places[j] as number;
    const x = dx[i] as number;
    const dyi = hasY ? (dy[i] as number) : 0;
    const z = dz[i] as number;
    const ex = Ex[i] as number;
    const ey = hasY ? (Ey[i] as number) : Cy;
    const ez = Ez[i] as number;
    // p = fl(E − C) and what it lost (Knuth's TwoSum).
    const px = ex - Cx;
    const py = ey - Cy;
    const pz = ez - Cz;
    const vx = px - ex;
    const vy = py - ey;
    const vz = pz - ez;
    const lostX = ex - (px - vx) - (Cx + vx);
    const lostY = ey - (py - vy) - (Cy + vy);
    const lostZ = ez - (pz - vz) - (Cz + vz);
    // k·dy and k·py: an exact leading product of 26 by 26 bits, and the rest.
    const bigD = splitter * dyi;
    const topD = bigD - (bigD - dyi);
    const leadD = k1 * topD;
    const restD = k1 * (dyi - topD) + k2 * dyi;
    const y = leadD + restD;
    const bigP = splitter * py;
    const topP = bigP - (bigP - py);
    const leadP = k1 * topP;
    const restP = k1 * (py - topP) + k2 * py + k * lostY;

    const Sd = Math.abs(x) + Math.abs(y) + Math.abs(z);
    const Sp = Math.abs(px) + Math.abs(leadP) + Math.abs(pz);
    const pk = k * py;
    const mx = y * pz - z * pk;
    const my = z * px - x * pz;
    const mz = x * pk - y * px;
    const round = x * x + z * z;
    const yy = y * y;
    const A = round - sign * yy;
    const D = rho * A + sign * (mx * mx + mz * mz) - my * my;
    const S = Sd * Sp;
    const Am = round + yy;
    const M = Math.abs(mx) + Math.abs(my) + Math.abs(mz);
    const error = S * (momentError * M + squareError * S) + rhoError * (rho * Am) + smallestD;
    const inside = Sd < box && Sd * box > 1 && Sp < box;
    const clear = D > clearly * error && inside && D > apart * (S * S) && Math.abs(A) > leastA * Am;
    if (!clear) {
      places[left++] = i;
      continue;
    }
    const slope = x * px + z * pz - sign * (y * pk);
    const s = Math.sqrt(D);
    const As = A * s;
    const inverse = 1 / (As * Sd);
    const overA = inverse * (s * Sd);
    const ta = (-slope - s) * overA;
    const tb = (s - slope) * overA;
    const half = 0.5 * inverse * (A * Sd);
    const over = inverse * As;
    const reachA = Math.abs(ta) * Sd + Sp;
    const reachB = Math.abs(tb) * Sd + Sp;
    const gridD = grid25 * Sd;
    const gridA = grid25 * (over * reachA);
    const gridB = grid25 * (over * reachB);
    const gridP = gridOfP * (reachA + reachB);
    const xh = x + gridD - gridD;
    const yh = leadD + gridD - gridD;
    const zh = z + gridD - gridD;
    const xl = x - xh;
    const yl = leadD - yh + restD;
    const zl = z - zh;
    const phx = px + gridP - gridP;
    const phy = leadP + gridP - gridP;
    const phz = pz + gridP - gridP;
    const plx = px - phx + lostX;
    const ply = leadP - phy + restP;
    const plz = pz - phz + lostZ;
    // One root after the other: interleaved, more values are alive than there are registers.
    const tah = ta + gridA - gridA;
    const tal = ta - tah;
    const ax = phx + tah * xh;
    const ay = phy + tah * yh;
    const az = phz + tah * zh;
    const sizeOfA = Math.abs(ax) + Math.abs(ay) + Math.abs(az);
    const gridQA = grid26 * sizeOfA;
    const axh = ax + gridQA - gridQA;
    const ayh = ay + gridQA - gridQA;
    const azh = az + gridQA - gridQA;
    const axl = ax - axh + (tah * xl + tal * x + plx);
    const ayl = ay - ayh + (tah * yl + tal * y + ply);
    const azl = az - azh + (tah * zl + tal * z + plz);
    const fa =
      axh * axh +
      azh * azh -
      sign * (ayh * ayh) -
      rho +
      (axl * (axh + axh + axl) +
        azl * (azh + azh + azl) -
        sign * (ayl * (ayh + ayh + ayl)) -
        rhoLow);
    const tbh = tb + gridB - gridB;
    const tbl = tb - tbh;
    const bx = phx + tbh * xh;
    const by = phy + tbh * yh;
    const bz = phz + tbh * zh;
    const sizeOfB = Math.abs(bx) + Math.abs(by) + Math.abs(bz);
    const gridQB = grid26 * sizeOfB;
    const bxh = bx + gridQB - gridQB;
    const byh = by + gridQB - gridQB;
    const bzh = bz + gridQB - gridQB;
    const bxl = bx - bxh + (tbh * xl + tbl * x + plx);
    const byl = by - byh + (tbh * yl + tbl * y + ply);
    const bzl = bz - bzh + (tbh * zl + tbl * z + plz);
    const fb =
      bxh * bxh +
      bzh * bzh -
      sign * (byh * byh) -
      rho +
      (bxl * (bxh + bxh + bxl) +
        bzl * (bzh + bzh + bzl) -
        sign * (byl * (byh + byh + byl)) -
        rhoLow);
    const ra = ta + fa * half;
    const rb = tb - fb * half;
    const f = Math.abs(fa);
    const g = Math.abs(fb);
    const widthA = sizeOfA + reachA;
    const widthB = sizeOfB + reachB;
    const errorA = half * (residualError * widthA * (sizeOfA + narrow * widthA) + stepError * f);
    const errorB = half * (residualError * widthB * (sizeOfB + narrow * widthB) + stepError * g);
    const settled =
      errorA <= faithful * Math.abs(ra) &&
      errorB <= faithful * Math.abs(rb) &&
      reachA + reachB <= spread * Sp &&
      (f + g) * Math.abs(A) <= step * D;
    if (settled) {
      t0[i] = Math.min(ra, rb);
      t1[i] = Math.max(ra, rb);
    } else places[left++] = i;
  }
  return left;
}
