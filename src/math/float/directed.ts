import { LEAST_EXACT_PRODUCT, productError, squareError, sumError } from './eft.ts';
import { nextDown, nextUp } from './ulp.ts';

/**
 * One operation rounded down or up. JavaScript always rounds to nearest, so the result may have to
 * move one double outwards: it does when the sign of the rounding error says so, and, unlike pbrt's
 * Interval, it stays when there was no error. That is what lets an interval end in exactly 0, and
 * so lets small whole numbers decide "tangent", "parallel", "on the rim". Where the error is not to
 * be had (overflow, or a product near the subnormals) the result moves in any case: that is always
 * safe, since rounding to nearest is never further than the next double.
 *
 * Operands are ends of intervals: ±Infinity is allowed, NaN is not. Of 0·∞ the product is 0 (every
 * number of the interval is finite). A difference ∞ − ∞ bounds nothing: the answer is the infinity
 * on the safe side.
 */

/**
 * u(1 + 2u): |x| times this lies above half of the space from x to its neighbours and below one and
 * a half of it, so adding it rounds to the next double, also where the spacing halves (Rump,
 * Zimmermann, Boldo, Melquiond 2009, Computing predecessor and successor in rounding to nearest).
 * Far from the ends of the range, where it must not round itself.
 */
const STEP = 2 ** -53 * (1 + 2 ** -52);
const LEAST = 2 ** -960;
const MOST = 2 ** 1020;

function above(x: number): number {
  const size = Math.abs(x);
  return size > LEAST && size < MOST ? x + size * STEP : nextUp(x);
}

function below(x: number): number {
  const size = Math.abs(x);
  return size > LEAST && size < MOST ? x - size * STEP : nextDown(x);
}

/**
 * The end given by the rounded result and the sign of (true result − rounded result); NaN: unknown.
 */
function down(rounded: number, error: number): number {
  if (error >= 0) return rounded;
  return Number.isNaN(rounded) ? -Infinity : below(rounded);
}

function up(rounded: number, error: number): number {
  if (error <= 0) return rounded;
  return Number.isNaN(rounded) ? Infinity : above(rounded);
}

export function addDown(a: number, b: number): number {
  const s = a + b;
  return down(s, sumError(a, b, s));
}

export function addUp(a: number, b: number): number {
  const s = a + b;
  return up(s, sumError(a, b, s));
}

/** Exact, or unknown below the range of `productError`. */
function knownProductError(a: number, b: number, p: number): number {
  return Math.abs(p) >= LEAST_EXACT_PRODUCT ? productError(a, b, p) : Number.NaN;
}

export function mulDown(a: number, b: number): number {
  if (a === 0 || b === 0) return 0;
  const p = a * b;
  return down(p, knownProductError(a, b, p));
}

export function mulUp(a: number, b: number): number {
  if (a === 0 || b === 0) return 0;
  const p = a * b;
  return up(p, knownProductError(a, b, p));
}

/**
 * The sign of a/b − q, as a number: that of the remainder a − q·b, over b. q·b rounded is within 2u
 * of a, so their difference is exact (Sterbenz), and what is subtracted from it last is q·b's own
 * error.
 */
function quotientError(a: number, b: number, q: number): number {
  const p = q * b;
  const remainder = a - p - knownProductError(q, b, p);
  return b < 0 ? -remainder : remainder;
}

/** b ≠ 0. */
export function divDown(a: number, b: number): number {
  if (a === 0) return 0;
  const q = a / b;
  return down(q, quotientError(a, b, q));
}

/** b ≠ 0. */
export function divUp(a: number, b: number): number {
  if (a === 0) return 0;
  const q = a / b;
  return up(q, quotientError(a, b, q));
}

/** The sign of √a − s: that of a − s². */
function rootError(a: number, s: number): number {
  const p = s * s;
  return p >= LEAST_EXACT_PRODUCT ? a - p - squareError(s, p) : Number.NaN;
}

/** a ≥ 0. */
export function sqrtDown(a: number): number {
  if (a === 0) return 0;
  const s = Math.sqrt(a);
  return down(s, rootError(a, s));
}

/** a ≥ 0. */
export function sqrtUp(a: number): number {
  if (a === 0) return 0;
  const s = Math.sqrt(a);
  return up(s, rootError(a, s));
}
