import type { Answers, Rays } from '../../batch/batch.ts';
import { SPLITTER } from '../../float/eft.ts';
import { LEAST_A } from './moment-bound.ts';
import { BOX } from './scaled-quadric.ts';

/*
 * Rays that come from far away or graze the shape: both roots lie close together, so the origin is moved to a short t between
 * them, and the closed form there needs no more than double precision: t + (−b' ∓ √D')/A with q = p + t d, b' = q·d, f = q·q − ρ
 * and D' = b'² − A f, which is D/4. What cancels is q, b' and f, and these are taken on grids. (x + σ) − σ is x rounded to a whole
 * multiple of ulp(σ)/2; for |x| ≤ S and σ = 2^m S what is left over is ≤ 2^(m−52) S, exactly (Rump, Ogita, Oishi 2008).
 *
 * The grids of refined.ts, with t itself on its grid: for the reach L = |t||d|₁ + |p|₁ and W = |q|₁ + L,
 *   |δq| ≤ 2^-71 L in all;  |δf| ≤ 2^-69 W Q + 2u|f|, Q = |q|₁ of the leading parts + 2^-22 W: what is left over of
 *   q is ≤ 2^-23 L in each coordinate and all of it where the leading parts are 0, so 2|q||δq| has 2^-91.4 L² more;
 *   b' = Σ qh dh (exact: 26 by 25 bits) + Σ (ql d + qh dl): |ql| ≤ 2^-21 W and dl ≤ 2^-23 |d|₁ lose 2^-74 W|d|₁ at each of up to six
 *   operations, and δq·d 2^-71 L|d|₁:     |δb'| ≤ 2^-70 W|d|₁ + u|b'|;
 *   A: y 3u, so Y² 7u, sums:              |δA| ≤ 9u|d|₁²;
 *   D': 2|b'||δb'|, |A||δf|, |f||δA| and 2u of both terms:
 *                                         |δD'| ≤ |b'|(2^-68 W|d|₁ + 6u|b'|) + |d|₁²(2^-68 W Q + 14u|f|).
 * With D' > 2|δD'| the root is off by |δD'|/(1.7√D') and u√D'; so each
 *   t is off by (2^-70 W|d|₁ + 0.6|δD'|/√D' + u(|b'| + √D')(9|d|₁²/|A| + 8))/|A|
 * before its only rounding, and faithful when that is below u|t|/2.
 */
const GRID_25 = 2 ** 29;
const GRID_26 = 2 ** 28;
const GRID_P = 2 ** 6;
const CROSS_ERROR = 2 ** -68;
const SQUARE_ERROR = 6 * 2 ** -53;
const RESIDUAL_ERROR = 14 * 2 ** -53;
const SLOPE_ERROR = 2 ** -70;
const CLOSED_A = 9 * 2 ** -53;
const CLOSED = 8 * 2 ** -53;
const FAITHFUL = 0.9 * 2 ** -54;
/** Where the parts of the bound underflow: inside the box nothing that matters is smaller. */
const SMALLEST_D = 2 ** -200;

/** CROSS_ERROR has 2^-68 for 2^-69, so of the 2^-22 in Q half is enough. */
const NARROW = 2 ** -23;

/** The loops take their bounds from here: of a module's constants a bundler makes variables, which V8 looks up at each use. */
export const BOUNDS = Float64Array.of(
  ...[GRID_25, GRID_26, GRID_P, SPLITTER, CROSS_ERROR, SQUARE_ERROR, RESIDUAL_ERROR, SLOPE_ERROR],
  ...[CLOSED_A, CLOSED, FAITHFUL, SMALLEST_D, LEAST_A, BOX, NARROW],
);

/** Settles what it can of the `count` rays at `places`, moves the others to the front and returns how many these are. */
export type RecentredPass = (
  numbers: Float64Array,
  rays: Rays,
  out: Answers,
  places: Int32Array,
  count: number,
) => number;
