/**
 * A number system over a register file, two doubles a number: float/double-double.ts and
 * float/interval.ts are such machines. Kernels for both are written once, as the trees' operations
 * in the trees' order; what passes from call to call is places in the file, never doubles, which V8
 * would box.
 */
export interface Machine {
  set(R: Float64Array, out: number, x: number): void;
  /** `set` with xs[i], and `toNumber` into xs[i]. */
  load(R: Float64Array, out: number, xs: Float64Array, i: number): void;
  store(R: Float64Array, a: number, xs: Float64Array, i: number): void;
  neg(R: Float64Array, out: number, a: number): void;
  add(R: Float64Array, out: number, a: number, b: number): void;
  sub(R: Float64Array, out: number, a: number, b: number): void;
  mul(R: Float64Array, out: number, a: number, b: number): void;
  div(R: Float64Array, out: number, a: number, b: number): void;
  sqr(R: Float64Array, out: number, a: number): void;
  sqrt(R: Float64Array, out: number, a: number): void;
  /** The lesser one into a, the greater one into b. */
  sort(R: Float64Array, a: number, b: number): void;
  /** −1, 0, 1, or NaN where it is not known. */
  sign(R: Float64Array, a: number): number;
  toNumber(R: Float64Array, a: number): number;
  /** What |a| does not exceed by more than its last bits. */
  size(R: Float64Array, a: number): number;
  /** What |a| is not below by more than its last bits, where the sign of a is known. */
  least(R: Float64Array, a: number): number;
}

/**
 * What is between this and the end of the range of any machine (2^996 for a factor in
 * double-double) is room enough.
 */
export const ROOMY = 2 ** 900;

/** Where the ray's numbers stand, in every program: six registers from 0 on. */
export const EX = 0;
export const EY = 2;
export const EZ = 4;
export const DX = 6;
export const DY = 8;
export const DZ = 10;
/** Twelve doubles: the programs' own registers begin here. */
export const FREE = 12;
