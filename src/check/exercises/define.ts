import type { Random } from '../../math/rng.ts';
import type { ShapeKind } from '../../math/shapes.ts';
import type { Course } from '../course.ts';
import type { Answers, Field, Input } from '../types.ts';

/** Difficulty of the numbers, from whole ones along one axis to halves in all coordinates. */
export type Level = 1 | 2 | 3;

/** An input that a question may be asked about. */
export interface Draft extends Input {
  /** Ids of the misconceptions to tell apart; those that do not apply to the shape are ignored. */
  readonly watch: readonly string[];
  /** The parameter that the question is about, with its value in `shape`. */
  readonly param?: { readonly symbol: string; readonly key: string; readonly value: number };
}

/** Words for the hints and the solution of a question. */
export interface Argument {
  /** The rule in words, beside the lines of the second hint; '' if the lines say it. */
  readonly rule: string;
  /** The third hint in words instead of lines with numbers; '' for the lines. */
  readonly put: string;
  /** Sentences before the answers in the solution: why they follow. */
  readonly decision: readonly string[];
}

/**
 * The classes that questions of an exercise fall into. Sessions of newer sets have each as often as
 * the others, as far as the shape has them, so that no answer is a good guess.
 */
interface Spread {
  readonly classes: readonly string[];
  /** Classes that a shape cannot have; to find none takes long. */
  readonly without?: Readonly<Partial<Record<ShapeKind, readonly string[]>>>;
  of(draft: Draft, truth: Answers): string;
}

/** The classes of a choice's right answers. */
export const spreadOver = (
  field: string,
  classes: readonly string[],
  without: Spread['without'] = {},
): Spread => ({
  classes,
  without,
  of: (_, truth) => String(truth[field]),
});

/** A kind of question: how it is drawn, what it asks, and what right or edited formulas answer. */
export interface Exercise {
  /** A word; a later version of it, which draws other questions, has its number: 'nappes.2'. */
  readonly id: string;
  /** Name of the exercise in the summary. */
  readonly topic: string;
  /** Whether its numbers come out as small fractions, so that it can be solved on paper. */
  readonly paper: boolean;
  readonly kinds: readonly ShapeKind[];
  /** Absent where no field is a choice that could be guessed. */
  readonly spread?: Spread;
  /** Null if the drawn numbers do not suit the exercise; the caller draws again. */
  draw(random: Random, kind: ShapeKind, level: Level): Draft | null;
  /** The question in one or two sentences; ray, shape and given values are shown beside it. */
  ask(draft: Draft): string;
  /** Whether the draft's parameter is asked for, so that it is hidden until it is solved. */
  readonly asksForParam?: true;
  /** Quantities that the question gives. */
  readonly given: readonly string[];
  fields(draft: Draft, truth: Answers): readonly Field[];
  /** Answers from ray and shape, or from the values in `own`: given ones, or the student's. */
  answers(course: Course, draft: Draft, own?: Answers): Answers;
  /** Words for the hints and the solution beside the lines of the derivation. */
  argue?(draft: Draft, found: Answers): Argument;
  /** The first hint, in words. */
  readonly clue: string;
  /** Ids of the derivation's lines that it is about: A, B, C, D, t, P, N, N.d, N.(E-P), inside. */
  readonly lines: readonly string[];
}

export const CASES = [
  { id: 'none', title: 'no point' },
  { id: 'tangent', title: 'one point: it touches' },
  { id: 'one', title: 'one point: it crosses' },
  { id: 'two', title: 'two points' },
  { id: 'contained', title: 'the whole line' },
] as const;
