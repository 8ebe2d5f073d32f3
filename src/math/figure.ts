import { type TypedNumber, typed } from './arithmetic/typed.ts';
import { evaluate, type Triple, type Values } from './formula/evaluate.ts';
import type { Sign } from './intersection.ts';
import { valuesOf } from './methods/tree-method.ts';
import type { Ray } from './ray.ts';
import type { Shape } from './shapes/index.ts';
import { definitionOf } from './shapes/lookup.ts';
import { type FlatFormula, withPoint } from './shapes/planar.ts';

/** From which t to which t a line in a figure's plane is in the figure, both included. */
export interface Span {
  readonly from: number;
  readonly to: number;
  /** Signs of the exact ends: one that is rounded to 0 need not be 0. */
  readonly sides: readonly [Sign, Sign];
  /** Both ends are one point: the line touches the rim or a corner. */
  readonly touches: boolean;
}

/**
 * How many of the figure's conditions hold with equality where the line meets its plane: 1 on a rim
 * or an edge, 2 in a corner. 0 for a curved shape, and for a ray along the plane.
 *
 * @param shape as for `intersect`, and so is the ray.
 * @param given its numbers as typed, by symbol; the stored ones where there are none.
 * @returns a whole number.
 * @see NUMERICS.md, section 1: the conditions of circle and square.
 * @example
 * const square = { kind: 'square', corner: [0, 0, 0], side: 1, axis: 'z' } as const;
 * borderConditions(square, { origin: [1, 1, 2], direction: [0, 0, -1] }); // → 2
 */
export function borderConditions(shape: Shape, ray: Ray, given?: Values<TypedNumber>): number {
  const { formula, values } = exactly(shape, ray, given);
  if (!formula?.bound) return 0;
  const rate = evaluate(formula.rate, typed, values);
  if (typed.sign(rate) === 0) return 0;
  const t = evaluate(formula.t, typed, values);
  const { E, d } = values.vectors as Record<'E' | 'd', Triple<TypedNumber>>;
  const at = (i: 0 | 1 | 2): TypedNumber => typed.add(E[i], typed.mul(t, d[i]));
  const placed = withPoint(values, [at(0), at(1), at(2)]);
  return formula.bound.conditions.filter(({ left, right }) => {
    const difference = typed.sub(evaluate(left, typed, placed), evaluate(right, typed, placed));
    return typed.sign(difference) === 0;
  }).length;
}

/**
 * Where a line in the figure's plane is in the figure; null where it is not in that plane, or
 * passes beside.
 *
 * @param shape as for `intersect`, and so is the ray.
 * @param given its numbers as typed, by symbol; the stored ones where there are none.
 * @returns t in lengths of d.
 * @see NUMERICS.md, section 1: the conditions of circle and square.
 * @example
 * const square = { kind: 'square', corner: [0, 0, 0], side: 1, axis: 'z' } as const;
 * spanInFigure(square, { origin: [-1, 0.5, 0], direction: [1, 0, 0] });
 * // → { from: 1, to: 2, sides: [1, 1], touches: false }
 */
export function spanInFigure(shape: Shape, ray: Ray, given?: Values<TypedNumber>): Span | null {
  const { formula, values } = exactly(shape, ray, given);
  if (!formula?.bound) return null;
  const isZero = (tree: FlatFormula['rate']): boolean =>
    typed.sign(evaluate(tree, typed, values)) === 0;
  if (!isZero(formula.rate) || !isZero(formula.offset)) return null;
  const span = formula.bound.span(values, typed);
  if (!span) return null;
  const [from, to] = span;
  return {
    from: typed.toNumber(from),
    to: typed.toNumber(to),
    sides: [typed.sign(from) as Sign, typed.sign(to) as Sign],
    touches: typed.sign(typed.sub(to, from)) === 0,
  };
}

/** The numbers that are stored in shape and ray, or those that are `given` in their place. */
function exactly(
  shape: Shape,
  ray: Ray,
  given: Values<TypedNumber> | undefined,
): { formula: FlatFormula | null; values: Values<TypedNumber> } {
  const formula = definitionOf(shape).formula(shape);
  return {
    formula: formula.family === 'flat' ? formula : null,
    values: given ?? valuesOf(shape, ray, typed),
  };
}
