import type { Course, CurvedCourse, FlatCourse, Rules } from '../course.ts';

/** A known mistake as one edit of the course's formulas. */
export interface Misconception {
  readonly id: string;
  /** "this is what comes out with …" */
  readonly says: string;
  /** The line of the derivation where it happens: A, B, C, D, t, first, P, N, N.d, inside, case. */
  readonly line: string;
  /** One sentence on what to look at again. */
  readonly remedy: string;
  /** The edited course; null if the mistake cannot be made in these formulas. */
  edit(course: Course): Course | null;
}

type About = Omit<Misconception, 'edit'>;

/**
 * A mistake in a curved shape's lines; `edit` gives null or the same trees if it does not apply.
 */
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

/** A mistake in the decisions besides the formulas. */
export const ofRules = (about: About, rules: Partial<Rules>): Misconception => ({
  ...about,
  edit: (course) => ({ ...course, rules: { ...course.rules, ...rules } }),
});

function changed<C extends Course>(course: C, edited: Partial<C> | null): C | null {
  if (!edited) return null;
  const some = (Object.keys(edited) as (keyof C)[]).some((key) => !same(edited[key], course[key]));
  return some ? { ...course, ...edited } : null;
}

/** Whether two trees, or triples of trees, are equal, as N and P − C are for a sphere. */
function same(a: unknown, b: unknown): boolean {
  if (!Array.isArray(a) || !Array.isArray(b)) return JSON.stringify(a) === JSON.stringify(b);
  return a.length === b.length && a.every((x, i) => same(x, b[i]));
}
