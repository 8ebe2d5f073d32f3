import { decompose } from '../float/bits.ts';
import { roundScaled } from './round-scaled.ts';

/**
 * m·2^e, exactly. Every finite double is one, and so are their sums, differences and products. The
 * form is not unique (4·2^0 = 1·2^2): nothing is normalised on the way, since a shift costs as
 * much as an addition.
 */
export interface Dyadic {
  readonly m: bigint;
  readonly e: number;
}
export type Sign = -1 | 0 | 1;

export const ZERO: Dyadic = { m: 0n, e: 0 };
export const ONE: Dyadic = { m: 1n, e: 0 };

/** Throws RangeError for NaN and the infinities. */
export const fromNumber = (x: number): Dyadic => decompose(x);

export function add(a: Dyadic, b: Dyadic): Dyadic {
  if (a.m === 0n) return b;
  if (b.m === 0n) return a;
  const up = a.e - b.e;
  if (up === 0) return { m: a.m + b.m, e: a.e };
  if (up > 0) return { m: (a.m << BigInt(up)) + b.m, e: b.e };
  return { m: a.m + (b.m << BigInt(-up)), e: a.e };
}

export function sub(a: Dyadic, b: Dyadic): Dyadic {
  if (b.m === 0n) return a;
  if (a.m === 0n) return neg(b);
  const up = a.e - b.e;
  if (up === 0) return { m: a.m - b.m, e: a.e };
  if (up > 0) return { m: (a.m << BigInt(up)) - b.m, e: b.e };
  return { m: a.m - (b.m << BigInt(-up)), e: a.e };
}

export const mul = (a: Dyadic, b: Dyadic): Dyadic => ({ m: a.m * b.m, e: a.e + b.e });
export const sqr = (a: Dyadic): Dyadic => ({ m: a.m * a.m, e: 2 * a.e });
export const neg = (a: Dyadic): Dyadic => ({ m: -a.m, e: a.e });
export const abs = (a: Dyadic): Dyadic => (a.m < 0n ? neg(a) : a);
/** a·2^k, by the exponent alone. */
export const shift = (a: Dyadic, k: number): Dyadic => ({ m: a.m, e: a.e + k });

export const sign = (a: Dyadic): Sign => (a.m > 0n ? 1 : a.m < 0n ? -1 : 0);

export function compare(a: Dyadic, b: Dyadic): Sign {
  const signA = sign(a);
  return signA === sign(b) ? sign(sub(a, b)) : signA !== 0 ? signA : sign(neg(b));
}

/** The nearest double, ties to even, rounded once also among the subnormals; see roundScaled. */
export const toNumber = (a: Dyadic): number => roundScaled(a.m, a.e);
