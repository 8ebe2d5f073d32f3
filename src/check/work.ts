import type { Surd } from '../math/exact.ts';
import { type Arithmetic, exact, float64, mapped, type Values, valuesOf } from '../math/formula.ts';
import type { Course } from './course.ts';
import type { Answers, Input } from './types.ts';
import { curvedCase, curvedWork } from './work-curved.ts';
import { flatWork } from './work-flat.ts';

/** The student's values, right or wrong, from which later lines are computed; finite ones only. */
type Own = Answers;

const NOTHING: Own = {};

/**
 * All answers of these formulas for this input, in exact arithmetic and rounded once at the end. If
 * an edited formula has two different square roots or divides by zero: in doubles.
 */
export const work = (course: Course, input: Input, own: Own = NOTHING): Answers =>
  asExactly((ar, take) =>
    workIn(course, input.typed ? mapped(input.typed, take) : numbersOf(input, ar), own, ar),
  );

/** In exact arithmetic, or in doubles where an edited formula has no exact value. */
export function asExactly<R>(f: <T>(ar: Arithmetic<T>, take: (x: Surd) => T) => R): R {
  try {
    return f(exact, (x) => x);
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    return f(float64, exact.toNumber);
  }
}

const numbersOf = <T>({ shape, ray }: Input, ar: Arithmetic<T>): Values<T> =>
  valuesOf(shape, ray, ar);

/** All answers computed in doubles, which is faster, for searching among many inputs. */
export const roughWork = (course: Course, input: Input): Answers =>
  workIn(course, numbersOf(input, float64), NOTHING, float64);

/** A, B, C, D and the case of these, if the formulas are of a curved shape; faster still. */
export const roughCase = (course: Course, input: Input): Answers =>
  course.family === 'curved' ? curvedCase(course, numbersOf(input, float64)) : {};

function workIn<T>(course: Course, values: Values<T>, own: Own, ar: Arithmetic<T>): Answers {
  return course.family === 'curved'
    ? curvedWork(course, values, own, ar)
    : flatWork(course, values, own, ar);
}
