import * as dd from '../float/double-double.ts';
import type { Arithmetic } from './arithmetic.ts';

/** hi + lo, |lo| ≤ ulp(hi)/2; see src/math/float/double-double.ts for errors and range. */
export interface DoubleDouble {
  readonly hi: number;
  readonly lo: number;
}

/** Two operands and a result. */
const R: dd.Registers = new Float64Array(6);
const A = 0;
const B = 2;
const OUT = 4;

type Unary = (R: dd.Registers, out: number, a: number) => void;
type Binary = (R: dd.Registers, out: number, a: number, b: number) => void;

const result = (): DoubleDouble => ({ hi: R[OUT] as number, lo: R[OUT + 1] as number });

function load(at: number, { hi, lo }: DoubleDouble): void {
  R[at] = hi;
  R[at + 1] = lo;
}

function unary(f: Unary): (a: DoubleDouble) => DoubleDouble {
  return (a) => {
    load(A, a);
    f(R, OUT, A);
    return result();
  };
}

function binary(f: Binary): (a: DoubleDouble, b: DoubleDouble) => DoubleDouble {
  return (a, b) => {
    load(A, a);
    load(B, b);
    f(R, OUT, A, B);
    return result();
  };
}

/**
 * Twice the digits of a double, and no more range: an overflow becomes NaN, whose sign is unknown.
 */
export const doubleDouble: Arithmetic<DoubleDouble> = {
  id: 'double-double',
  of: (x) => ({ hi: x, lo: 0 }),
  add: binary(dd.add),
  sub: binary(dd.sub),
  mul: binary(dd.mul),
  div: binary(dd.div),
  neg: ({ hi, lo }) => ({ hi: -hi, lo: -lo }),
  sqr: unary(dd.sqr),
  sqrt: unary(dd.sqrt),
  sign: ({ hi }) => (Number.isFinite(hi) ? Math.sign(hi) + 0 : Number.NaN),
  toNumber: ({ hi }) => hi,
};
