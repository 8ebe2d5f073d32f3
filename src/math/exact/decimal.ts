import type { Dyadic } from './dyadic.ts';
import { isqrt } from './isqrt.ts';
import { neg, type Surd, sign, toNumber } from './surd.ts';

/**
 * ± 0.d₁d₂… · 10^(exponent + 1): `digits` has its decimal point behind the first digit. Zero has
 * one digit, 0.
 */
interface Decimal {
  readonly negative: boolean;
  readonly digits: string;
  readonly exponent: number;
}

/**
 * The first n significant decimal digits of a, rounded to nearest, a half away from zero: all of
 * them are right, however many.
 *
 * @param a a number of any unit.
 * @param n how many: a whole number from 1 on.
 * @example
 * decimalDigits(fromNumber(0.1), 20);
 * // → { negative: false, digits: '10000000000000000555', exponent: -1 }
 */
export function decimalDigits(a: Surd, n: number): Decimal {
  const side = sign(a);
  if (side === 0) return { negative: false, digits: '0', exponent: 0 };
  const size = side < 0 ? neg(a) : a;
  let places = n - guessExponent(toNumber(size));
  let whole = scaledFloor(size, places);
  // Beyond the doubles the guess is only where to begin.
  while (whole.length <= n) {
    places += whole === '0' ? 2 * n + 300 : n + 1 - whole.length;
    whole = scaledFloor(size, places);
  }
  const exponent = whole.length - 1 - places;
  const rounded = String(BigInt(whole.slice(0, n)) + (whole.charAt(n) >= '5' ? 1n : 0n));
  // 9.99… may become 10.00…
  const longer = rounded.length - n;
  return { negative: side < 0, digits: rounded.slice(0, n), exponent: exponent + longer };
}

const guessExponent = (x: number): number =>
  x > 0 && Number.isFinite(x) ? Math.floor(Math.log10(x)) : 0;

const shifted = ({ m, e }: Dyadic, to: number): bigint => m << BigInt(e - to);

/**
 * floor(a · 10^places) for a > 0, exactly. Over one power of two, a = (U ± √S)/W in whole numbers,
 * and floor(x/W) = floor(floor(x)/W) for W ≥ 1, so the whole part of the root is all that is needed
 * of it.
 */
function scaledFloor({ u, v, w, D }: Surd, places: number): string {
  const squareExponent = 2 * v.e + D.e;
  const unit = Math.min(u.e, Math.floor(squareExponent / 2), w.e);
  const flip = w.m < 0n ? -1n : 1n;
  const up = places > 0 ? 10n ** BigInt(places) : 1n;
  const W = flip * shifted(w, unit) * (places < 0 ? 10n ** BigInt(-places) : 1n);
  const U = flip * shifted(u, unit) * up;
  const S = shifted({ m: v.m * v.m * D.m, e: squareExponent }, 2 * unit) * up * up;
  const root = isqrt(S);
  const down = flip * v.m < 0n;
  const top = down ? U - root - (root * root < S ? 1n : 0n) : U + root;
  return String(top / W);
}
