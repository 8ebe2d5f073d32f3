import type { Arithmetic } from '../math/arithmetic/arithmetic.ts';
import { exact } from '../math/arithmetic/exact.ts';
import { float64 } from '../math/arithmetic/float64.ts';
import type { Course } from './course.ts';
import type { Answers, Input } from './types.ts';
import { curvedWork } from './work-curved.ts';
import { flatWork } from './work-flat.ts';

/** Values that a student already has, right or not: later lines are worked out from them. Only finite ones count. */
export type Own = Answers;

const NOTHING: Own = {};

/**
 * Everything that these formulas give for this input. Exactly, rounded once at the end; where an edited formula has two
 * different square roots, or divides by zero, in doubles, as a program would.
 */
export const work = (course: Course, input: Input, own: Own = NOTHING): Answers =>
  asExactly((ar) => workIn(course, input, own, ar));

/** In exact arithmetic, or in doubles where an edited formula has no exact value. */
export function asExactly<R>(f: <T>(ar: Arithmetic<T>) => R): R {
  try {
    return f(exact);
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    return f(float64);
  }
}

/** The same in doubles throughout: for looking through many inputs. */
export const roughWork = (course: Course, input: Input): Answers =>
  workIn(course, input, NOTHING, float64);

function workIn<T>(course: Course, input: Input, own: Own, ar: Arithmetic<T>): Answers {
  return course.family === 'curved'
    ? curvedWork(course, input, own, ar)
    : flatWork(course, input, own, ar);
}
