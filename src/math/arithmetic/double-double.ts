import { doubles, errorsOver, type Floats } from '../float/floats.ts';
import { lazily } from '../lazily.ts';
import type { Arithmetic } from './arithmetic.ts';

/** hi + lo, |lo| ≤ ulp(hi)/2; see src/math/float/double-double.ts for errors and range. */
export interface Pair<F> {
  readonly hi: F;
  readonly lo: F;
}

export type DoubleDouble = Pair<number>;

type Operations<T> = Pick<
  Arithmetic<T>,
  'of' | 'add' | 'sub' | 'mul' | 'div' | 'neg' | 'sqr' | 'sqrt'
>;

/** The operations of src/math/float/double-double.ts, in their order, over any format. */
export function doubleDoubleOver<F, M>(f: Floats<F, M>): Operations<Pair<F>> {
  const { sumError, fastSumError, productError, squareError } = errorsOver(f);
  const zero = f.of(0);

  /** hi + lo, renormalised; needs |hi| ≥ |lo|. */
  function pair(hi: F, lo: F): Pair<F> {
    const s = f.add(hi, lo);
    return { hi: s, lo: fastSumError(hi, lo, s) };
  }

  function add(a: Pair<F>, b: Pair<F>): Pair<F> {
    const s = f.add(a.hi, b.hi);
    const t = f.add(a.lo, b.lo);
    const c = f.add(sumError(a.hi, b.hi, s), t);
    const v = f.add(s, c);
    return pair(v, f.add(sumError(a.lo, b.lo, t), fastSumError(s, c, v)));
  }

  const neg = ({ hi, lo }: Pair<F>): Pair<F> => ({ hi: f.neg(hi), lo: f.neg(lo) });

  return {
    of: (x) => ({ hi: f.of(x), lo: zero }),
    add,
    sub: (a, b) => add(a, neg(b)),
    mul(a, b) {
      const p = f.mul(a.hi, b.hi);
      const rest = f.add(f.mul(a.hi, b.lo), f.mul(a.lo, b.hi));
      return pair(p, f.add(productError(a.hi, b.hi, p), rest));
    },
    div(a, b) {
      const q = f.div(a.hi, b.hi);
      const p = f.mul(q, b.hi);
      const c = f.mul(q, b.lo);
      const t = f.add(p, c);
      const low = f.add(fastSumError(p, c, t), productError(q, b.hi, p));
      const r = f.add(t, low);
      const rest = f.add(f.sub(a.hi, r), f.sub(a.lo, fastSumError(t, low, r)));
      return pair(q, f.div(rest, b.hi));
    },
    neg,
    sqr({ hi, lo }) {
      const p = f.mul(hi, hi);
      return pair(p, f.add(squareError(hi, p), f.mul(f.of(2), f.mul(hi, lo))));
    },
    sqrt({ hi, lo }) {
      if (f.rarely(f.and(f.atMost(hi, zero), f.atMost(zero, hi)))) return { hi: zero, lo: zero };
      const s = f.sqrt(hi);
      const p = f.mul(s, s);
      const rest = f.add(f.sub(f.sub(hi, p), squareError(s, p)), lo);
      return pair(s, f.div(rest, f.mul(f.of(2), s)));
    },
  };
}

/**
 * Twice the digits of a double, and no more range: an overflow becomes NaN, whose sign is unknown.
 */
export const doubleDouble = lazily(
  (): Arithmetic<DoubleDouble> => ({
    id: 'double-double',
    ...doubleDoubleOver(doubles),
    sign: ({ hi }) => (Number.isFinite(hi) ? Math.sign(hi) + 0 : Number.NaN),
    /** −0 comes out as 0: which zero it is depends on operations that a kernel need not do. */
    toNumber: ({ hi }) => hi + 0,
  }),
);
