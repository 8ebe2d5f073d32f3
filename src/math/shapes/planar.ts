import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import {
  evaluate,
  type Triple,
  type Values,
  withScalars,
  withVector,
} from '../formula/evaluate.ts';
import { dot, type Expr, negative, over, type Relation, vec, vecMinus } from '../formula/expr.ts';

/** The trees of a flat shape: t = −N·(E − P) / (N·d), and where the figure ends. */
export interface FlatFormula {
  readonly family: 'flat';
  /** N·(E − P): how far E is off the plane, in lengths of N. */
  readonly offset: Expr;
  /** N·d: how fast t changes that. */
  readonly rate: Expr;
  readonly t: Expr;
  /** Null for the whole plane. */
  readonly bound: Bound | null;
}

/** Where a figure ends inside its plane, asked in any arithmetic. Points X = (x, y, z) lie in its plane. */
export interface Bound {
  /** What the course tests of X; all must hold. Rim and edge are inside. */
  readonly conditions: readonly Relation[];
  /** Euclidean distance of X from the figure, for an X outside of it. */
  distance<T>(x: Triple<T>, values: Values<T>, arithmetic: Arithmetic<T>): T;
  /** For a ray in the figure's plane: does its line meet the figure? Null where the arithmetic cannot tell. */
  meetsLine<T>(values: Values<T>, arithmetic: Arithmetic<T>): boolean | null;
}

/** The values of a formula with X = (x, y, z) put in, as a vector and by components. */
export function withPoint<T>(values: Values<T>, x: Triple<T>): Values<T> {
  return withVector(withScalars(values, { x: x[0], y: x[1], z: x[2] }), 'X', x);
}

/** Which of the conditions X, in the figure's plane, meets; null where the arithmetic cannot tell. */
export function conditionsAt<T>(
  bound: Bound,
  x: Triple<T>,
  values: Values<T>,
  ar: Arithmetic<T>,
): (boolean | null)[] {
  const at = withPoint(values, x);
  return bound.conditions.map(({ left, right }) =>
    notPositive(ar.sign(ar.sub(evaluate(left, ar, at), evaluate(right, ar, at)))),
  );
}

/** All of them: one that fails decides, one that is unknown leaves it open. */
export function all(holds: readonly (boolean | null)[]): boolean | null {
  if (holds.includes(false)) return false;
  return holds.includes(null) ? null : true;
}

/** `point` is the symbol of a point of the plane: P, or the circle's C. */
export function planarSurface(point: string): Relation {
  return {
    left: dot(vec('N'), vecMinus(vec('X'), vec(point))),
    relation: '=',
    right: { op: 'number', value: 0 },
  };
}

export function planarFormula(point: string, bound: Bound | null): FlatFormula {
  const offset = dot(vec('N'), vecMinus(vec('E'), vec(point)));
  const rate = dot(vec('N'), vec('d'));
  return { family: 'flat', offset, rate, t: over(negative(offset), rate), bound };
}

/** a ≤ 0 by its sign; null where the sign is unknown. */
export function notPositive(sign: number): boolean | null {
  return Number.isNaN(sign) ? null : sign <= 0;
}
