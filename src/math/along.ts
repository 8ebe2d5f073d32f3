import { exact } from './arithmetic/exact.ts';
import { POINT } from './formula/common.ts';
import { evaluate, evaluateTriple, withScalars } from './formula/evaluate.ts';
import { type Expr, plus, scalar, squared, times } from './formula/expr.ts';
import { valuesOf } from './methods/tree-method.ts';
import type { Ray } from './ray.ts';
import type { Shape } from './shapes/index.ts';
import { definitionOf } from './shapes/lookup.ts';
import type { Vec3 } from './vec3.ts';

/**
 * What a bead at t sees: R(t) = E + t d and f(t), each correctly rounded from the stored doubles
 * (±Infinity beyond them).
 *
 * @param shape as for `intersect`, and so is the ray.
 * @param t in lengths of d.
 * @returns the point in units of length, f in the unit of C.
 * @see NUMERICS.md, section 1: R(t), A, B and C.
 * @example
 * const sphere = { kind: 'sphere', center: [0, 0, 0], radius: 2 } as const;
 * alongRay(sphere, { origin: [4, 0, 0], direction: [-1, 0, 0] }, 1);
 * // → { point: [3, 0, 0], f: 5 }
 */
export function alongRay(shape: Shape, ray: Ray, t: number): { point: Vec3; f: number } {
  const values = withScalars(valuesOf(shape, ray, exact), { t: exact.of(t) });
  const [x, y, z] = evaluateTriple(POINT, exact, values);
  return {
    point: [exact.toNumber(x), exact.toNumber(y), exact.toNumber(z)],
    f: exact.toNumber(evaluate(fOf(shape), exact, values)),
  };
}

/** f(t) with the shape's own trees for A, B and C. */
function fOf(shape: Shape): Expr {
  const formula = definitionOf(shape).formula(shape);
  const t = scalar('t');
  return formula.family === 'curved'
    ? plus(times(formula.A, squared(t)), times(formula.B, t), formula.C)
    : plus(times(formula.rate, t), formula.offset);
}
