import { exact } from './arithmetic/exact.ts';
import type { Surd } from './exact/surd.ts';
import { evaluate, type Values } from './formula/evaluate.ts';
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

/** How many of the figure's conditions hold with equality where the line meets its plane; exact. */
export function borderConditions(shape: Shape, ray: Ray): number {
  const { formula, values } = exactly(shape, ray);
  if (!formula?.bound) return 0;
  const rate = evaluate(formula.rate, exact, values);
  if (exact.sign(rate) === 0) return 0;
  const t = evaluate(formula.t, exact, values);
  const { E, d } = values.vectors as Record<'E' | 'd', readonly [Surd, Surd, Surd]>;
  const at = (i: 0 | 1 | 2): Surd => exact.add(E[i], exact.mul(t, d[i]));
  const placed = withPoint(values, [at(0), at(1), at(2)]);
  return formula.bound.conditions.filter(({ left, right }) => {
    const difference = exact.sub(evaluate(left, exact, placed), evaluate(right, exact, placed));
    return exact.sign(difference) === 0;
  }).length;
}

/** Null where the line is not in the figure's plane, or passes beside the figure. */
export function spanInFigure(shape: Shape, ray: Ray): Span | null {
  const { formula, values } = exactly(shape, ray);
  if (!formula?.bound) return null;
  const isZero = (tree: FlatFormula['rate']): boolean =>
    exact.sign(evaluate(tree, exact, values)) === 0;
  if (!isZero(formula.rate) || !isZero(formula.offset)) return null;
  const span = formula.bound.span(values, exact);
  if (!span) return null;
  const [from, to] = span;
  return {
    from: exact.toNumber(from),
    to: exact.toNumber(to),
    sides: [exact.sign(from) as Sign, exact.sign(to) as Sign],
    touches: exact.sign(exact.sub(to, from)) === 0,
  };
}

function exactly(shape: Shape, ray: Ray): { formula: FlatFormula | null; values: Values<Surd> } {
  const formula = definitionOf(shape).formula(shape);
  return {
    formula: formula.family === 'flat' ? formula : null,
    values: valuesOf(shape, ray, exact),
  };
}
