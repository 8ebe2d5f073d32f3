import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { exact } from '../arithmetic/exact.ts';
import { evaluate, evaluateTriple, type Triple, type Values } from '../formula/evaluate.ts';
import type { Coefficients, DecidedBy, Intersection } from '../intersection.ts';
import type { Ray } from '../ray.ts';
import type { CurvedFormula } from '../shapes/axial-quadric.ts';
import type { Shape } from '../shapes/index.ts';
import { definitionOf } from '../shapes/lookup.ts';
import type { FlatFormula } from '../shapes/planar.ts';
import type { Method } from './define.ts';
import { courseForm, type Form } from './forms.ts';
import type { Solver } from './solvers.ts';
import { intersectCurved, solveDoubles, symbolsOf } from './tree-answer.ts';
import { intersectFlat } from './tree-flat.ts';
import type { MethodParts } from './tree-parts.ts';

type About = Pick<Method, 'id' | 'title' | 'hint' | 'idea' | 'promise' | 'source' | 'proven'>;

/**
 * A method that is an arithmetic, a way to form what decides and a way to solve the quadratic: the
 * trees are evaluated in that arithmetic, and whatever is shown of them is rounded to doubles at
 * the very end.
 */
export function treeMethod<T>(
  about: About,
  arithmetic: Arithmetic<T>,
  solver: Solver,
  decidedBy: DecidedBy,
  form: Form = courseForm,
): Method {
  const parts: MethodParts<T> = { arithmetic, form, solver, decidedBy, id: about.id };
  return {
    ...about,
    coefficients(shape, ray) {
      const [A, B, C] = coefficientsOf(shape, valuesOf(shape, ray, arithmetic), arithmetic);
      const { toNumber } = arithmetic;
      return { A: toNumber(A), B: toNumber(B), C: toNumber(C) } satisfies Coefficients;
    },
    intersect: (shape, ray) => intersectValues(shape, ray, valuesOf(shape, ray, arithmetic), parts),
    solve: (A, B, C) => solveDoubles(A, B, C, parts),
    parts: (use) => use(arithmetic, form, solver),
  };
}

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
