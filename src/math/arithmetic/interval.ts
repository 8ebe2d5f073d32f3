import * as directed from '../float/directed.ts';
import { doubles, type Floats } from '../float/floats.ts';
import { lazily } from '../lazily.ts';
import type { Arithmetic } from './arithmetic.ts';

/** Every real from lo to hi, lo ≤ hi. An end may be infinite, the numbers in between are finite. */
export interface Ends<F> {
  readonly lo: F;
  readonly hi: F;
}

export type Interval = Ends<number>;

/** One operation rounded down or up, as float/directed.ts. */
export interface Directed<F> {
  addDown(a: F, b: F): F;
  addUp(a: F, b: F): F;
  mulDown(a: F, b: F): F;
  mulUp(a: F, b: F): F;
  divDown(a: F, b: F): F;
  divUp(a: F, b: F): F;
  sqrtDown(a: F): F;
  sqrtUp(a: F): F;
}

type Operations<T> = Pick<
  Arithmetic<T>,
  'of' | 'add' | 'sub' | 'mul' | 'div' | 'neg' | 'sqr' | 'sqrt'
>;

/** Each result holds the exact result of any numbers of its operands. */
export function intervalOver<F, M>(f: Floats<F, M>, d: Directed<F>): Operations<Ends<F>> {
  const zero = f.of(0);
  const isNotNegative = (x: F): M => f.atMost(zero, x);
  const isNotPositive = (x: F): M => f.atMost(x, zero);
  const neg = ({ lo, hi }: Ends<F>): Ends<F> => ({ lo: f.neg(hi), hi: f.neg(lo) });
  const add = (a: Ends<F>, b: Ends<F>): Ends<F> => ({
    lo: d.addDown(a.lo, b.lo),
    hi: d.addUp(a.hi, b.hi),
  });

  /** The factor is one number. */
  function scaled({ lo, hi }: Ends<F>, k: F): Ends<F> {
    const up = isNotNegative(k);
    return { lo: d.mulDown(f.select(up, lo, hi), k), hi: d.mulUp(f.select(up, hi, lo), k) };
  }

  return {
    of: (x) => ({ lo: f.of(x), hi: f.of(x) }),
    add,
    sub: (a, b) => add(a, neg(b)),
    neg,
    /**
     * The signs of the ends tell which two products are the least and the greatest; only where both
     * hold 0 inside there are four.
     */
    mul(a, b) {
      const { lo: p, hi: q } = a;
      const { lo: r, hi: s } = b;
      if (r === s) return scaled(a, r);
      if (p === q) return scaled(b, p);
      const [below, above] = [f.less(p, zero), f.less(zero, q)];
      const inside = f.and(f.less(r, zero), f.less(zero, s));
      if (f.rarely(f.and(f.and(below, above), inside))) {
        return {
          lo: f.min(d.mulDown(p, s), d.mulDown(q, r)),
          hi: f.max(d.mulUp(p, r), d.mulUp(q, s)),
        };
      }
      const [up, reaches] = [isNotNegative(r), isNotNegative(s)];
      const [over, under] = [isNotNegative(p), isNotPositive(q)];
      const leastA = f.select(f.or(up, f.and(under, reaches)), p, q);
      const leastB = f.select(f.and(below, f.or(under, up)), s, r);
      const mostA = f.select(f.or(up, f.and(over, reaches)), q, p);
      const mostB = f.select(f.or(over, f.and(above, up)), s, r);
      return { lo: d.mulDown(leastA, leastB), hi: d.mulUp(mostA, mostB) };
    },
    /** The least is 0 where a holds 0: what `mul` of a with itself cannot know. */
    sqr({ lo, hi }) {
      if (lo === hi) return { lo: d.mulDown(lo, lo), hi: d.mulUp(lo, lo) };
      const [from, to] = [f.abs(lo), f.abs(hi)];
      const least = f.select(f.and(isNotPositive(lo), isNotNegative(hi)), zero, f.min(from, to));
      const most = f.max(from, to);
      return { lo: d.mulDown(least, least), hi: d.mulUp(most, most) };
    },
    /** A denominator that may be 0 leaves nothing known. */
    div(a, b) {
      const { lo: r, hi: s } = b;
      if (f.rarely(f.and(isNotPositive(r), isNotNegative(s)))) {
        return { lo: f.of(-Infinity), hi: f.of(Infinity) };
      }
      const up = isNotNegative(r);
      const least = f.select(up, a.lo, a.hi);
      const most = f.select(up, a.hi, a.lo);
      return {
        lo: d.divDown(least, f.select(isNotNegative(least), s, r)),
        hi: d.divUp(most, f.select(isNotNegative(most), r, s)),
      };
    },
    /** A root is only taken of what is known not to be negative, so an end below 0 counts as 0. */
    sqrt: ({ lo, hi }) => ({ lo: d.sqrtDown(f.max(lo, zero)), hi: d.sqrtUp(f.max(hi, zero)) }),
  };
}

/**
 * Enclosures (Moore 1966, Interval analysis). A sign is known where no number of the interval says
 * otherwise: 0 only for [0, 0].
 */
export const interval = lazily(
  (): Arithmetic<Interval> => ({
    id: 'interval',
    ...intervalOver(doubles, directed),
    sign({ lo, hi }) {
      if (lo > 0) return 1;
      if (hi < 0) return -1;
      return lo === 0 && hi === 0 ? 0 : Number.NaN;
    },
    /** Bounds of the lesser and of the greater; where they overlap nobody knows which is which. */
    sorted: (a, b) => [
      { lo: Math.min(a.lo, b.lo), hi: Math.min(a.hi, b.hi) },
      { lo: Math.max(a.lo, b.lo), hi: Math.max(a.hi, b.hi) },
    ],
    /**
     * The middle. Halved before they are added: the sum of two ends may overflow. −0 comes out as
     * 0, [−∞, ∞] as NaN.
     */
    toNumber: ({ lo, hi }) => (lo === hi ? lo : lo / 2 + hi / 2) + 0,
  }),
);
