import { type Ratio, ratios } from './arithmetic/ratios.ts';
import { DISCRIMINANT, DOUBLE_ROOT } from './formula/common.ts';
import { evaluate } from './formula/evaluate.ts';
import { type Expr, minus, num, over, scalar, squared, type Term, times } from './formula/expr.ts';
import { termsOf } from './formula/ray-substitution.ts';
import type { Sign } from './intersection.ts';
import { valuesOf } from './methods/tree-method.ts';
import type { Ray } from './ray.ts';
import type { ShapeDefinition } from './shapes/define.ts';
import type { Shape } from './shapes/index.ts';
import { definitionOf } from './shapes/lookup.ts';
import { AXES, type Axis, axisIndex, type Vec3 } from './vec3.ts';

/** Where a line is nearest to the axis or the centre of a round surface. */
interface Closest {
  /** In lengths of d: −B/2A. */
  readonly t: number;
  /** The line's point there, and what it is nearest to, on the axis or the centre. */
  readonly point: Vec3;
  readonly foot: Vec3;
  /** The coordinates in which the surface is round: two about an axis, three about a centre. */
  readonly round: readonly Axis[];
  readonly distance: number;
  readonly radius: number;
  /** Of radius − distance, exactly: the sign of D. */
  readonly sign: Sign;
}

type RatioValues = ReturnType<typeof valuesOf<Ratio>>;

/** Of a term k·(…)² of an equation, its sign, k as a number, and what is squared. */
function squareIn({ sign, expr }: Term, { scalars }: RatioValues) {
  if (expr.op === 'square') return { factor: ratios.of(sign), of: expr.of };
  const [first, second, ...more] = expr.op === 'product' ? expr.factors : [];
  const k = first?.op === 'scalar' ? scalars[first.id] : undefined;
  if (!k || second?.op !== 'square' || more.length > 0) return null;
  return { factor: ratios.mul(ratios.of(sign), k), of: second.of };
}

/** Of (x − Cx), x and C. */
function coordinateIn(expr: Expr) {
  const [at, from, ...more] = expr.op === 'sum' ? expr.terms : [];
  const isPlain = at?.sign === 1 && from?.sign === -1 && more.length === 0;
  if (!isPlain || at.expr.op !== 'scalar' || from.expr.op !== 'component') return null;
  return at.expr.id === from.expr.axis ? from.expr : null;
}

/**
 * (x − Cx)² + (z − Cz)² − r² = 0, by its tree and the values of its factors (a hyperboloid is a
 * cylinder for a = 0, a sphere for a = −1): in which coordinates it is round, about what, and r;
 * null for any other surface.
 */
function roundAbout({ left, right }: ShapeDefinition<Shape>['surface'], given: RatioValues) {
  const all = [...termsOf(left, 1), ...termsOf(right, -1)].map((term) => squareIn(term, given));
  const used = all.filter((one) => one === null || ratios.sign(one.factor) !== 0);
  const isFactor = (x: Ratio, y: 1 | -1): boolean => ratios.sign(ratios.sub(x, ratios.of(y))) === 0;
  const radii = used.flatMap((one) => (one?.of.op === 'scalar' ? [one] : []));
  const found = used.flatMap((one) => {
    const at = one && isFactor(one.factor, 1) && coordinateIn(one.of);
    return at ? [at] : [];
  });
  const [radius] = radii;
  const [first] = found;
  if (!radius || !first || !isFactor(radius.factor, -1)) return null;
  if (radii.length + found.length !== used.length || radii.length > 1) return null;
  if (!found.every(({ vector }) => vector === first.vector)) return null;
  const round = AXES.filter((axis) => found.some((one) => one.axis === axis));
  return round.length === found.length
    ? { center: first.vector, axes: round, radius: radius.of }
    : null;
}

/**
 * The line's closest approach to the axis of a cylinder or the centre of a sphere, or of whatever
 * surface says by its tree that it is round: f at its lowest is distance² − radius², which is
 * −D/4A. Null for other surfaces, and for a line along the axis.
 *
 * @param shape as for `intersect`, and so is the ray.
 * @returns t in lengths of d; points, distance and radius in units of length.
 * @see NUMERICS.md, section 1: f(t) and D.
 * @example
 * const cylinder = { kind: 'cylinder', center: [0, 0, 0], radius: 5 } as const;
 * const ray = { origin: [-10, 0, 3], direction: [1, 0, 0] } as const;
 * const closest = closestApproach(cylinder, ray);
 * [closest?.distance, closest?.radius, closest?.sign]; // → [3, 5, 1]
 */
export function closestApproach(shape: Shape, ray: Ray): Closest | null {
  const definition = definitionOf(shape);
  const formula = definition.formula(shape);
  const given = valuesOf(shape, ray, ratios);
  const circle = roundAbout(definition.surface, given);
  if (!circle || formula.family !== 'curved') return null;
  const { toNumber, sign } = ratios;
  const own = (expr: Expr) => evaluate(expr, ratios, given);
  const [a, b, c] = [own(formula.A), own(formula.B), own(formula.C)];
  if (sign(a) === 0) return null;
  const abc = { scalars: { ...given.scalars, A: a, B: b, C: c }, vectors: given.vectors };
  const d = evaluate(DISCRIMINANT, ratios, abc);
  const values = { ...abc, scalars: { ...abc.scalars, D: d } };
  const at = evaluate(DOUBLE_ROOT, ratios, values);
  const center = given.vectors[circle.center];
  const along = AXES.map((axis) => {
    const i = axisIndex(axis);
    const [E, step] = [ray.origin[i], ray.direction[i]].map(ratios.of);
    return E && step ? ratios.add(E, ratios.mul(at, step)) : ratios.of(0);
  });
  const point = along.map(toNumber) as unknown as Vec3;
  const foot = AXES.map((axis) => {
    const i = axisIndex(axis);
    return circle.axes.includes(axis) && center ? toNumber(center[i]) : point[i];
  }) as unknown as Vec3;
  const height = minus(squared(circle.radius), over(scalar('D'), times(num(4), scalar('A'))));
  return {
    t: toNumber(at),
    point,
    foot,
    round: circle.axes,
    distance: Math.sqrt(toNumber(evaluate(height, ratios, values))),
    radius: Math.abs(toNumber(evaluate(circle.radius, ratios, values))),
    sign: sign(d) as Sign,
  };
}
