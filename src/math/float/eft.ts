/**
 * Error-free transforms: the rounding error of one operation is (but for over- and underflow) a
 * double itself, and a few further operations find it. Each function gets the rounded result and
 * returns what was lost, so that nothing is allocated: `const s = a + b; const e = sumError(a, b,
 * s);` and then a + b = s + e exactly. u = 2^-53.
 *
 * Dekker 1971, A floating-point technique for extending the available precision; Knuth, TAOCP 2,
 * section 4.2.2.
 */

/** 2^27 + 1 cuts 53 bits into 26 and 26 with a sign (Veltkamp). */
export const SPLITTER = 134217729;

/**
 * Products at least this large have an exact error: with a ≥ 2^i, b ≥ 2^j all bits of a·b, and of
 * the four partial products, are multiples of 2^(i + j − 104), and |a·b| ≥ 2^-968 gives i + j ≥
 * -969 > -970, hence multiples of 2^-1074.
 */
export const LEAST_EXACT_PRODUCT = 2 ** -968;

/**
 * a + b − s for s = fl(a + b), of any a and b (Knuth's TwoSum). Exact whenever s is finite, except
 * that the last bits of the range above may overflow on the way (|a| or |b| = MAX_VALUE); a sum
 * never underflows. NaN when s is not finite.
 */
export function sumError(a: number, b: number, s: number): number {
  const bPart = s - a;
  return a - (s - bPart) + (b - bPart);
}

/**
 * a + b − s for s = fl(a + b) and |a| ≥ |b|, or a = 0 (Dekker's Fast2Sum); it suffices that a's
 * last bit is no finer than b's.
 */
export function fastSumError(a: number, b: number, s: number): number {
  return b - (s - a);
}

/**
 * a·b − p for p = fl(a·b) (Dekker's product, since JavaScript has no fused multiply-add). Exact for
 * |a|, |b| < 2^996 and |p| from 2^-968 to 2^1020, or an exact p = 0. Where it ends: above, the
 * splitter's product or a partial product overflows, and the result is NaN; below, each of the
 * partial products may lose 2^-1075, and the result is off by at most 2^-1073.
 */
export function productError(a: number, b: number, p: number): number {
  const aBig = SPLITTER * a;
  const aHigh = aBig - (aBig - a);
  const aLow = a - aHigh;
  const bBig = SPLITTER * b;
  const bHigh = bBig - (bBig - b);
  const bLow = b - bHigh;
  return aLow * bLow - (p - aHigh * bHigh - aLow * bHigh - aHigh * bLow);
}

/** a² − p for p = fl(a²); the range of `productError`. */
export function squareError(a: number, p: number): number {
  const big = SPLITTER * a;
  const high = big - (big - a);
  const low = a - high;
  return low * low - (p - high * high - 2 * (high * low));
}
