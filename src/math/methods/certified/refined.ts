import { SPLITTER } from '../../float/eft.ts';
import { LEAST_A, MOMENT_ERROR, RHO_ERROR, SMALLEST_D, SQUARE_ERROR } from './moment-bound.ts';
import { BOX } from './scaled-quadric.ts';

/*
 * The bounds of refined-roots.ts: each root by a step from a rough one with all its 53 bits. That is slower than the stages before it, and what remains is the few
 * rays that these leave because a root lies near 0 or the numbers are not ordinary.
 */

/*
 * First it must be a clear hit, by the bound of moment-bound.ts:
 *   D > 2^17 δD                so √D is known to 2^-18;
 *   D > 2^-84 S²               so b's rounding error (≤ 8uS = 2^-50 S) and t's are below 2^-7 √D: each coarse root is nearer to its own root than
 *                              to the other one;
 *   |A| > 2^-20 Am             so A ≠ 0, and A is known to 6u · 2^20 < 2^-30.
 */
const CLEAR = 2 ** 17;
const APART = 2 ** -84;

/*
 * Then Newton's step on grids. (x + σ) − σ is x rounded to a whole multiple of g = ulp(σ)/2; for |x| ≤ S and σ = 2^m S it
 * has |x|/g < 2^(54−m) and what is left over is ≤ 2^(m−52) S, exactly (Sterbenz; Rump, Ogita, Oishi 2008 call it ExtractVector).
 *
 * For each coarse root t let L = |t||d|₁ + |p|₁ be its reach and T = L/|d|₁. With d = dh + dl and t = th + tl on grids for |d|₁ and T (m = 29: 25
 * bits), p = ph + pl on one for both reaches together (m = 6):
 *
 *   q = p + t d = (ph + th dh) + (th dl + tl d + pl),
 *
 * where the first bracket is exact: th dh is a multiple of G ≥ 2^-50 L with ≤ 2^50 units, ph a multiple of G (its grid is
 * > 2^-48 L ≥ G), and both together are ≤ 2L < 2^53 G. Errors in w = 2^-75 L:
 *   x, z:  th·dl ½, tl·d ½, their sum 1, + pl 1;                                                   ≤ 3w each
 *   y:     dl ¾, k·dy's rounding ½ more, and pl: k·(p's lower half) 1¾ + 1, a larger sum 2;        ≤ 10w
 * together ≤ 16w = 2^-71 L, and the second bracket is ≤ 2^-21 L in each coordinate. pl itself is ≤ 2^-46 of both reaches, and its rounding (2^-99
 * of them) negligible as long as they are ≤ 2^20 |p|₁ ≤ 2^20 L: that is SPREAD.
 *
 *   f = qx² + qz² ∓ qy² − ρ: with q = qh + ql on a grid for Sq = |q|₁ of the leading parts (m = 28: 26 bits) the sum of qh² is exact (≤ 2^52 units,
 * partial sums too), subtracting ρ loses u|fh|, since the result is small. Each coordinate of ql is ≤ 2^-24 Sq + 2^-22 L + 2^-45 L, all below 2^-21 W,
 * W = Sq + L. Where Sq is 0 they are all there is of q: |q|₁ ≤ Q = Sq + 2^-20.3 W.
 *   Σ ql(2qh + ql): rounding ql 1, the bracket 1, the product 1, three sums 3, k's own error 1, fh 1, in 2^-73 W Q; what q
 *   itself is off, 2^-71 L · 2Q: 8 of them.  16 · 2^-73 = 2^-69 W Q in all, and 2u|f|.
 *
 * From the coarse root with b' = b + A·t: b'² = D/4 + A f exactly, so the exact step is δ = ∓f/(√(D/4 + A f) + √(D/4)). Taking
 * f/(2√D̂) instead is off by |A f|/D (≤ 2^-17, that is STEP) and by √D's error 2^-18: together with rounding < 2^-16 of |δ|. Hence
 *   |error of the step| ≤ (2^-69 W Q + 2^-16 |f|)/(2√(D/4)),
 * and the root is faithful when t + δ is rounded once and that is below u|t|/2 (neighbours of t are u|t| apart, at least).
 */
const RESIDUAL_ERROR = 2 ** -68;
/** RESIDUAL_ERROR has 2^-68 for 2^-69, so of the 2^-20.3 in Q half is enough. */
const NARROW = 2 ** -21;
const STEP = 2 ** -17;
const STEP_ERROR = 2 ** -16;
const SPREAD = 2 ** 20;
const FAITHFUL = 2 ** -55;

const GRID_25 = 2 ** 29;
const GRID_26 = 2 ** 28;
const GRID_P = 2 ** 6;

/** The loops take their bounds from here: of a module's constants a bundler makes variables, which V8 looks up at each use. */
export const BOUNDS = Float64Array.of(
  ...[GRID_25, GRID_26, GRID_P, SPLITTER, RESIDUAL_ERROR, STEP_ERROR, FAITHFUL, SPREAD, STEP],
  ...[CLEAR, APART, LEAST_A, BOX, MOMENT_ERROR, SQUARE_ERROR, RHO_ERROR, SMALLEST_D, NARROW],
);
