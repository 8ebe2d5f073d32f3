import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { components, cross, momentAbout } from '../formula/common.ts';
import {
  alongAxes,
  evaluate,
  type Triple,
  type Values,
  withScalars,
  withVector,
} from '../formula/evaluate.ts';
import {
  comp,
  dot,
  type Expr,
  type ExprTriple,
  negative,
  over,
  plus,
  type Relation,
  scalar,
  vec,
  vecMinus,
} from '../formula/expr.ts';

/** The trees of a flat shape: t = −N·(E − P) / (N·d), and where the figure ends. */
export interface FlatFormula {
  readonly family: 'flat';
  /** N·(E − P): how far E is off the plane, in lengths of N. */
  readonly offset: Expr;
  /** N·d: how fast t changes that. */
  readonly rate: Expr;
  readonly t: Expr;
  readonly byMoment: PlaneByMoment;
  /** Null for the whole plane. */
  readonly bound: Bound | null;
}

/**
 * The same place without t: X − P = w / (N·d), with m = d × (E − P) and w = m × N, for any N. So
 * that conditions need no sign of N·d, it and w are both taken times that sign: `rate` is |N·d| in
 * these trees.
 */
interface PlaneByMoment {
  readonly m: ExprTriple;
  /** In m and N. */
  readonly w: ExprTriple;
  /** In w and rate. */
  readonly x: ExprTriple;
}

/**
 * Where a figure ends inside its plane, asked in any arithmetic. Points X = (x, y, z) lie in its
 * plane.
 */
export interface Bound {
  /** What the course tests of X; all must hold. Rim and edge are inside. */
  readonly conditions: readonly Relation[];
  /** The same, one for one, in w and rate (see PlaneByMoment). */
  readonly momentConditions: readonly Relation[];
  /** Euclidean distance of X from the figure, for an X outside of it. */
  distance<T>(x: Triple<T>, values: Values<T>, arithmetic: Arithmetic<T>): T;
  /**
   * For a ray in the figure's plane: from which t to which t its line is in the figure, both
   * included; null where it passes beside. Asked in exact arithmetic only.
   */
  span<T>(values: Values<T>, exact: Arithmetic<T>): readonly [T, T] | null;
  /**
   * For a ray in the figure's plane: does its line meet the figure? Null where the arithmetic
   * cannot tell.
   */
  meetsLine<T>(values: Values<T>, arithmetic: Arithmetic<T>): boolean | null;
}

/**
 * The values of a formula with X = (x, y, z) put in, as a vector and by components.
 *
 * @param values by symbol, in any arithmetic.
 * @param x a point, in units of length.
 * @example
 * withPoint({ scalars: {}, vectors: {} }, [1, 2, 3]).scalars; // → { x: 1, y: 2, z: 3 }
 */
export function withPoint<T>(values: Values<T>, x: Triple<T>): Values<T> {
  return withVector(withScalars(values, { x: x[0], y: x[1], z: x[2] }), 'X', x);
}

/**
 * Which of the relations left ≤ right hold; null where the arithmetic cannot tell.
 *
 * @param relations a figure's conditions.
 * @param values what their symbols stand for.
 * @param ar the number system.
 * @example
 * const least = { left: num(0), relation: '≤', right: scalar('x') } as const;
 * whichHold([least], { scalars: { x: -1 }, vectors: {} }, float64); // → [false]
 */
export const whichHold = <T>(
  relations: readonly Relation[],
  values: Values<T>,
  ar: Arithmetic<T>,
): (boolean | null)[] =>
  excesses(relations, values, ar).map((excess) => notPositive(ar.sign(excess)));

/** left − right of each relation. */
export const excesses = <T>(
  relations: readonly Relation[],
  values: Values<T>,
  ar: Arithmetic<T>,
): T[] =>
  relations.map(({ left, right }) =>
    ar.sub(evaluate(left, ar, values), evaluate(right, ar, values)),
  );

/**
 * All of them: one that fails decides, one that is unknown leaves it open.
 *
 * @param holds true, false or null for each condition.
 * @example
 * [all([true, null]), all([false, null]), all([])]; // → [null, false, true]
 */
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
  const byMoment: PlaneByMoment = {
    m: momentAbout(point),
    w: cross(components('m'), components('N')),
    x: alongAxes((axis) => plus(comp(point, axis), over(comp('w', axis), scalar('rate')))),
  };
  return { family: 'flat', offset, rate, t: over(negative(offset), rate), byMoment, bound };
}

/** a ≤ 0 by its sign; null where the sign is unknown. */
export function notPositive(sign: number): boolean | null {
  return Number.isNaN(sign) ? null : sign <= 0;
}
