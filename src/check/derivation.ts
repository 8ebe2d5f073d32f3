import type { Course } from './course.ts';
import { agrees, type ReadAnswer } from './grade.ts';
import type { Misconception } from './misconceptions/define.ts';
import { ALL_MISCONCEPTIONS } from './misconceptions/index.ts';
import { ABSENT, type Answers, type Field } from './types.ts';
import type { Way } from './ways.ts';

/** A line that a student wrote. */
export interface WrittenLine {
  readonly field: Field;
  readonly given: ReadAnswer;
}

/** The fields of a question, and the answers that right or edited formulas give for them. */
export interface AnswerKey {
  /** In the order of the derivation: a line depends on lines before it only. */
  readonly fields: readonly Field[];
  readonly course: Course;
  /** Ids of the misconceptions that the input tells apart; preferred if others give the same. */
  readonly watch: readonly string[];
  /** Answers of these formulas from ray and shape. */
  truth(course: Course): Answers;
  /** Answers of these formulas from the student's own earlier values. */
  next(course: Course, own: Answers): Answers;
}

/** A derivation that caches what it computes. */
export function derivationOf(
  fields: readonly Field[],
  course: Course,
  watch: readonly string[],
  answers: (course: Course, own: Answers) => Answers,
): AnswerKey {
  const known = new WeakMap<Course, Answers>();
  return {
    fields,
    course,
    watch,
    next: answers,
    truth(edited) {
      const found = known.get(edited) ?? answers(edited, {});
      known.set(edited, found);
      return found;
    },
  };
}

const edits = new WeakMap<Course, ReadonlyMap<Misconception, Course>>();

/** Every misconception that applies to these formulas, with the edited formulas. */
export function mistakesIn(course: Course): ReadonlyMap<Misconception, Course> {
  const known = edits.get(course);
  if (known) return known;
  const made = new Map<Misconception, Course>();
  for (const misconception of ALL_MISCONCEPTIONS) {
    const edited = misconception.edit(course);
    if (edited) made.set(misconception, edited);
  }
  edits.set(course, made);
  return made;
}

const ways = new WeakMap<Course, Map<Way, Course | null>>();

/** The course with a way's lines; cached, unless the way depends on what was typed. */
export function wayBy({ course, truth }: AnswerKey, way: Way, own: Answers): Course | null {
  if (way.isOwn) return way.edit(course, own, truth(course));
  const known = ways.get(course) ?? new Map<Way, Course | null>();
  ways.set(course, known);
  const found = known.get(way) ?? way.edit(course, own, truth(course));
  known.set(way, found);
  return found;
}

/** Whether these formulas give line `i`, from the start or from the student's earlier lines. */
export function fits(
  { truth, next }: AnswerKey,
  course: Course,
  lines: readonly WrittenLine[],
  i: number,
): boolean {
  const line = lines[i];
  if (!line) return false;
  const { field, given } = line;
  const fromStart = truth(course);
  if (agrees(field, given, fromStart[field.id])) return true;
  // The student's own values lead to another result only if an earlier line differs.
  const leadsElsewhere = lines.slice(0, i).some((one) => !isSame(one, fromStart));
  return leadsElsewhere && agrees(field, given, next(course, before(lines, i))[field.id]);
}

/** Relative tolerance: below any digit that is typed, above the rounding of doubles. */
const EXACT = 1e-12;

function isSame({ field, given: { value } }: WrittenLine, answers: Answers): boolean {
  const truth = answers[field.id] ?? ABSENT;
  const near = (x: number, y: number | undefined): boolean =>
    y !== undefined && Math.abs(x - y) <= EXACT * Math.abs(y);
  if (typeof value === 'number') return typeof truth === 'number' && near(value, truth);
  if (typeof value === 'string') return value === truth;
  return typeof truth === 'object' && value.every((x, k) => near(x, truth[k]));
}

/** The values of the lines before line `i`. */
export const before = (lines: readonly WrittenLine[], i: number): Answers =>
  Object.fromEntries(lines.slice(0, i).map(({ field, given }) => [field.id, given.value]));
