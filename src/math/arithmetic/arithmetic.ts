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
  /**
   * `then` where a is known to be negative, else `otherwise`: only for a system that cannot ask for
   * a sign, because it records what it is to do.
   */
  whereNegative?(a: T, then: T, otherwise: T): T;
  /** The nearest double, ties to even; ±Infinity beyond the doubles. */
  toNumber(a: T): number;
}

/** One of two values, of which only that is worked out, unless the system records both. */
export const bySign = <T>(a: T, negative: () => T, otherwise: () => T, ar: Arithmetic<T>): T =>
  ar.whereNegative
    ? ar.whereNegative(a, negative(), otherwise())
    : ar.sign(a) < 0
      ? negative()
      : otherwise();
