import * as fc from 'fast-check';
import type { Values } from '../../../src/math/formula/evaluate.ts';
import {
  comp,
  dot,
  type Expr,
  minus,
  negative,
  norm,
  num,
  over,
  plusMinus,
  root,
  scalar,
  signedSum,
  squared,
  times,
  type VectorExpr,
  vec,
  vecMinus,
} from '../../../src/math/formula/expr.ts';
import { AXES } from '../../../src/math/vec3.ts';

/**
 * Six digits write these in full, and m · 10ⁿ is exact: what is read from a printed line is what
 * was put in.
 */
export const TREE_VALUES: Values<number> = {
  scalars: { A: -3, r: 0.7, t: 1.25, k: 1.5e-7, q: -2.5e9 },
  vectors: { E: [3, -1, 0.3], d: [-0.8, 0.2, 4], N: [2, 1e-6, -7] },
};

const vectors: fc.Arbitrary<VectorExpr> = fc.letrec<{ v: VectorExpr }>((tie) => ({
  v: fc.oneof(
    { depthSize: 'small', withCrossShrink: true },
    fc.constantFrom('E', 'd', 'N').map(vec),
    fc.tuple(tie('v'), tie('v')).map(([a, b]) => vecMinus(a, b)),
  ),
})).v;

/** Any tree that the types allow, whether or not a formula of the course looks like it. */
export const trees: fc.Arbitrary<Expr> = fc.letrec<{ e: Expr }>((tie) => {
  const e = tie('e');
  return {
    e: fc.oneof(
      { depthSize: 'medium', maxDepth: 6, withCrossShrink: true },
      fc.constantFrom(...Object.keys(TREE_VALUES.scalars)).map(scalar),
      fc
        .tuple(fc.constantFrom('E', 'd', 'N'), fc.constantFrom(...AXES))
        .map(([v, axis]) => comp(v, axis)),
      fc.constantFrom(2, 4, 0.5, -3, 0).map(num),
      fc
        .array(fc.tuple(fc.constantFrom<(1 | -1)[]>(1, -1), e), { minLength: 1, maxLength: 3 })
        .map((terms) => signedSum(...terms)),
      fc.array(e, { minLength: 1, maxLength: 3 }).map((factors) => times(...factors)),
      fc.tuple(e, e).map(([a, b]) => over(a, b)),
      fc.tuple(e, e).map(([a, b]) => minus(a, b)),
      e.map(negative),
      e.map(squared),
      e.map((x) => root(squared(x))),
      fc.tuple(e, e).map(([a, b]) => plusMinus(a, b)),
      fc.tuple(vectors, vectors).map(([a, b]) => dot(a, b)),
      vectors.map(norm),
    ),
  };
}).e;
