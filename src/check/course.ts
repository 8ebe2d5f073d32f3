import {
  DISCRIMINANT,
  DOUBLE_ROOT,
  type Expr,
  type ExprTriple,
  LINEAR_ROOT,
  POINT,
  type Relation,
  ROOTS,
} from '../math/formula.ts';
import type { Shape } from '../math/index.ts';
import { definitionOf, type Formula } from '../math/shapes.ts';

/** The decisions that the course makes besides its formulas. A misconception may change one. */
export interface Rules {
  /** D = 0 is one point (a tangent), or taken for a miss; or |D| below 10⁻⁶ is taken for 0. */
  readonly tangent: 'counts' | 'lost' | 'epsilon';
  /** A root with t < 0 is no visible hit, or is taken for one. */
  readonly behind: 'rejected' | 'accepted';
  /** t1 is the smaller root, or the larger one. */
  readonly order: 'ascending' | 'descending';
  /** Which of the roots in front of E is the first visible hit. */
  readonly first: 'nearest' | 'farthest';
  /**
   * A = 0 is a case of its own, or put into the formula for the roots; or |A| below 10⁻⁶ is taken
   * for 0.
   */
  readonly linear: 'handled' | 'ignored' | 'epsilon';
  /** A cone has two nappes, or only the upper one. */
  readonly nappes: 'both' | 'upper';
  /** For N·d = 0: asked whether E is in the plane, or one answer for all. */
  readonly parallel: 'asked' | 'always beside' | 'always in';
  /** A light at t = 1 is hidden by what lies before it, or by anything on the ray. */
  readonly light: 'bounds' | 'forgotten';
  /** Where digits go is measured line by line, or always laid on the formula for the roots. */
  readonly loss: 'measured' | 'always t';
}

const RULES: Rules = {
  tangent: 'counts',
  behind: 'rejected',
  order: 'ascending',
  first: 'nearest',
  linear: 'handled',
  nappes: 'both',
  parallel: 'asked',
  light: 'bounds',
  loss: 'measured',
};

/** Lines and decisions besides ray and shape, in the course of an exercise that asks for them. */
interface Extras {
  /** d of a pixel's ray. */
  readonly pixel?: ExprTriple;
  /** D from A and F, the value of f where it turns. */
  readonly read?: Expr;
  /** A root counts if its point's height lies between the ends, if its t does, or always. */
  readonly ends?: 'height' | 't' | 'forgotten';
  /** Hits of two surfaces come in the order of t, or all of one before those of the other. */
  readonly meetings?: 'by t' | 'by surface';
}

/** Every line that a student writes for a curved shape, as trees. */
export interface CurvedCourse extends Extras {
  readonly family: 'curved';
  readonly A: Expr;
  readonly B: Expr;
  readonly C: Expr;
  readonly D: Expr;
  readonly roots: Expr;
  readonly double: Expr;
  readonly linear: Expr;
  readonly P: ExprTriple;
  readonly N: ExprTriple;
  readonly rules: Rules;
}

/** Every line that a student writes for a flat shape, as trees. */
export interface FlatCourse extends Extras {
  readonly family: 'flat';
  readonly rate: Expr;
  readonly offset: Expr;
  readonly t: Expr;
  readonly P: ExprTriple;
  readonly conditions: readonly Relation[];
  readonly rules: Rules;
}

export type Course = CurvedCourse | FlatCourse;

/** Cache: a shape's trees are the same objects each time (a square's for each axis). */
const made = new WeakMap<Formula, Course>();

/** The right formulas and rules for this shape. */
export function courseOf(shape: Shape): Course {
  const formula = definitionOf(shape).formula(shape);
  const known = made.get(formula);
  if (known) return known;
  const course = courseWith(formula);
  made.set(formula, course);
  return course;
}

function courseWith(formula: Formula): Course {
  if (formula.family === 'flat') {
    const { family, rate, offset, t, bound } = formula;
    return { family, rate, offset, t, P: POINT, conditions: bound?.conditions ?? [], rules: RULES };
  }
  const { family, A, B, C, normal } = formula;
  return {
    family,
    ...{ A, B, C, D: DISCRIMINANT, roots: ROOTS, double: DOUBLE_ROOT, linear: LINEAR_ROOT },
    P: POINT,
    N: normal,
    rules: RULES,
  };
}
