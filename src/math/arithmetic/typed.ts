import { bracket } from '../exact/faithful.ts';
import type { Surd } from '../exact/surd.ts';
import * as surd from '../exact/surd.ts';
import type { Arithmetic } from './arithmetic.ts';
import { exact } from './exact.ts';
import { type Interval, interval } from './interval.ts';

/** An exact number, or bounds of one that holds more roots than `exact` can. */
export type TypedNumber = Surd | Interval;

const isExact = (x: TypedNumber): x is Surd => 'u' in x;

function bounds(x: TypedNumber): Interval {
  if (!isExact(x)) return x;
  const [lo, hi] = bracket(x);
  return { lo, hi };
}

type Unary<T> = (a: T) => T;
type Binary<T> = (a: T, b: T) => T;

/** Null where two different roots meet. */
function tried(exactly: () => TypedNumber): TypedNumber | null {
  try {
    return exactly();
  } catch (error) {
    if (error instanceof RangeError) return null;
    throw error;
  }
}

const unary = (exactly: Unary<Surd>, roughly: Unary<Interval>, a: TypedNumber): TypedNumber =>
  (isExact(a) ? tried(() => exactly(a)) : null) ?? roughly(bounds(a));

const binary = (
  exactly: (a: Surd, b: Surd) => TypedNumber,
  roughly: Binary<Interval>,
  a: TypedNumber,
  b: TypedNumber,
): TypedNumber =>
  (isExact(a) && isExact(b) ? tried(() => exactly(a, b)) : null) ?? roughly(bounds(a), bounds(b));

/**
 * √p − √q = (p − q)/(√p + √q), whose numerator is exact: bounds that are as narrow for roots that
 * are close.
 */
function difference(a: Surd, b: Surd): TypedNumber {
  const known = tried(() => exact.sub(a, b));
  if (known) return known;
  const areRoots = a.u.m === 0n && b.u.m === 0n && exact.sign(a) === exact.sign(b);
  if (!areRoots) return interval().sub(bounds(a), bounds(b));
  const over = exact.sub(exact.sqr(a), exact.sqr(b));
  return interval().div(bounds(over), interval().add(bounds(a), bounds(b)));
}

/**
 * What people type, 0.3, 1/3, sqrt(2), and what follows: exact with one root in play, bounds with
 * more.
 */
export const typed: Arithmetic<TypedNumber> = {
  id: 'typed',
  of: surd.fromNumber,
  add: (a, b) => binary(exact.add, interval().add, a, b),
  sub: (a, b) => binary(difference, interval().sub, a, b),
  mul: (a, b) => binary(exact.mul, interval().mul, a, b),
  div: (a, b) => binary(exact.div, interval().div, a, b),
  neg: (a) => unary(exact.neg, interval().neg, a),
  sqr: (a) => unary(exact.sqr, interval().sqr, a),
  sqrt: (a) => unary(exact.sqrt, interval().sqrt, a),
  sign: (a) => (isExact(a) ? exact.sign(a) : interval().sign(a)),
  toNumber: (a) => (isExact(a) ? exact.toNumber(a) : interval().toNumber(a)),
};
