import { fromNumber } from '../exact/dyadic.ts';
import { ratio, toNumber } from '../exact/surd.ts';
import type { Arithmetic } from './arithmetic.ts';

/**
 * n/d · 10^e, exactly, d > 0: what is printed in decimals, and their sums, products and quotients.
 */
export interface Ratio {
  readonly n: bigint;
  readonly d: bigint;
  readonly e: number;
}

const tens = (power: number): bigint => 10n ** BigInt(power);

function add(a: Ratio, b: Ratio): Ratio {
  const e = Math.min(a.e, b.e);
  const [p, q] = [a.n * tens(a.e - e), b.n * tens(b.e - e)];
  return a.d === b.d ? { n: p + q, d: a.d, e } : { n: p * b.d + q * a.d, d: a.d * b.d, e };
}

const mul = (a: Ratio, b: Ratio): Ratio => ({ n: a.n * b.n, d: a.d * b.d, e: a.e + b.e });
const neg = (a: Ratio): Ratio => ({ ...a, n: -a.n });

/** Throws RangeError for a division by zero, and for every square root. */
export const ratios: Arithmetic<Ratio> = {
  id: 'ratios',
  of(x) {
    const { m, e } = fromNumber(x);
    return e < 0 ? { n: m, d: 1n << BigInt(-e), e: 0 } : { n: m << BigInt(e), d: 1n, e: 0 };
  },
  add,
  sub: (a, b) => add(a, neg(b)),
  mul,
  div(a, b) {
    if (b.n === 0n) throw new RangeError('division by zero');
    return mul(a, b.n < 0n ? { n: -b.d, d: -b.n, e: -b.e } : { n: b.d, d: b.n, e: -b.e });
  },
  neg,
  sqr: (a) => mul(a, a),
  sqrt() {
    throw new RangeError('no square root of a decimal');
  },
  sign: (a) => (a.n > 0n ? 1 : a.n < 0n ? -1 : 0),
  toNumber: (a) => toNumber(asSurd(a)),
};

/**
 * The same number among those that the exact method has.
 *
 * @param ratio n/d · 10^e of any unit, d > 0.
 * @example
 * toNumber(asSurd({ n: 1n, d: 4n, e: 0 })); // → 0.25
 */
export function asSurd({ n, d, e }: Ratio) {
  const scale = tens(Math.abs(e));
  return e < 0
    ? ratio({ m: n, e: 0 }, { m: d * scale, e: 0 })
    : ratio({ m: n * scale, e: 0 }, { m: d, e: 0 });
}
