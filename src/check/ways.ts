import {
  type Expr,
  minus,
  negative,
  norm,
  num,
  over,
  plusMinus,
  root,
  scalar,
  squared,
  times,
  vec,
} from '../math/formula.ts';
import type { Course, FlatCourse } from './course.ts';
import type { Answers } from './types.ts';

/** A derivation that is as right as the course's, with some lines written in another form. */
export interface Way {
  readonly id: string;
  /** "Right, with …" */
  readonly says: string;
  /** Least number of lines that agree with it and not with the course; one may be a mistake. */
  readonly evidence: number;
  /** Whether it depends on what was typed. */
  readonly isOwn: boolean;
  /** The course in this form; null if it does not apply. */
  edit(course: Course, own: Answers, truth: Answers): Course | null;
}

const [A, B, C, D] = [scalar('A'), scalar('B'), scalar('C'), scalar('D')];

const halfB: Way = {
  id: 'half-b',
  says:
    'b = B/2 in place of B: then the discriminant is b² − AC and the roots are (−b ± √(b² − ' +
    'AC))/A',
  evidence: 2,
  isOwn: false,
  edit: (course) =>
    course.family === 'flat'
      ? null
      : {
          ...course,
          B: over(course.B, num(2)),
          D: minus(squared(B), times(A, C)),
          roots: over(plusMinus(negative(B), root(D)), A),
          double: over(negative(B), A),
          linear: over(negative(C), times(num(2), B)),
        },
};

const quarterD: Way = {
  id: 'quarter-d',
  says: 'a quarter of D, the b² − AC of b = B/2: then the roots are (−B/2 ± √(b² − AC))/A',
  evidence: 2,
  isOwn: false,
  edit: (course) =>
    course.family === 'flat'
      ? null
      : {
          ...course,
          D: over(course.D, num(4)),
          roots: over(plusMinus(negative(B), times(num(2), root(D))), times(num(2), A)),
        },
};

/** The course with another N in N·(E − P) and N·d, which leaves t as it is. */
function withNormal(course: Course, longer: (e: Expr) => Expr): FlatCourse | null {
  if (course.family === 'curved') return null;
  const [offset, rate] = [longer(course.offset), longer(course.rate)];
  return { ...course, offset, rate, t: over(negative(offset), rate) };
}

const unitNormal: Way = {
  id: 'unit-normal',
  says: 'N divided by its length |N|: t and P do not depend on it',
  evidence: 1,
  isOwn: false,
  edit: (course) => withNormal(course, (e) => over(e, norm(vec('N')))),
};

const otherNormal: Way = {
  id: 'other-normal',
  says: 'a multiple of N: t and P do not depend on its length',
  evidence: 2,
  isOwn: true,
  edit(course, own, truth) {
    const [ownRate, rate] = [own['N.d'], truth['N.d']];
    if (typeof ownRate !== 'number' || typeof rate !== 'number') return null;
    // Both lines are needed: a factor from N·d alone would explain any wrong number.
    const factor = ownRate / rate;
    if (own['N.(E-P)'] === undefined || !(factor > 0) || !Number.isFinite(factor)) return null;
    return withNormal(course, (e) => times(num(factor), e));
  },
};

export const WAYS: readonly Way[] = [halfB, quarterD, unitNormal, otherNormal];
