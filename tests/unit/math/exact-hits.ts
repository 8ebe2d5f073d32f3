import { exact } from '../../../src/math/arithmetic/exact.ts';
import { bracket } from '../../../src/math/exact/faithful.ts';
import type { Surd } from '../../../src/math/exact/surd.ts';
import { DISCRIMINANT, POINT } from '../../../src/math/formula/common.ts';
import {
  evaluate,
  evaluateTriple,
  type Triple,
  withScalars,
} from '../../../src/math/formula/evaluate.ts';
import type { Verdict } from '../../../src/math/intersection.ts';
import { exact as exactMethod } from '../../../src/math/methods/exact.ts';
import { solveBy, textbookSolver } from '../../../src/math/methods/solvers.ts';
import { valuesOf } from '../../../src/math/methods/tree-method.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';
import { withPoint } from '../../../src/math/shapes/planar.ts';

/** A hit before anything of it is rounded. */
export interface ExactHit {
  readonly t: Surd;
  readonly point: Triple<Surd>;
  readonly normal: Triple<Surd>;
}

/** Class and hits by the course's trees in exact arithmetic. */
export function exactHits(shape: Shape, ray: Ray): { class: Verdict; hits: ExactHit[] } {
  const formula = definitionOf(shape).formula(shape);
  const values = valuesOf(shape, ray, exact);
  const place = (t: Surd): Triple<Surd> => evaluateTriple(POINT, exact, withScalars(values, { t }));
  if (formula.family === 'flat') {
    const { class: verdict, hits } = exactMethod.intersect(shape, ray);
    if (hits.length === 0) return { class: verdict, hits: [] };
    const t = evaluate(formula.t, exact, values);
    return {
      class: verdict,
      hits: [{ t, point: place(t), normal: values.vectors.N as Triple<Surd> }],
    };
  }
  const [A, B, C] = evaluateTriple([formula.A, formula.B, formula.C], exact, values);
  const D = evaluate(DISCRIMINANT, exact, withScalars(values, { A, B, C }));
  const { class: verdict, roots } = solveBy(textbookSolver, A, B, C, D, exact);
  return {
    class: verdict,
    hits: roots.map((t) => {
      const point = place(t);
      return { t, point, normal: evaluateTriple(formula.normal, exact, withPoint(values, point)) };
    }),
  };
}

/**
 * Whether x is one of the two doubles around the exact number: that number itself where it is a
 * double. The sign of zero counts.
 */
export function faithful(truth: Surd, x: number): boolean {
  const [low, high] = bracket(truth);
  return Object.is(x, low) || Object.is(x, high);
}

/** The sine of the angle between a normal and the exact one, which is not zero, is below 2^-50. */
export function straight([x, y, z]: Triple<Surd>, normal: readonly number[]): boolean {
  const [a, b, c] = normal.map(exact.of) as [Surd, Surd, Surd];
  const { add, sub, mul, sqr, sign } = exact;
  const minor = (p: Surd, q: Surd, r: Surd, s: Surd): Surd => sqr(sub(mul(p, q), mul(r, s)));
  const across = add(add(minor(y, c, z, b), minor(z, a, x, c)), minor(x, b, y, a));
  const sizes = mul(add(add(sqr(x), sqr(y)), sqr(z)), add(add(sqr(a), sqr(b)), sqr(c)));
  const along = add(add(mul(x, a), mul(y, b)), mul(z, c));
  return sign(along) > 0 && sign(sub(mul(sizes, exact.of(2 ** -100)), across)) >= 0;
}
