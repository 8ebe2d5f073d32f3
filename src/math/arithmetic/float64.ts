import type { Arithmetic } from './arithmetic.ts';

/** IEEE 754 double precision: every operation rounded once, to nearest, ties to even. */
export const float64: Arithmetic<number> = {
  id: 'float64',
  of: (x) => x,
  add: (a, b) => a + b,
  sub: (a, b) => a - b,
  mul: (a, b) => a * b,
  div: (a, b) => a / b,
  neg: (a) => -a,
  sqr: (a) => a * a,
  sqrt: Math.sqrt,
  // An infinity came from an overflow: what was compared is no longer there.
  sign: (a) => (Number.isFinite(a) ? Math.sign(a) + 0 : Number.NaN),
  toNumber: (a) => a,
};
