import { alongAxes } from './evaluate.ts';
import {
  comp,
  type Expr,
  type ExprTriple,
  minus,
  num,
  plus,
  signedSum,
  squared,
  times,
} from './expr.ts';

/* What every shape has is written as data: nothing is made when a module is loaded. */
export const A: Expr = { op: 'scalar', id: 'A' };
export const B: Expr = { op: 'scalar', id: 'B' };
export const C: Expr = { op: 'scalar', id: 'C' };
export const D: Expr = { op: 'scalar', id: 'D' };
export const T: Expr = { op: 'scalar', id: 't' };
const MINUS_B: Expr = { op: 'negative', of: B };
export const TWO: Expr = { op: 'number', value: 2 };
const TWO_A: Expr = { op: 'product', factors: [TWO, A] };

/** D = B² − 4AC. (The plane's constant in Ax + By + Cz + D = 0 is another D.) */
export const DISCRIMINANT: Expr = {
  op: 'sum',
  terms: [
    { sign: 1, expr: { op: 'square', of: B } },
    { sign: -1, expr: { op: 'product', factors: [{ op: 'number', value: 4 }, A, C] } },
  ],
};

/** t = (−B ± √D) / 2A, for A ≠ 0 and D ≥ 0. */
export const ROOTS: Expr = {
  op: 'quotient',
  over: { op: 'plus-minus', left: MINUS_B, right: { op: 'root', of: D } },
  under: TWO_A,
};

/** t = −B / 2A: both roots in one, for D = 0. */
export const DOUBLE_ROOT: Expr = { op: 'quotient', over: MINUS_B, under: TWO_A };

/** t = −C / B, for A = 0 and B ≠ 0. */
export const LINEAR_ROOT: Expr = { op: 'quotient', over: { op: 'negative', of: C }, under: B };

/** f(t) = At² + Bt + C: what is left of the surface's equation when the ray is put into it. */
export const F_OF_T: Expr = {
  op: 'sum',
  terms: [
    { sign: 1, expr: { op: 'product', factors: [A, { op: 'square', of: T }] } },
    { sign: 1, expr: { op: 'product', factors: [B, T] } },
    { sign: 1, expr: C },
  ],
};

const E_X: Expr = { op: 'component', vector: 'E', axis: 'x' };
const E_Y: Expr = { op: 'component', vector: 'E', axis: 'y' };
const E_Z: Expr = { op: 'component', vector: 'E', axis: 'z' };
const T_DX: Expr = { op: 'product', factors: [T, { op: 'component', vector: 'd', axis: 'x' }] };
const T_DY: Expr = { op: 'product', factors: [T, { op: 'component', vector: 'd', axis: 'y' }] };
const T_DZ: Expr = { op: 'product', factors: [T, { op: 'component', vector: 'd', axis: 'z' }] };

/** P = E + t d. */
export const POINT: ExprTriple = [
  {
    op: 'sum',
    terms: [
      { sign: 1, expr: E_X },
      { sign: 1, expr: T_DX },
    ],
  },
  {
    op: 'sum',
    terms: [
      { sign: 1, expr: E_Y },
      { sign: 1, expr: T_DY },
    ],
  },
  {
    op: 'sum',
    terms: [
      { sign: 1, expr: E_Z },
      { sign: 1, expr: T_DZ },
    ],
  },
];

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
