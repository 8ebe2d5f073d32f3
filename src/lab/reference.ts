import { exact as exactly } from '../math/arithmetic/exact.ts';
import type { Surd } from '../math/exact/surd.ts';
import { DISCRIMINANT, POINT } from '../math/formula/common.ts';
import { evaluate, evaluateTriple, type Triple, withScalars } from '../math/formula/evaluate.ts';
import type { Intersection } from '../math/intersection.ts';
import { exact } from '../math/methods/exact.ts';
import { textbookSolver } from '../math/methods/solvers.ts';
import { valuesOf } from '../math/methods/tree-method.ts';
import type { Ray } from '../math/ray.ts';
import type { Shape } from '../math/shapes/index.ts';
import { definitionOf } from '../math/shapes/lookup.ts';

export interface ExactHit {
  readonly t: Surd;
  readonly point: Triple<Surd>;
}

/** What is true of a ray and a shape, before anything is rounded. */
export interface Reference {
  readonly found: Intersection;
  /** One for each of `found.hits`. */
  readonly hits: readonly ExactHit[];
}

/** The exact method's answer, and its roots and points as exact numbers. */
export function referenceOf(shape: Shape, ray: Ray): Reference {
  const found = exact.intersect(shape, ray);
  if (found.hits.length === 0) return { found, hits: [] };
  const values = valuesOf(shape, ray, exactly);
  const hits = rootsOf(shape, values).map((t) => ({
    t,
    point: evaluateTriple(POINT, exactly, withScalars(values, { t })),
  }));
  return { found, hits };
}

function rootsOf(shape: Shape, values: ReturnType<typeof valuesOf<Surd>>): readonly Surd[] {
  const formula = definitionOf(shape).formula(shape);
  if (formula.family === 'flat') return [evaluate(formula.t, exactly, values)];
  const [A, B, C] = evaluateTriple([formula.A, formula.B, formula.C], exactly, values);
  const D = evaluate(DISCRIMINANT, exactly, withScalars(values, { A, B, C }));
  return textbookSolver(A, B, C, D, exactly).roots;
}
