import { MIN_EXPONENT, scale } from '../float/bits.ts';
import { lazily } from '../lazily.ts';
import type { Dyadic, Sign } from './dyadic.ts';
import * as dy from './dyadic.ts';
import { bitLength } from './isqrt.ts';
import { roundScaled } from './round-scaled.ts';
import { hasLeadingBits, sumWithRoot } from './sum-with-root.ts';
import { norm, signOfSum } from './surd-sign.ts';
import type { Surd } from './surd-type.ts';

/** A quotient below has this many bits, or one more: one machine word for BigInt. */
const QUOTIENT_BITS = 62;
const QUOTIENT_TOP = 0x4000000000000000n;
const DOUBLE_BITS = 53;

/** Place k has half of 2^k, for all k that `settled` may drop. */
const HALVES = lazily(() =>
  Array.from({ length: QUOTIENT_BITS + 3 }, (_, k) => (1n << BigInt(k)) >> 1n),
);

/**
 * The double nearest to the surd, ties to even, rounded once, also into the subnormals; ±Infinity
 * beyond. Exact zero is +0; what underflows keeps its sign.
 *
 * 62 bits of the quotient show which two doubles are near. How close to their midpoint a surd can
 * come has no useful bound (and ties happen), so within the quotient's error of a midpoint the
 * exact sign of surd − midpoint decides.
 *
 * @param a of any unit.
 * @returns in the unit of a.
 * @see NUMERICS.md, section 4: correctly rounded.
 * @example
 * toNumber(div(fromNumber(1), fromNumber(3))) === 1 / 3; // → true
 */
export function toNumber(a: Surd): number {
  if (a.v.m === 0n || a.D.m === 0n) return roundRatio(a.u, a.w);
  const sum = sumWithRoot(a.u, a.v, a.D);
  return hasLeadingBits(sum, a.u, a.v, a.D) ? settled(a, sum, a.w) : roundCancelled(a);
}

/**
 * The terms cancel: (u + v√D)/w = (u² − v²D)/(w(u − v√D)), where they do not, and the norm above is
 * exact.
 */
function roundCancelled(a: Surd): number {
  const n = norm(a);
  if (n.m === 0n) return 0;
  return settled(a, n, dy.mul(a.w, sumWithRoot(a.u, dy.neg(a.v), a.D)));
}

const signed = (negative: boolean, x: number): number => (negative ? -x : x);

/**
 * floor(2^k·|n/d|)·2^-k with 62 or 63 bits. If n or d (one of them) is from `sumWithRoot`, hence
 * off by less than a part in 2^63, the true quotient lies within −1…+2 units of this one: 1 is the
 * floor's, and q/2^63 < 1 the sum's.
 */
function quotient(n: Dyadic, d: Dyadic): Dyadic {
  const up = QUOTIENT_BITS - bitLength(n.m) + bitLength(d.m);
  const top = n.m < 0n ? -n.m : n.m;
  const q = (up >= 0 ? top << BigInt(up) : top >> BigInt(-up)) / (d.m < 0n ? -d.m : d.m);
  return { m: q, e: n.e - d.e - up };
}

/**
 * a rounded, where a is n/d but for the error of `quotient`: n or d may be off by less than a part
 * in 2^63, neither is 0.
 */
export function settled(a: Surd, n: Dyadic, d: Dyadic): number {
  const negative = n.m < 0n !== d.m < 0n;
  const q = quotient(n, d);
  const size = q.m < QUOTIENT_TOP ? QUOTIENT_BITS : QUOTIENT_BITS + 1;
  const drop = Math.max(size - DOUBLE_BITS, MIN_EXPONENT - q.e);
  // Far below half of the smallest subnormal there is no midpoint to fear.
  if (drop > size + 1) return signed(negative, 0);
  const past = BigInt.asUintN(drop, q.m) - (HALVES()[drop] ?? 0n);
  const m = past < -2n || past > 1n ? q.m : decided(a, negative, { m: q.m - past, e: q.e });
  // A normal result needs nothing from roundScaled, which would measure m again.
  const normal = drop === size - DOUBLE_BITS;
  return signed(negative, normal ? scale(Number(m), q.e) : roundScaled(m, q.e));
}

/** The midpoint's m, moved one unit to the side of it where |a| lies. */
function decided(a: Surd, negative: boolean, midpoint: Dyadic): bigint {
  return midpoint.m + BigInt(compareMagnitude(a, negative, midpoint));
}

/** The sign of |a| − x. */
function compareMagnitude(a: Surd, negative: boolean, x: Dyadic): Sign {
  const xw = dy.mul(x, a.w);
  const top = signOfSum(negative ? dy.add(a.u, xw) : dy.sub(a.u, xw), a.v, a.D);
  return top === 0 ? 0 : top > 0 === (a.w.m > 0n !== negative) ? 1 : -1;
}

/** u/w rounded: a quotient whose last bit tells of a remainder rounds like the exact one. */
function roundRatio(u: Dyadic, w: Dyadic): number {
  if (u.m === 0n) return 0;
  const negative = u.m < 0n !== w.m < 0n;
  if (w.m === 1n || w.m === -1n) return roundScaled(w.m < 0n ? -u.m : u.m, u.e - w.e);
  const up = Math.max(0, QUOTIENT_BITS - bitLength(u.m) + bitLength(w.m));
  const top = (u.m < 0n ? -u.m : u.m) << BigInt(up);
  const bottom = w.m < 0n ? -w.m : w.m;
  const q = top / bottom;
  const sticky = q * bottom === top ? q : q | 1n;
  return signed(negative, roundScaled(sticky, u.e - w.e - up));
}
