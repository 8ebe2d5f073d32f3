import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { type AXES, axisIndex } from '../vec3.ts';
import type { Expr, VectorExpr } from './expr.ts';

/** Three components, along x, y and z. */
export type Triple<T> = readonly [T, T, T];

/** The values of a formula's symbols. */
export interface Values<T> {
  readonly scalars: Readonly<Record<string, T>>;
  readonly vectors: Readonly<Record<string, Triple<T>>>;
}

/**
 * Doubles as numbers of another system; each is taken over exactly where the system is wide enough.
 *
 * @param values doubles by symbol, in the units of the formula.
 * @param arithmetic the other system; only its `of` is used.
 * @throws what that `of` throws: RangeError for NaN and the infinities in exact systems.
 * @example
 * const { scalars } = lift({ scalars: { r: 0.5 }, vectors: {} }, exact);
 * exact.toNumber(scalars.r!); // → 0.5
 */
export const lift = <T>(values: Values<number>, { of }: Arithmetic<T>): Values<T> =>
  mapped(values, of);

/**
 * Every number of the values in another system.
 *
 * @param values numbers of one system by symbol.
 * @param of the same number in the other system.
 * @example
 * mapped({ scalars: { r: 2 }, vectors: { d: [1, 2, 3] } }, String);
 * // → { scalars: { r: '2' }, vectors: { d: ['1', '2', '3'] } }
 */
export function mapped<S, T>(values: Values<S>, of: (x: S) => T): Values<T> {
  const scalars: Record<string, T> = {};
  const vectors: Record<string, Triple<T>> = {};
  for (const [id, x] of Object.entries(values.scalars)) scalars[id] = of(x);
  for (const [id, v] of Object.entries(values.vectors))
    vectors[id] = [of(v[0]), of(v[1]), of(v[2])];
  return { scalars, vectors };
}

/**
 * The values and these numbers besides, in new objects.
 *
 * @param values by symbol, in any arithmetic.
 * @param scalars by symbol; one that is there already is replaced.
 * @example
 * withScalars({ scalars: { r: 2 }, vectors: {} }, { t: 5 });
 * // → { scalars: { r: 2, t: 5 }, vectors: {} }
 */
export function withScalars<T>(values: Values<T>, scalars: Readonly<Record<string, T>>): Values<T> {
  return { scalars: { ...values.scalars, ...scalars }, vectors: values.vectors };
}

/**
 * The values and this vector besides, in new objects.
 *
 * @param values by symbol, in any arithmetic.
 * @param id its symbol; one that is there already is replaced.
 * @param v its components, in the unit of the formula.
 * @example
 * withVector({ scalars: {}, vectors: {} }, 'd', [1, 0, 0]).vectors; // → { d: [1, 0, 0] }
 */
export function withVector<T>(values: Values<T>, id: string, v: Triple<T>): Values<T> {
  return { scalars: values.scalars, vectors: { ...values.vectors, [id]: v } };
}

/**
 * The value of a tree, operation by operation in the order in which it is written.
 *
 * @param expr the tree.
 * @param arithmetic the number system: float64, exact, ratios, …
 * @param values what its symbols stand for, numbers of that system.
 * @param branch the sign taken at ±.
 * @throws RangeError for a symbol without a value (a formula used in the wrong place, never bad
 *   input), and what the arithmetic throws.
 * @example
 * const values = { scalars: { A: 1, B: -20, C: 84, D: 64 }, vectors: {} };
 * [evaluate(ROOTS, float64, values, -1), evaluate(ROOTS, float64, values)]; // → [6, 14]
 * evaluate(scalar('r'), float64, values); // throws RangeError: no value for r
 */
export function evaluate<T>(
  expr: Expr,
  arithmetic: Arithmetic<T>,
  values: Values<T>,
  branch: 1 | -1 = 1,
): T {
  const ar = arithmetic;
  const of = (e: Expr): T => evaluate(e, ar, values, branch);
  switch (expr.op) {
    case 'number':
      return ar.of(expr.value);
    case 'scalar':
      return known(values.scalars[expr.id], expr.id);
    case 'component':
      return known(values.vectors[expr.vector], expr.vector)[axisIndex(expr.axis)];
    case 'sum':
      return sum(expr, ar, of);
    case 'product':
      return expr.factors.map(of).reduce(ar.mul);
    case 'quotient':
      return ar.div(of(expr.over), of(expr.under));
    case 'negative':
      return ar.neg(of(expr.of));
    case 'square':
      return ar.sqr(of(expr.of));
    case 'root':
      return ar.sqrt(of(expr.of));
    case 'plus-minus':
      return (branch === 1 ? ar.add : ar.sub)(of(expr.left), of(expr.right));
    case 'dot':
      return dotProduct(
        evaluateVector(expr.left, ar, values),
        evaluateVector(expr.right, ar, values),
        ar,
      );
    case 'norm':
      return ar.sqrt(squaredNorm(evaluateVector(expr.of, ar, values), ar));
  }
}

function sum<T>(expr: Extract<Expr, { op: 'sum' }>, ar: Arithmetic<T>, of: (e: Expr) => T): T {
  let total: T | undefined;
  for (const { sign, expr: term } of expr.terms) {
    const value = of(term);
    if (total === undefined) total = sign === 1 ? value : ar.neg(value);
    else total = sign === 1 ? ar.add(total, value) : ar.sub(total, value);
  }
  return known(total, 'an empty sum');
}

export function evaluateVector<T>(
  expr: VectorExpr,
  ar: Arithmetic<T>,
  values: Values<T>,
): Triple<T> {
  if (expr.op === 'vector') return known(values.vectors[expr.id], expr.id);
  const of = (e: VectorExpr): Triple<T> => evaluateVector(e, ar, values);
  if (expr.op === 'moved') {
    const [a, b] = [of(expr.from), of(expr.step)];
    const by = known(values.scalars[expr.by], expr.by);
    return alongAxes((axis) => ar.add(a[axisIndex(axis)], ar.mul(by, b[axisIndex(axis)])));
  }
  const [a, b] = [of(expr.left), of(expr.right)];
  return [ar.sub(a[0], b[0]), ar.sub(a[1], b[1]), ar.sub(a[2], b[2])];
}

export function dotProduct<T>(a: Triple<T>, b: Triple<T>, ar: Arithmetic<T>): T {
  return ar.add(ar.add(ar.mul(a[0], b[0]), ar.mul(a[1], b[1])), ar.mul(a[2], b[2]));
}

/**
 * x² + y² + z², from the left.
 *
 * @param ar the number system.
 * @param a three numbers of the system, of one unit; the value has its square.
 * @example
 * squaredNorm([3, 0, 4], float64); // → 25
 */
export function squaredNorm<T>(a: Triple<T>, ar: Arithmetic<T>): T {
  return ar.add(ar.add(ar.sqr(a[0]), ar.sqr(a[1])), ar.sqr(a[2]));
}

/**
 * Evaluates one tree per component.
 *
 * @param exprs trees, of x, y and z, of one unit.
 * @param ar as for `evaluate`, and so are the values.
 * @returns in the unit of the trees.
 * @see NUMERICS.md, section 1
 * @throws as `evaluate` does.
 * @example
 * const values = { scalars: { t: 2 }, vectors: { E: [4, 1, 0], d: [-1, 0, 0.5] } } as const;
 * evaluateTriple(POINT, float64, values); // → [2, 1, 1]
 */
export function evaluateTriple<T>(
  exprs: Triple<Expr>,
  ar: Arithmetic<T>,
  values: Values<T>,
): Triple<T> {
  const [x, y, z] = exprs;
  return [evaluate(x, ar, values), evaluate(y, ar, values), evaluate(z, ar, values)];
}

/**
 * The three components of a formula that is the same along each axis.
 *
 * @param f asked for x, y and z in turn; all of one unit.
 * @returns what f says, in its unit.
 * @see NUMERICS.md, section 1
 * @example
 * alongAxes((axis) => axis.toUpperCase()); // → ['X', 'Y', 'Z']
 */
export function alongAxes<T>(f: (axis: (typeof AXES)[number]) => T): Triple<T> {
  return [f('x'), f('y'), f('z')];
}

function known<T>(value: T | undefined, id: string): T {
  if (value === undefined) throw new RangeError(`no value for ${id}`);
  return value;
}
