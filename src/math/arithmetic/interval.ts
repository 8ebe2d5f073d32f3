import {
  addDown,
  addUp,
  divDown,
  divUp,
  mulDown,
  mulUp,
  sqrtDown,
  sqrtUp,
} from '../float/directed.ts';
import type { Arithmetic } from './arithmetic.ts';

/** Every real from lo to hi, lo ≤ hi; an end may be infinite, but the numbers in between are finite. */
export interface Interval {
  readonly lo: number;
  readonly hi: number;
}

const EVERYTHING: Interval = { lo: -Infinity, hi: Infinity };

const add = (a: Interval, b: Interval): Interval => ({
  lo: addDown(a.lo, b.lo),
  hi: addUp(a.hi, b.hi),
});

const neg = ({ lo, hi }: Interval): Interval => ({ lo: -hi, hi: -lo });

const mul = (a: Interval, b: Interval): Interval => ({
  lo: Math.min(mulDown(a.lo, b.lo), mulDown(a.lo, b.hi), mulDown(a.hi, b.lo), mulDown(a.hi, b.hi)),
  hi: Math.max(mulUp(a.lo, b.lo), mulUp(a.lo, b.hi), mulUp(a.hi, b.lo), mulUp(a.hi, b.hi)),
});

/** The least is 0 where a holds 0: what `mul` of a with itself cannot know. */
function sqr({ lo, hi }: Interval): Interval {
  if (lo >= 0) return { lo: mulDown(lo, lo), hi: mulUp(hi, hi) };
  if (hi <= 0) return { lo: mulDown(hi, hi), hi: mulUp(lo, lo) };
  return { lo: 0, hi: Math.max(mulUp(lo, lo), mulUp(hi, hi)) };
}

/** A denominator that may be 0 leaves nothing known. */
function div(a: Interval, b: Interval): Interval {
  if (b.lo <= 0 && b.hi >= 0) return EVERYTHING;
  return {
    lo: Math.min(
      divDown(a.lo, b.lo),
      divDown(a.lo, b.hi),
      divDown(a.hi, b.lo),
      divDown(a.hi, b.hi),
    ),
    hi: Math.max(divUp(a.lo, b.lo), divUp(a.lo, b.hi), divUp(a.hi, b.lo), divUp(a.hi, b.hi)),
  };
}

/** A root is only taken of what is known not to be negative, so an end below 0 counts as 0. */
const sqrt = ({ lo, hi }: Interval): Interval => ({
  lo: sqrtDown(Math.max(lo, 0)),
  hi: sqrtUp(Math.max(hi, 0)),
});

/** 1 or −1 where no number of the interval says otherwise, 0 only for [0, 0], NaN for all others. */
export function signWithin(lo: number, hi: number): number {
  if (lo > 0) return 1;
  if (hi < 0) return -1;
  return lo === 0 && hi === 0 ? 0 : Number.NaN;
}

/** Halved before they are added: the sum of two ends may overflow. −0 comes out as 0, [−∞, ∞] as NaN. */
export const middle = (lo: number, hi: number): number => (lo === hi ? lo : lo / 2 + hi / 2) + 0;

/**
 * Enclosures: each operation gives an interval that holds the exact result of any numbers of its operands
 * (Moore 1966, Interval analysis; the rounding is src/math/float/directed.ts).
 */
export const interval: Arithmetic<Interval> = {
  id: 'interval',
  of: (x) => ({ lo: x, hi: x }),
  add,
  sub: (a, b) => add(a, neg(b)),
  mul,
  div,
  neg,
  sqr,
  sqrt,
  sign: ({ lo, hi }) => signWithin(lo, hi),
  toNumber: ({ lo, hi }) => middle(lo, hi),
};
