import type { Arithmetic } from './arithmetic.ts';

const { fround } = Math;

/**
 * IEEE 754 single precision, 24 bits, from about 1e-38 to 3.4e38. Rounding the double result of one
 * operation on two float32 numbers once more gives the correctly rounded float32 result for + − × ÷
 * and √, because 53 ≥ 2·24 + 2 (Figueroa 1995, When is double rounding innocuous?).
 */
export const float32: Arithmetic<number> = {
  id: 'float32',
  of: fround,
  add: (a, b) => fround(a + b),
  sub: (a, b) => fround(a - b),
  mul: (a, b) => fround(a * b),
  div: (a, b) => fround(a / b),
  neg: (a) => -a,
  sqr: (a) => fround(a * a),
  sqrt: (a) => fround(Math.sqrt(a)),
  // An infinity came from an overflow: what was compared is no longer there.
  sign: (a) => (Number.isFinite(a) ? Math.sign(a) + 0 : Number.NaN),
  toNumber: (a) => a,
};
