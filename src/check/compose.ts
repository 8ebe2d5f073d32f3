import { type Random, seeded } from '../math/rng.ts';
import type { ShapeKind } from '../math/shapes.ts';
import { type Course, courseOf } from './course.ts';
import { type AnswerKey, derivationOf } from './derivation.ts';
import type { Draft, Exercise, Level } from './exercises/define.ts';
import { alike } from './grade.ts';
import type { Misconception } from './misconceptions/define.ts';
import { findMisconception } from './misconceptions/index.ts';
import type { Answers, Field } from './types.ts';
import { work } from './work.ts';

/** A misconception with the answers that it gives for an input. */
interface Suspect {
  readonly misconception: Misconception;
  readonly answers: Answers;
}

/**
 * A question with its numbers, the right answers, and those of the misconceptions it watches for.
 */
export interface Posed {
  readonly exercise: Exercise;
  readonly draft: Draft;
  readonly fields: readonly Field[];
  readonly truth: Answers;
  /** Quantities that are given beside ray and shape. */
  readonly given: Answers;
  readonly suspects: readonly Suspect[];
}

/** The question as a derivation that starts from what is given. */
export function derivationFor({ exercise, draft, fields, given }: Posed): AnswerKey {
  const answers = (course: Course, own: Answers): Answers =>
    exercise.answers(course, draft, { ...given, ...own });
  return derivationOf(fields, courseFor(exercise, draft), draft.watch, answers);
}

/** Cache, so that a course's edits are made once. */
const extended = new WeakMap<Exercise, WeakMap<Course, Course>>();

/** The right formulas and rules, with the lines that only this exercise asks for. */
export function courseFor(exercise: Exercise, { shape }: Draft): Course {
  const plain = courseOf(shape);
  if (!exercise.extend) return plain;
  const own = extended.get(exercise) ?? new WeakMap<Course, Course>();
  extended.set(exercise, own);
  const known = own.get(plain) ?? exercise.extend(plain);
  own.set(plain, known);
  return known;
}

/**
 * Largest count of random numbers for one question; an exercise that needs more cannot be posed.
 * The exercises here need 200,000 at most (tangent, hyperboloid); this limit takes some seconds.
 */
const MOST_NUMBERS = 3_000_000;

/**
 * Largest count of random numbers for a question of a wanted class; a shape may have no such
 * question. About half a second.
 */
const MOST_FOR_A_CLASS = 1_500_000;

/**
 * The question of a seed, the same on every machine.
 *
 * @param wanted classes of the exercise's spread, the first one that is found counts.
 * @throws RangeError if the exercise cannot be posed about this kind of shape.
 */
export function pose(
  exercise: Exercise,
  kind: ShapeKind,
  seed: number,
  level: Level,
  wanted: readonly string[] = [],
): Posed {
  for (const one of wanted) {
    const posed = posedIn(one, exercise, kind, seed, level);
    if (posed) return posed;
  }
  const random = atMost(MOST_NUMBERS, seeded(seed), () => {
    throw new RangeError(`no input for ${exercise.id}, ${kind}, seed ${seed}`);
  });
  for (;;) {
    const posed = tryPose(exercise, kind, level, random);
    if (posed) return posed;
  }
}

/** The first question of this class; null if there is none within `MOST_FOR_A_CLASS`. */
function posedIn(
  wanted: string,
  exercise: Exercise,
  kind: ShapeKind,
  seed: number,
  level: Level,
): Posed | null {
  const end = new RangeError();
  const random = atMost(MOST_FOR_A_CLASS, seeded(seed), () => {
    throw end;
  });
  try {
    for (;;) {
      const posed = tryPose(exercise, kind, level, random, wanted);
      if (posed && exercise.spread?.of(posed.draft, posed.truth) === wanted) return posed;
    }
  } catch (error) {
    if (error !== end) throw error;
    return null;
  }
}

function atMost(most: number, random: Random, exceeded: () => never): Random {
  let count = 0;
  return () => {
    count++;
    return count > most ? exceeded() : random();
  };
}

function tryPose(
  exercise: Exercise,
  kind: ShapeKind,
  level: Level,
  random: Random,
  wanted?: string,
): Posed | null {
  const draft = exercise.draw(random, kind, level, wanted);
  return draft && posedOf(exercise, draft);
}

/**
 * The question about this input; null unless all misconceptions in `watch` give answers that differ
 * from the right ones and from each other. Adding to a `watch` list changes what old seeds pose.
 */
function posedOf(exercise: Exercise, draft: Draft): Posed | null {
  const course = courseFor(exercise, draft);
  const truth = exercise.answers(course, draft);
  const fields = exercise.fields(draft, truth);
  const asked = fields.filter(({ id, mayBeAbsent }) => !mayBeAbsent || truth[id] !== undefined);
  const complete = (answers: Answers): boolean =>
    asked.length > 0 && asked.every(({ id }) => answers[id] !== undefined);
  if (!complete(truth)) return null;
  const suspects = draft.watch.flatMap((id): Suspect[] => {
    const misconception = findMisconception(id);
    const edited = misconception?.edit(course);
    if (!misconception || !edited) return [];
    const answers = exercise.answers(edited, draft);
    return complete(answers) ? [{ misconception, answers }] : [];
  });
  const told = [truth, ...suspects.map(({ answers }) => answers)];
  const apart = told.every((a, i) => told.slice(0, i).every((b) => !alike(asked, a, b)));
  if (!apart) return null;
  const all = exercise.given.length > 0 ? work(course, draft) : {};
  const given = Object.fromEntries(
    exercise.given.flatMap((id) => (all[id] === undefined ? [] : [[id, all[id]] as const])),
  );
  return { exercise, draft, fields, truth, given, suspects };
}
