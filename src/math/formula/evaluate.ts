import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { type AXES, axisIndex } from '../vec3.ts';
import type { Expr, VectorExpr } from './expr.ts';

export type Triple<T> = readonly [T, T, T];

/** What the symbols of a formula stand for. */
export interface Values<T> {
  readonly scalars: Readonly<Record<string, T>>;
  readonly vectors: Readonly<Record<string, Triple<T>>>;
}

/**
 * Doubles as numbers of another system; each is taken over exactly where the system is wide enough.
 */
export const lift = <T>(values: Values<number>, { of }: Arithmetic<T>): Values<T> =>
  mapped(values, of);

/** Every number of the values in another system. */
export function mapped<S, T>(values: Values<S>, of: (x: S) => T): Values<T> {
  const scalars: Record<string, T> = {};
  const vectors: Record<string, Triple<T>> = {};
  for (const [id, x] of Object.entries(values.scalars)) scalars[id] = of(x);
  for (const [id, v] of Object.entries(values.vectors))
    vectors[id] = [of(v[0]), of(v[1]), of(v[2])];
  return { scalars, vectors };
}

export function withScalars<T>(values: Values<T>, scalars: Readonly<Record<string, T>>): Values<T> {
  return { scalars: { ...values.scalars, ...scalars }, vectors: values.vectors };
}

export function withVector<T>(values: Values<T>, id: string, v: Triple<T>): Values<T> {
  return { scalars: values.scalars, vectors: { ...values.vectors, [id]: v } };
}

/**
 * The value of a tree, operation by operation in the order in which it is written. `branch` is the
 * sign taken at ±. Throws a RangeError for a symbol without a value: that is a formula used in the
 * wrong place, never bad input.
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
  const a = evaluateVector(expr.left, ar, values);
  const b = evaluateVector(expr.right, ar, values);
  return [ar.sub(a[0], b[0]), ar.sub(a[1], b[1]), ar.sub(a[2], b[2])];
}

export function dotProduct<T>(a: Triple<T>, b: Triple<T>, ar: Arithmetic<T>): T {
  return ar.add(ar.add(ar.mul(a[0], b[0]), ar.mul(a[1], b[1])), ar.mul(a[2], b[2]));
}

export function squaredNorm<T>(a: Triple<T>, ar: Arithmetic<T>): T {
  return ar.add(ar.add(ar.sqr(a[0]), ar.sqr(a[1])), ar.sqr(a[2]));
}

/** Evaluates one tree per component. */
export function evaluateTriple<T>(
  exprs: Triple<Expr>,
  ar: Arithmetic<T>,
  values: Values<T>,
): Triple<T> {
  const [x, y, z] = exprs;
  return [evaluate(x, ar, values), evaluate(y, ar, values), evaluate(z, ar, values)];
}

/** The three components of a formula that is the same along each axis. */
export function alongAxes<T>(f: (axis: (typeof AXES)[number]) => T): Triple<T> {
  return [f('x'), f('y'), f('z')];
}

function known<T>(value: T | undefined, id: string): T {
  if (value === undefined) throw new RangeError(`no value for ${id}`);
  return value;
}
