import type { Surd } from '../math/exact.ts';
import { DISCRIMINANT, evaluate, exact, valuesOf, withScalars } from '../math/formula.ts';
import type { Intersection, Ray, Shape } from '../math/index.ts';
import { definitionOf, intersectWhole } from '../math/shapes.ts';

/** What exact arithmetic says of a ray and a shape. */
export interface ExactResult {
  readonly found: Intersection;
  /** A, B, C and D, or N·(E − P) and N·d, by the names of their steps; not rounded. */
  readonly quantities: Readonly<Record<string, Surd>>;
}

export function exactResultOf(shape: Shape, ray: Ray): ExactResult {
  const formula = definitionOf(shape).formula(shape);
  const values = valuesOf(shape, ray, exact);
  const found = intersectWhole(shape, ray, 'exact');
  if (formula.family === 'flat') {
    const quantities = {
      'N.(E-P)': evaluate(formula.offset, exact, values),
      'N.d': evaluate(formula.rate, exact, values),
    };
    return { found, quantities };
  }
  const [A, B, C] = [formula.A, formula.B, formula.C].map((e) => evaluate(e, exact, values)) as [
    Surd,
    Surd,
    Surd,
  ];
  const D = evaluate(DISCRIMINANT, exact, withScalars(values, { A, B, C }));
  return { found, quantities: { A, B, C, D } };
}
