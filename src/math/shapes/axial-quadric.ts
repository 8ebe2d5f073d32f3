import { momentAbout, momentDiscriminant } from '../formula/common.ts';
import {
  comp,
  type Expr,
  type ExprTriple,
  minus,
  num,
  plus,
  type Relation,
  scalar,
  signedSum,
  squared,
  times,
} from '../formula/expr.ts';
import type { Axis } from '../vec3.ts';

/** The trees of a curved shape: the ray put into its equation gives A t² + B t + C = 0. */
export interface CurvedFormula {
  readonly family: 'curved';
  readonly A: Expr;
  readonly B: Expr;
  readonly C: Expr;
  /** m = d × (E − C), and D from A and m instead of from A, B and C. */
  readonly moment: ExprTriple;
  readonly momentD: Expr;
  /** The course's normal at (x, y, z): half the gradient, not normalised. */
  readonly normal: ExprTriple;
}

/**
 * Cylinder, cone and hyperboloid are (x−Cx)² + (z−Cz)² = a(y−Cy)² + ρ about an axis parallel to y.
 * They differ in the symbol of the centre, in a (none for the cylinder, c² for the cone, a for the
 * hyperboloid) and in ρ (none for the cone).
 */
export interface AxialQuadric {
  readonly center: string;
  readonly a: Expr | null;
  readonly rho: Expr | null;
}

export function axialSurface({ center, a, rho }: AxialQuadric): Relation {
  const from = (axis: Axis): Expr => squared(minus(scalar(axis), comp(center, axis)));
  const right = [...(a ? [times(a, from('y'))] : []), ...(rho ? [rho] : [])];
  const only = right.length === 1 ? right[0] : undefined;
  return { left: plus(from('x'), from('z')), relation: '=', right: only ?? plus(...right) };
}

/** The course's A, B, C and normal, the term in y left out where the shape has none. */
export function axialFormula({ center, a, rho }: AxialQuadric): CurvedFormula {
  const d = (axis: Axis): Expr => comp('d', axis);
  const p = (axis: Axis): Expr => minus(comp('E', axis), comp(center, axis));
  const n = (axis: 'x' | 'y' | 'z'): Expr => minus(scalar(axis), comp(center, axis));
  const inY = (term: (a: Expr) => Expr): [-1, Expr][] => (a ? [[-1, term(a)]] : []);
  return {
    family: 'curved',
    A: signedSum(
      [1, squared(d('x'))],
      [1, squared(d('z'))],
      ...inY((k) => times(k, squared(d('y')))),
    ),
    B: signedSum(
      [1, times(num(2), d('x'), p('x'))],
      [1, times(num(2), d('z'), p('z'))],
      ...inY((k) => times(num(2), k, d('y'), p('y'))),
    ),
    C: signedSum(
      [1, squared(p('x'))],
      [1, squared(p('z'))],
      ...inY((k) => times(k, squared(p('y')))),
      ...(rho ? [[-1, rho] as const] : []),
    ),
    moment: momentAbout(center),
    momentD: momentDiscriminant(a, rho),
    normal: [n('x'), a ? times({ op: 'negative', of: a }, n('y')) : num(0), n('z')],
  };
}
