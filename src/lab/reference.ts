import { exactMethod as exact, type Surd } from '../math/exact.ts';
import {
  DISCRIMINANT,
  evaluate,
  evaluateTriple,
  exact as exactly,
  POINT,
  solveBy,
  type Triple,
  textbookSolver,
  valuesOf,
  withScalars,
} from '../math/formula.ts';
import type { Intersection, Ray, Shape } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';

export interface ExactHit {
  readonly t: Surd;
  readonly point: Triple<Surd>;
}

/** The exact answer for a ray and a shape, with numbers that are not rounded. */
export interface Reference {
  readonly found: Intersection;
  /** Exact numbers of each of `found.hits`. */
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
  return solveBy(textbookSolver, A, B, C, D, exactly).roots;
}
