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
export function work(course: Course, input: Input, own: Own = NOTHING): Answers {
  try {
    return workIn(course, input, own, exact);
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    return workIn(course, input, own, float64);
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
