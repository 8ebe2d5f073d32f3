import { alongAxes } from './evaluate.ts';
import {
  comp,
  type Expr,
  type ExprTriple,
  minus,
  negative,
  num,
  over,
  plus,
  plusMinus,
  root,
  scalar,
  signedSum,
  squared,
  times,
} from './expr.ts';

const A = scalar('A');
const B = scalar('B');
const C = scalar('C');
const D = scalar('D');

/** D = B² − 4AC. (The plane's constant in Ax + By + Cz + D = 0 is another D.) */
export const DISCRIMINANT: Expr = minus(squared(B), times(num(4), A, C));

/** t = (−B ± √D) / 2A, for A ≠ 0 and D ≥ 0. */
export const ROOTS: Expr = over(plusMinus(negative(B), root(D)), times(num(2), A));

/** t = −B / 2A: both roots in one, for D = 0. */
export const DOUBLE_ROOT: Expr = over(negative(B), times(num(2), A));

/** t = −C / B, for A = 0 and B ≠ 0. */
export const LINEAR_ROOT: Expr = over(negative(C), B);

/** f(t) = At² + Bt + C: what is left of the surface's equation when the ray is put into it. */
export const F_OF_T: Expr = plus(times(A, squared(scalar('t'))), times(B, scalar('t')), C);

/** P = E + t d. */
export const POINT: ExprTriple = alongAxes((axis) =>
  plus(comp('E', axis), times(scalar('t'), comp('d', axis))),
);

/** a × b, written out. */
export function cross(a: ExprTriple, b: ExprTriple): ExprTriple {
  const minor = (i: 0 | 1 | 2, j: 0 | 1 | 2): Expr => minus(times(a[i], b[j]), times(a[j], b[i]));
  return [minor(1, 2), minor(2, 0), minor(0, 1)];
}

/**
 * The components of a vector by its symbol.
 *
 * @param vector the vector's letter.
 * @example
 * evaluateTriple(components('d'), float64, { scalars: {}, vectors: { d: [1, 2, 3] } });
 * // → [1, 2, 3]
 */
export const components = (vector: string): ExprTriple => alongAxes((axis) => comp(vector, axis));

/** The ray's moment about a point: m = d × (E − C). Sliding E along the ray does not change it. */
export const momentAbout = (center: string): ExprTriple =>
  cross(
    components('d'),
    alongAxes((axis) => minus(comp('E', axis), comp(center, axis))),
  );

/**
 * D = 4(ρA + a(mx² + mz²) − my²) for the surface (x−Cx)² + (z−Cz)² = a(y−Cy)² + ρ: Lagrange's
 * identity for the metric diag(1, −a, 1) turns b² − AC into this. B² and 4AC agree in ever more
 * digits as E moves away; here nothing grows with the distance but the rounding of m itself.
 */
export function momentDiscriminant(a: Expr | null, rho: Expr | null): Expr {
  const [mx, my, mz] = components('m');
  return times(
    num(4),
    signedSum(
      ...(rho ? [[1, times(rho, A)] as const] : []),
      ...(a ? [[1, times(a, plus(squared(mx), squared(mz)))] as const] : []),
      [-1, squared(my)],
    ),
  );
}
