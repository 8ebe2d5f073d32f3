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
