import type { Course, CurvedCourse, FlatCourse, Rules } from '../course.ts';

/** A known mistake: the course's formulas with one edit. */
export interface Misconception {
  readonly id: string;
  /** Its number in the list that the project keeps: X1 … X14. */
  readonly code: string;
  /** "this is what comes out with …" */
  readonly says: string;
  /** The line of the derivation where it happens: A, B, C, D, t, first, P, N, N.d, inside, case. */
  readonly line: string;
  /** What to look at again, in one sentence. */
  readonly remedy: string;
  /** Null where these formulas leave no room for it. */
  edit(course: Course): Course | null;
}

type About = Omit<Misconception, 'edit'>;

/** An edit of a curved shape's lines; null, or the same lines, where there is nothing to edit. */
export const ofCurved = (
  about: About,
  edit: (course: CurvedCourse) => Partial<CurvedCourse> | null,
): Misconception => ({
  ...about,
  edit: (course) => (course.family === 'curved' ? changed(course, edit(course)) : null),
});

export const ofFlat = (
  about: About,
  edit: (course: FlatCourse) => Partial<FlatCourse> | null,
): Misconception => ({
  ...about,
  edit: (course) => (course.family === 'flat' ? changed(course, edit(course)) : null),
});

/** Another choice around the formulas. */
export const ofRules = (about: About, rules: Partial<Rules>): Misconception => ({
  ...about,
  edit: (course) => ({ ...course, rules: { ...course.rules, ...rules } }),
});

function changed<C extends Course>(course: C, edited: Partial<C> | null): C | null {
  if (!edited) return null;
  const some = (Object.keys(edited) as (keyof C)[]).some((key) => !same(edited[key], course[key]));
  return some ? { ...course, ...edited } : null;
}

/** The same tree, or three components that are: on a sphere P − C is the normal. */
function same(a: unknown, b: unknown): boolean {
  if (!Array.isArray(a) || !Array.isArray(b)) return JSON.stringify(a) === JSON.stringify(b);
  return a.length === b.length && a.every((x, i) => same(x, b[i]));
}
