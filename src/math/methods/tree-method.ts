import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { exact } from '../arithmetic/exact.ts';
import { evaluate, evaluateTriple, type Triple, type Values } from '../formula/evaluate.ts';
import type { Coefficients, Intersection } from '../intersection.ts';
import type { Ray } from '../ray.ts';
import type { CurvedFormula } from '../shapes/axial-quadric.ts';
import type { Shape } from '../shapes/index.ts';
import { definitionOf } from '../shapes/lookup.ts';
import type { FlatFormula } from '../shapes/planar.ts';
import { intersectCurved, symbolsOf } from './tree-answer.ts';
import { intersectFlat } from './tree-flat.ts';
import { type MethodParts, rounded } from './tree-parts.ts';

/*
 * Functions of a method that is an arithmetic, a form and a solver: its trees are evaluated in that
 * arithmetic, and the results are rounded to doubles at the end.
 */

export function coefficientsBy<T>(
  { arithmetic: ar }: MethodParts<T>,
  shape: Shape,
  ray: Ray,
): Coefficients {
  const [A, B, C] = rounded(coefficientsOf(shape, valuesOf(shape, ray, ar), ar), ar);
  return { A, B, C };
}

export const intersectBy = <T>(parts: MethodParts<T>, shape: Shape, ray: Ray): Intersection =>
  intersectValues(shape, ray, valuesOf(shape, ray, parts.arithmetic), parts);

/** By the given values in place of those that are stored in shape and ray. */
export function intersectValues<T>(
  shape: Shape,
  ray: Ray,
  values: Values<T>,
  parts: MethodParts<T>,
): Intersection {
  const formula = formulaOf(shape);
  return formula.family === 'curved'
    ? intersectCurved(formula, values, parts)
    : intersectFlat(formula, values, parts, () => valuesOf(shape, ray, exact));
}

function formulaOf(shape: Shape): CurvedFormula | FlatFormula {
  return definitionOf(shape).formula(shape);
}

/**
 * The ray's and the shape's symbols in the method's numbers.
 *
 * @param shape as for `intersect`, and so is the ray; lengths in units of length.
 * @param arithmetic the system of the numbers.
 * @example
 * const sphere = { kind: 'sphere', center: [0, 0, 0], radius: 2 } as const;
 * const ray = { origin: [4, 0, 0], direction: [-1, 0, 0] } as const;
 * valuesOf(sphere, ray, float64).scalars; // → { r: 2 }
 */
export function valuesOf<T>(shape: Shape, ray: Ray, arithmetic: Arithmetic<T>): Values<T> {
  return symbolsOf(definitionOf(shape).values(shape), ray, arithmetic);
}

/** A, B, C of f(t); for a flat shape f is the line (N·d) t + N·(E − P). */
function coefficientsOf<T>(shape: Shape, values: Values<T>, ar: Arithmetic<T>): Triple<T> {
  const formula = formulaOf(shape);
  if (formula.family === 'curved') {
    return evaluateTriple([formula.A, formula.B, formula.C], ar, values);
  }
  return [ar.of(0), evaluate(formula.rate, ar, values), evaluate(formula.offset, ar, values)];
}
