import type { Dyadic, Sign } from './dyadic.ts';
import * as dy from './dyadic.ts';
import { isqrt } from './isqrt.ts';
import { norm, sign } from './surd-sign.ts';
import type { Surd } from './surd-type.ts';

export { toNumber } from './round.ts';
export { isZero, sign } from './surd-sign.ts';
export type { Surd } from './surd-type.ts';

export function surd(u: Dyadic, v: Dyadic, w: Dyadic, D: Dyadic): Surd {
  if (w.m === 0n) throw new RangeError('a surd needs a denominator ≠ 0, got 0');
  if (D.m < 0n) throw new RangeError(`a surd needs D ≥ 0, got ${dy.toNumber(D)}`);
  return { u, v, w, D };
}

export const ratio = (u: Dyadic, w: Dyadic): Surd => surd(u, dy.ZERO, w, dy.ZERO);
export const fromDyadic = (u: Dyadic): Surd => ({ u, v: dy.ZERO, w: dy.ONE, D: dy.ZERO });

/**
 * The double itself, m · 2^e.
 *
 * @param x finite, of any unit.
 * @returns in the unit of x.
 * @throws RangeError for NaN and the infinities.
 * @see NUMERICS.md, section 4: a double is a whole number times a power of two.
 * @example
 * sign(fromNumber(-0.1)); // → -1
 */
export const fromNumber = (x: number): Surd => fromDyadic(dy.fromNumber(x));

/**
 * a + b, exactly.
 *
 * @param a of any unit, and b of the same one; both may hold a root, if it is the same one, as in
 *   one quadratic.
 * @returns in the unit of a.
 * @throws RangeError where two different roots meet.
 * @see NUMERICS.md, section 4: sums, products, quotients and signs of (u + v√D)/w.
 * @example
 * toNumber(add(fromNumber(0.5), fromNumber(0.25))); // → 0.75
 */
export function add(a: Surd, b: Surd): Surd {
  const [p, q, D] = overOneRoot(a, b);
  if (sameForm(p.w, q.w)) return { u: dy.add(p.u, q.u), v: dy.add(p.v, q.v), w: p.w, D };
  const u = dy.add(dy.mul(p.u, q.w), dy.mul(q.u, p.w));
  const v = dy.add(dy.mul(p.v, q.w), dy.mul(q.v, p.w));
  return { u, v, w: dy.mul(p.w, q.w), D };
}

/**
 * −a, exactly.
 *
 * @param a of any unit.
 * @returns in the unit of a.
 * @see NUMERICS.md, section 4: sums, products, quotients and signs of (u + v√D)/w.
 * @example
 * toNumber(neg(fromNumber(2))); // → -2
 */
export const neg = (a: Surd): Surd => ({ ...a, u: dy.neg(a.u), v: dy.neg(a.v) });

/**
 * a − b, exactly.
 *
 * @param a as for `add`, and so is b.
 * @returns in the unit of a.
 * @throws RangeError where two different roots meet.
 * @see NUMERICS.md, section 4: sums, products, quotients and signs of (u + v√D)/w.
 * @example
 * toNumber(sub(fromNumber(1), fromNumber(2 ** -60))) === 1; // → true
 * isZero(sub(fromNumber(1), fromNumber(1))); // → true
 */
export const sub = (a: Surd, b: Surd): Surd => add(a, neg(b));

/**
 * a · b, exactly.
 *
 * @param a of any unit, and so is b; roots as for `add`.
 * @returns in the product of the units of a and b, which need not be the same.
 * @throws RangeError where two different roots meet.
 * @see NUMERICS.md, section 4: sums, products, quotients and signs of (u + v√D)/w.
 * @example
 * toNumber(mul(fromNumber(3), fromNumber(0.5))); // → 1.5
 */
export function mul(a: Surd, b: Surd): Surd {
  const [p, q, D] = overOneRoot(a, b);
  const w = dy.mul(p.w, q.w);
  const v = dy.add(dy.mul(p.u, q.v), dy.mul(p.v, q.u));
  const uu = dy.mul(p.u, q.u);
  const bothIrrational = p.v.m !== 0n && q.v.m !== 0n;
  return { u: bothIrrational ? dy.add(uu, dy.mul(dy.mul(p.v, q.v), D)) : uu, v, w, D };
}

export const sqr = (a: Surd): Surd => mul(a, a);

/**
 * a / b, exactly.
 *
 * @param a of any unit; roots as for `add`.
 * @param b of any unit, and not 0.
 * @returns in the unit of a over that of b, which need not be the same.
 * @throws RangeError for b = 0, and where two different roots meet.
 * @see NUMERICS.md, section 4: sums, products, quotients and signs of (u + v√D)/w.
 * @example
 * const third = div(fromNumber(1), fromNumber(3));
 * compare(mul(third, fromNumber(3)), fromNumber(1)); // → 0
 * div(third, fromNumber(0)); // throws RangeError: division by an exact zero
 */
export const div = (a: Surd, b: Surd): Surd => mul(a, inverse(b));

/**
 * w/(u + v√D) = w(u − v√D)/(u² − v²D). When D is a perfect square the norm below can vanish though
 * b does not; then u = v√D, and b is 2u/w.
 */
function inverse(b: Surd): Surd {
  if (sign(b) === 0) throw new RangeError('division by an exact zero');
  if (b.v.m === 0n) return ratio(b.w, b.u);
  const n = norm(b);
  if (n.m === 0n) return ratio(b.w, dy.shift(b.u, 1));
  return { u: dy.mul(b.w, b.u), v: dy.neg(dy.mul(b.w, b.v)), w: n, D: b.D };
}

/** √(u/w) = √(u·w)/|w|. The root of an irrational surd leaves the field: RangeError. */
export function sqrt(a: Surd): Surd {
  const { u, v, w } = folded(a);
  if (v.m !== 0n) throw new RangeError('no exact square root of an irrational surd');
  const D = dy.mul(u, w);
  if (D.m < 0n) throw new RangeError('no real square root of a negative number');
  return { u: dy.ZERO, v: dy.ONE, w: dy.abs(w), D };
}

/**
 * The sign of a − b, decided exactly.
 *
 * @param a as for `add`, and so is b.
 * @returns no unit: −1, 0 or 1.
 * @throws RangeError where two different roots meet.
 * @see NUMERICS.md, section 4: sums, products, quotients and signs of (u + v√D)/w.
 * @example
 * compare(fromNumber(0.1), div(fromNumber(1), fromNumber(10))); // → 1
 */
export const compare = (a: Surd, b: Surd): Sign => sign(sub(a, b));

/** a and b, and the root they share; RangeError when they hold two different ones. */
function overOneRoot(a: Surd, b: Surd): readonly [Surd, Surd, Dyadic] {
  if (b.v.m === 0n) return [a, b, a.D];
  if (a.v.m === 0n || a.D === b.D || dy.compare(a.D, b.D) === 0) return [a, b, b.D];
  const p = folded(a);
  if (p.v.m === 0n) return [p, b, b.D];
  const q = folded(b);
  if (q.v.m === 0n) return [p, q, p.D];
  const both = dyadicRoot(dy.mul(p.D, q.D));
  if (both) return [p, overRoot(q, p.D, both), p.D];
  const roots = `√${dy.toNumber(a.D)} and √${dy.toNumber(b.D)}`;
  throw new RangeError(`surds over different roots do not combine: ${roots}`);
}

const sameForm = (a: Dyadic, b: Dyadic): boolean => a === b || (a.e === b.e && a.m === b.m);

/** The same value over √D, for √(D·a.D) = both: √8 is 4/2 times √2. */
const overRoot = (a: Surd, D: Dyadic, both: Dyadic): Surd => ({
  u: dy.mul(a.u, D),
  v: dy.mul(a.v, both),
  w: dy.mul(a.w, D),
  D,
});

/** The same value with v = 0 if √D is dyadic. */
function folded(a: Surd): Surd {
  if (a.v.m === 0n) return a;
  const rootD = dyadicRoot(a.D);
  return rootD ? ratio(dy.add(a.u, dy.mul(a.v, rootD)), a.w) : a;
}

function dyadicRoot(D: Dyadic): Dyadic | null {
  const odd = D.e & 1;
  const m = odd === 0 ? D.m : D.m << 1n;
  const root = isqrt(m);
  return root * root === m ? { m: root, e: (D.e - odd) / 2 } : null;
}
