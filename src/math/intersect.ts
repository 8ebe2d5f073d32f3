import type { Coefficients, Intersection, QuadraticAnswer } from './intersection.ts';
import {
  InvalidInput,
  quote,
  requireFinite,
  requireFiniteVector,
  requireNonZero,
} from './invalid-input.ts';
import type { Method } from './methods/define.ts';
import { METHODS } from './methods/index.ts';
import type { Ray } from './ray.ts';
import type { Shape } from './shapes/index.ts';
import { checkShape } from './shapes/lookup.ts';

/** The method whose answers the page's verdicts and `intersect` itself stand on. */
export const DEFAULT_METHOD = 'exact';

/**
 * Where the whole line R(t) = E + t d meets the shape, t of any sign, ascending; t counts in lengths of d.
 * Throws InvalidInput on NaN, infinity, a zero direction or normal, a negative radius or side, an unknown kind or method.
 * What the answer is worth depends on the method: see its `promise`.
 */
export function intersect(shape: Shape, ray: Ray, method: string = DEFAULT_METHOD): Intersection {
  const rung = methodOf(method);
  checkShape(shape);
  checkRay(ray);
  return rung.intersect(shape, ray);
}

/**
 * A, B and C of f(t) = A t² + B t + C, the surface's equation with the ray put in. For a flat shape f is the line with
 * A = 0, B = N·d and C = N·(E − P). By 'exact' each is correctly rounded (±Infinity where it is beyond the doubles);
 * by 'textbook' it is the course's own float64 evaluation. Throws InvalidInput as `intersect` does.
 */
export function coefficients(
  shape: Shape,
  ray: Ray,
  method: string = DEFAULT_METHOD,
): Coefficients {
  const rung = methodOf(method);
  checkShape(shape);
  checkRay(ray);
  return rung.coefficients(shape, ray);
}

/**
 * Real roots of A t² + B t + C = 0, ascending; a double root once. (0, 0, 0) is 'contained': every t is a root.
 * By default correctly rounded for every finite triple; the other solvers are the rungs' own.
 * Throws InvalidInput on NaN or infinity.
 */
export function solveQuadratic(
  A: number,
  B: number,
  C: number,
  solver: string = DEFAULT_METHOD,
): QuadraticAnswer {
  const rung = methodOf(solver);
  requireFinite('A', A);
  requireFinite('B', B);
  requireFinite('C', C);
  return rung.solve(A, B, C);
}

export function findMethod(id: string): Method | undefined {
  return METHODS.find((method) => method.id === id);
}

function methodOf(id: string): Method {
  const found = findMethod(id);
  if (!found) throw new InvalidInput(`unknown method ${quote(id)}`);
  return found;
}

export function checkRay(ray: Ray): void {
  requireFiniteVector('origin', ray?.origin);
  requireFiniteVector('direction', ray.direction);
  requireNonZero('direction', ray.direction);
}
