/**
 * A number system that a formula's tree can be evaluated in. The same tree gives the student's
 * float64 value, the exact one, or an enclosure, depending only on which of these walks it.
 */
export interface Arithmetic<T> {
  readonly id: string;
  /** The double x as a number of this system (rounded, if the system is narrower than float64). */
  of(x: number): T;
  add(a: T, b: T): T;
  sub(a: T, b: T): T;
  mul(a: T, b: T): T;
  div(a: T, b: T): T;
  neg(a: T): T;
  sqr(a: T): T;
  sqrt(a: T): T;
  /** −1, 0 or 1; NaN where the system cannot tell (an overflow, an interval around zero). */
  sign(a: T): number;
  /**
   * The lesser and the greater of two; only for a system whose sign of a − b does not always tell
   * which is which.
   */
  sorted?(a: T, b: T): readonly [T, T];
  /** The nearest double, ties to even; ±Infinity beyond the doubles. */
  toNumber(a: T): number;
}
