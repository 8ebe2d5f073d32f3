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

/** Exactly where that can be; by bounds where two different roots meet. */
function either<Args extends readonly TypedNumber[]>(
  exactly: (...args: { [K in keyof Args]: Surd }) => TypedNumber,
  roughly: (...args: { [K in keyof Args]: Interval }) => TypedNumber,
): (...args: Args) => TypedNumber {
  return (...args) => {
    if (args.every(isExact)) {
      try {
        return exactly(...(args as unknown as { [K in keyof Args]: Surd }));
      } catch (error) {
        if (!(error instanceof RangeError)) throw error;
      }
    }
    return roughly(...(args.map(bounds) as { [K in keyof Args]: Interval }));
  };
}

/** √p − √q = (p − q)/(√p + √q), whose numerator is exact: bounds that are as narrow for roots that are close. */
function difference(a: Surd, b: Surd): TypedNumber {
  try {
    return exact.sub(a, b);
  } catch (error) {
    const roots = a.u.m === 0n && b.u.m === 0n && exact.sign(a) === exact.sign(b);
    if (!roots) throw error;
    const over = exact.sub(exact.sqr(a), exact.sqr(b));
    return interval.div(bounds(over), interval.add(bounds(a), bounds(b)));
  }
}

/** What people type, 0.3, 1/3, sqrt(2), and what follows: exact with one root in play, bounds with more. */
export const typed: Arithmetic<TypedNumber> = {
  id: 'typed',
  of: surd.fromNumber,
  add: either(exact.add, interval.add),
  sub: either(difference, interval.sub),
  mul: either(exact.mul, interval.mul),
  div: either(exact.div, interval.div),
  neg: either(exact.neg, interval.neg),
  sqr: either(exact.sqr, interval.sqr),
  sqrt: either(exact.sqrt, interval.sqrt),
  sign: (a) => (isExact(a) ? exact.sign(a) : interval.sign(a)),
  toNumber: (a) => (isExact(a) ? exact.toNumber(a) : interval.toNumber(a)),
};
