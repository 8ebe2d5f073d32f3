import * as iv from '../float/interval.ts';
import type { Arithmetic } from './arithmetic.ts';

/** Every real from lo to hi, lo ≤ hi; see src/math/float/interval.ts. */
export interface Interval {
  readonly lo: number;
  readonly hi: number;
}

/** Two operands and a result. */
const R: iv.Registers = new Float64Array(6);
const A = 0;
const B = 2;
const OUT = 4;

const read = (at: number): Interval => ({ lo: R[at] as number, hi: R[at + 1] as number });

function load(at: number, { lo, hi }: Interval): void {
  R[at] = lo;
  R[at + 1] = hi;
}

type Unary = (R: iv.Registers, out: number, a: number) => void;
type Binary = (R: iv.Registers, out: number, a: number, b: number) => void;

function unary(f: Unary): (a: Interval) => Interval {
  return (a) => {
    load(A, a);
    f(R, OUT, A);
    return read(OUT);
  };
}

function binary(f: Binary): (a: Interval, b: Interval) => Interval {
  return (a, b) => {
    load(A, a);
    load(B, b);
    f(R, OUT, A, B);
    return read(OUT);
  };
}

/**
 * Enclosures (Moore 1966, Interval analysis). A sign is known where no number of the interval says
 * otherwise.
 */
export const interval: Arithmetic<Interval> = {
  id: 'interval',
  of: (x) => ({ lo: x, hi: x }),
  add: binary(iv.add),
  sub: binary(iv.sub),
  mul: binary(iv.mul),
  div: binary(iv.div),
  neg: unary(iv.neg),
  sqr: unary(iv.sqr),
  sqrt: unary(iv.sqrt),
  sign(a) {
    load(A, a);
    return iv.sign(R, A);
  },
  sorted(a, b) {
    load(A, a);
    load(B, b);
    iv.sort(R, A, B);
    return [read(A), read(B)];
  },
  toNumber(a) {
    load(A, a);
    return iv.toNumber(R, A);
  },
};
