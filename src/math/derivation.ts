import { float64 } from './arithmetic/float64.ts';
import { DISCRIMINANT, DOUBLE_ROOT, F_OF_T, LINEAR_ROOT, ROOTS } from './formula/common.ts';
import { evaluate, type Values, withScalars } from './formula/evaluate.ts';
import { type Expr, plus, type Relation, scalar, times } from './formula/expr.ts';
import type { CurvedDetails, FlatDetails, Intersection } from './intersection.ts';
import { valuesOf } from './methods/tree-method.ts';
import type { Ray } from './ray.ts';
import type { CurvedFormula } from './shapes/axial-quadric.ts';
import type { Shape } from './shapes/index.ts';
import { definitionOf } from './shapes/lookup.ts';
import { type FlatFormula, withPoint } from './shapes/planar.ts';

/**
 * One line of the algebra: what it is called, its tree, and the value that the kernel itself used.
 */
export interface DerivationStep {
  /** Name of the step and of the quantity: A, B, C, D, t, N.(E-P), N.d. */
  readonly id: string;
  /** What stands left of the equals sign, where it is not the tree itself. */
  readonly letter: Expr | null;
  readonly expr: Expr;
  /** Null where the value is told hit by hit (t). */
  readonly value: number | null;
  /** Whether the numbers are put in with −B, √D and 2A already worked out. */
  readonly worked: boolean;
  /** The step of the walk (`walkOf`) that says where the line comes from, from 1. */
  readonly why: number;
}

/**
 * How many steps the walk of a shape has, without making them.
 *
 * @param shape its present parameters decide which trees it has.
 * @returns a whole number.
 * @see NUMERICS.md, section 1
 * @example
 * walkLength({ kind: 'plane', normal: [1, 0, 0], point: [0, 0, 0] }); // → 4
 */
export function walkLength(shape: Shape): number {
  const formula = definitionOf(shape).formula(shape);
  return formula.family === 'curved' ? 8 : formula.bound ? 5 : 4;
}

/** A condition of a figure with its numbers, in the unit of its two sides. */
export interface ConditionStep {
  readonly relation: Relation;
  readonly left: number;
  readonly right: number;
  /** By the method itself, not by comparing the two rounded numbers; null where it cannot tell. */
  readonly holds: boolean | null;
}

/** The lines from a surface's equation to t. */
export interface Derivation {
  readonly surface: Relation;
  /** What the equation becomes with the ray put in: f(t) = 0. */
  readonly f: Expr;
  readonly steps: readonly DerivationStep[];
  /** The line of t as it stands before anything is known of this ray: the same for all of them. */
  readonly unknown: DerivationStep;
  readonly conditions: readonly ConditionStep[];
  /** The numbers that the symbols stand for. */
  readonly numbers: Values<number>;
}

/**
 * The named steps from the surface's equation to t, with the numbers of the intersection that was
 * computed.
 *
 * @param shape as for `intersect`, and so is the ray.
 * @param found what `intersect` said of them, by any method: its numbers are shown.
 * @throws RangeError for an intersection of another family of shapes (flat, curved).
 * @example
 * const cylinder = { kind: 'cylinder', center: [0, 0, 0], radius: 5 } as const;
 * const ray = { origin: [-10, 0, 3], direction: [1, 0, 0] } as const;
 * const { steps } = derivation(cylinder, ray, intersect(cylinder, ray));
 * steps.map(({ id, value }) => [id, value]);
 * // → [['A', 1], ['B', -20], ['C', 84], ['D', 64], ['t', null]]
 */
export function derivation(shape: Shape, ray: Ray, found: Intersection): Derivation {
  const definition = definitionOf(shape);
  const formula = definition.formula(shape);
  const numbers = valuesOf(shape, ray, float64);
  const { details } = found;
  if (formula.family === 'curved' && details.family === 'curved') {
    return { surface: definition.surface, ...curved(formula, details, found, numbers) };
  }
  if (formula.family === 'flat' && details.family === 'flat') {
    return { surface: definition.surface, ...flat(formula, details, numbers) };
  }
  throw new RangeError('an intersection of another family of shapes');
}

type Body = Omit<Derivation, 'surface'>;

const lineOfT = (expr: Expr, why: number): DerivationStep => ({
  ...{ id: 't', letter: scalar('t'), expr, value: null, worked: true, why },
});

function curved(
  formula: CurvedFormula,
  details: CurvedDetails,
  found: Intersection,
  values: Values<number>,
): Body {
  const { A, B, C, D } = details;
  const line = (id: 'A' | 'B' | 'C' | 'D', expr: Expr): DerivationStep => ({
    id,
    letter: scalar(id),
    expr,
    value: details[id],
    worked: false,
    why: id === 'D' ? 6 : 5,
  });
  const linear = details.signs.A === 0;
  const roots = linear ? LINEAR_ROOT : details.signs.D === 0 ? DOUBLE_ROOT : ROOTS;
  return {
    f: F_OF_T,
    steps: [
      line('A', formula.A),
      line('B', formula.B),
      line('C', formula.C),
      line('D', DISCRIMINANT),
      ...(found.hits.length > 0 ? [lineOfT(roots, 7)] : []),
    ],
    unknown: lineOfT(ROOTS, 7),
    conditions: [],
    numbers: withScalars(values, { A, B, C, D }),
  };
}

function flat(formula: FlatFormula, details: FlatDetails, values: Values<number>): Body {
  const { offset, rate, plane } = details;
  const step = (id: string, expr: Expr, value: number): DerivationStep => ({
    id,
    letter: null,
    expr,
    value,
    worked: false,
    why: 3,
  });
  const numbers = plane ? withPoint(values, plane.point) : values;
  const unknown = lineOfT(formula.t, 4);
  return {
    f: plus(times(formula.rate, scalar('t')), formula.offset),
    steps: [
      step('N.(E-P)', formula.offset, offset),
      step('N.d', formula.rate, rate),
      ...(plane ? [unknown] : []),
    ],
    unknown,
    conditions: plane && formula.bound ? conditionSteps(formula, plane.holds, numbers) : [],
    numbers,
  };
}

/** The two sides of each condition in doubles, to be read; the verdict is the method's own. */
function conditionSteps(
  { bound }: FlatFormula,
  holds: readonly (boolean | null)[],
  numbers: Values<number>,
): ConditionStep[] {
  return (bound?.conditions ?? []).map((relation, i) => {
    const left = evaluate(relation.left, float64, numbers);
    const right = evaluate(relation.right, float64, numbers);
    return { relation, left, right, holds: holds[i] ?? null };
  });
}
