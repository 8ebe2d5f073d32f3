import type { Expr } from '../../math/formula.ts';
import type { Vec3 } from '../../math/index.ts';
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
  readonly pixel?: Pixel;
  /** Further rays that the question is about, each with its shape. */
  readonly more?: readonly Input[];
  /** A scene of the registry, by its id, and the effects and reasons that are offered. */
  readonly scene?: {
    readonly id: string;
    readonly effects: readonly string[];
    readonly reasons: readonly string[];
  };
}

/** A pixel of a picture, and where the picture stands in the world. */
export interface Pixel {
  /** From 0 at the left, and from 0 at the top. */
  readonly column: number;
  readonly row: number;
  readonly columns: number;
  readonly rows: number;
  /** Side of a pixel. */
  readonly side: number;
  /** Middle of the picture. */
  readonly middle: Vec3;
  /** Unit vectors along its rows and columns. */
  readonly right: Vec3;
  readonly up: Vec3;
}

/** Something that a question gives besides ray, shape and quantities of the derivation. */
export interface Told {
  readonly name: string;
  readonly says: string;
}

/** The way to a question's numbers, for a course system that computes them itself. */
export interface Lines {
  readonly scalars: Readonly<Record<string, number>>;
  /** Each line by the letter that later ones have for it, which is a field's id. */
  readonly trees: readonly (readonly [letter: string, tree: Expr])[];
  /** Two roots in ascending order, by one tree with ±. */
  readonly pair?: { readonly letters: readonly [string, string]; readonly tree: Expr };
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
  /** What its questions are about, if not a shape: 'camera'. */
  readonly subject?: string;
  /** What stands beside the question, if not the scene of ray and shape. */
  readonly picture?: 'graph' | 'pixels' | 'none';
  /** Which of E, d and the shape's numbers the question does not give. */
  readonly hidden?: 'all' | 'all but E';
  /** Whether its numbers come out as small fractions, so that it can be solved on paper. */
  readonly paper: boolean;
  readonly kinds: readonly ShapeKind[];
  /** Absent where no field is a choice that could be guessed. */
  readonly spread?: Spread;
  /**
   * Null if the drawn numbers do not suit the exercise; the caller draws again. If a class of the
   * spread is wanted, it may draw that alone.
   */
  draw(random: Random, kind: ShapeKind, level: Level, wanted?: string): Draft | null;
  /** The question in one or two sentences; ray, shape and given values are shown beside it. */
  ask(draft: Draft): string;
  /** Whether the draft's parameter is asked for, so that it is hidden until it is solved. */
  readonly asksForParam?: true;
  /** Quantities that the question gives. */
  readonly given: readonly string[];
  /** What it gives besides. */
  told?(draft: Draft): readonly Told[];
  /** What its picture shows, in words, for those who have only the text. */
  described?(draft: Draft): string;
  /** The right course with the lines that only this exercise asks for. */
  extend?(course: Course): Course;
  fields(draft: Draft, truth: Answers): readonly Field[];
  /** Answers from ray and shape, or from the values in `own`: given ones, or the student's. */
  answers(course: Course, draft: Draft, own?: Answers): Answers;
  /** Words for the hints and the solution beside the lines of the derivation. */
  argue?(draft: Draft, found: Answers): Argument;
  /**
   * How STACK computes what is asked: 'from the ray' where A, B, C, D or two roots are asked for;
   * lines of its own; absent where there is nothing to compute.
   */
  readonly stack?: 'from the ray' | ((course: Course, draft: Draft) => Lines);
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
