import type { Random } from '../../math/rng.ts';
import type { ShapeKind } from '../../math/shapes.ts';
import type { Course } from '../course.ts';
import type { Answers, Field, Input } from '../types.ts';

/** From whole numbers and one axis at a time to halves and everything at once. */
export type Level = 1 | 2 | 3;

/** An input that a question may be asked about. */
export interface Draft extends Input {
  /**
   * The mistakes that this input is to tell apart; one that these formulas have no room for is
   * passed over.
   */
  readonly watch: readonly string[];
  /** The parameter that the question turns, with its value in `shape`. */
  readonly param?: { readonly symbol: string; readonly key: string; readonly value: number };
}

/** How the lines are to be read. */
export interface Argument {
  /** With the second hint: the rule in words; '' where the lines say it. */
  readonly rule: string;
  /** The third hint where the lines with numbers would be none, or too much; '' for those lines. */
  readonly put: string;
  /** The end of the solution: why its answers follow. The answers themselves come after it. */
  readonly decision: readonly string[];
}

/**
 * A kind of question: how it is drawn, what is asked, and what the (right or edited) formulas
 * answer.
 */
export interface Exercise {
  readonly id: string;
  /** Name of the exercise in the summary. */
  readonly topic: string;
  /** Meant for paper: numbers come out as small fractions. */
  readonly paper: boolean;
  readonly kinds: readonly ShapeKind[];
  /** Null if the drawn numbers do not suit the exercise; the caller draws again. */
  draw(random: Random, kind: ShapeKind, level: Level): Draft | null;
  /** One or two sentences; ray, shape and what is given stand beside it. */
  ask(draft: Draft): string;
  /**
   * Whether the draft's parameter is what is asked for: it is shown nowhere before the question is
   * solved.
   */
  readonly asksForParam?: true;
  /** Quantities that the question gives. */
  readonly given: readonly string[];
  fields(draft: Draft, truth: Answers): readonly Field[];
  /** From the start, or from what is given and what a student already has. */
  answers(course: Course, draft: Draft, own?: Answers): Answers;
  /** Words for the hints and the solution beside the lines of the derivation. */
  argue?(draft: Draft, found: Answers): Argument;
  /** The first hint, in words. */
  readonly clue: string;
  /** The lines of the derivation that it is about: A, B, C, D, t, P, N, N.d, N.(E-P), inside. */
  readonly lines: readonly string[];
}

export const CASES = [
  { id: 'none', title: 'no point' },
  { id: 'tangent', title: 'one point: it touches' },
  { id: 'one', title: 'one point: it crosses' },
  { id: 'two', title: 'two points' },
  { id: 'contained', title: 'the whole line' },
] as const;
