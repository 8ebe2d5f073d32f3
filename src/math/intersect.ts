import type { Coefficients, Intersection, QuadraticAnswer } from './intersection.ts';
import {
  countFields,
  InvalidInput,
  quote,
  requireFields,
  requireFinite,
  requireFiniteVector,
  requireNonZero,
} from './invalid-input.ts';
import { withoutStart } from './leave.ts';
import type { Method } from './methods/define.ts';
import { METHODS } from './methods/index.ts';
import type { Ray } from './ray.ts';
import type { Shape } from './shapes/index.ts';
import { checkedShape } from './shapes/lookup.ts';
import type { Given } from './vec3.ts';
import { plainVector } from './vec3.ts';

/**
 * What `intersect` and the page use unless told otherwise: the class of exact arithmetic, and each root one of the two doubles around it, at a price that
 * a picture can pay. The page still compares every class that it shows with the exact rung's.
 */
export const DEFAULT_METHOD = 'certified';

export interface IntersectOptions {
  /**
   * The shape whose surface the ray is declared to start on, because E was computed as a hit on it. If it is `shape` itself (the
   * same object, or one with equal numbers), the root nearest to t = 0 is where the ray starts and not a hit: it is dropped by this
   * rule of identity, at whatever distance, without any epsilon. Two equally near roots: the positive one is dropped.
   *
   * `certified` and `exact` decide which root is nearer exactly, the other rungs by comparing their own rounded roots. What
   * no rule can know: whether E was on the surface at all. A ray declared to leave a surface that it does not start on loses a
   * true hit; and where E has been rounded so far that the line misses the surface, there is nothing to drop.
   */
  readonly from?: Given<Shape> | null | undefined;
}

/**
 * Where the whole line R(t) = E + t d meets the shape, t of any sign, ascending; t counts in
 * lengths of d. Throws InvalidInput on NaN, infinity, a zero direction or normal, a negative radius
 * or side, an unknown kind or method, and on a field that is not the shape's, the ray's or an
 * option. Vectors may be any list of three numbers, a Float64Array for one. What the answer is
 * worth depends on the method: see its `promise`.
 */
export function intersect(
  shape: Given<Shape>,
  ray: Given<Ray>,
  method: string = DEFAULT_METHOD,
  options?: IntersectOptions | null,
): Intersection {
  const rung = methodOf(method);
  const surface = checkedShape(shape);
  const found = rung.intersect(surface, checkedRay(ray));
  if (options) requireFields('set of options', options, OPTIONS);
  const from = options?.from;
  if (from === undefined || from === null) return found;
  return withoutStart(found, surface, checkedShape(from));
}

const OPTIONS = ['from'];

/**
 * A, B and C of f(t) = A t² + B t + C, the surface's equation with the ray put in. For a flat shape f is the line with
 * A = 0, B = N·d and C = N·(E − P). By 'exact' and 'certified' each is correctly rounded (±Infinity where it is beyond the doubles);
 * by 'textbook' it is the course's own float64 evaluation. Throws InvalidInput as `intersect` does.
 */
export function coefficients(
  shape: Given<Shape>,
  ray: Given<Ray>,
  method: string = DEFAULT_METHOD,
): Coefficients {
  const rung = methodOf(method);
  return rung.coefficients(checkedShape(shape), checkedRay(ray));
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
  return BY_ID.get(id);
}

const BY_ID: ReadonlyMap<string, Method> = new Map(METHODS.map((method) => [method.id, method]));

function methodOf(id: string): Method {
  const found = findMethod(id);
  if (!found) throw new InvalidInput(`unknown method ${quote(id)}`);
  return found;
}

const RAY = ['origin', 'direction'];

/** The ray with plain arrays: itself, where they are. */
export function checkedRay(ray: Given<Ray>): Ray {
  const origin = ray?.origin;
  const direction = ray?.direction;
  if (typeof ray === 'object' && ray !== null) {
    const whole = origin !== undefined && direction !== undefined && countFields(ray) === 2;
    if (!whole) requireFields('ray', ray, RAY);
  }
  requireFiniteVector('origin', origin);
  requireFiniteVector('direction', direction);
  requireNonZero('direction', direction);
  if (Array.isArray(origin) && Array.isArray(direction)) return ray as Ray;
  return { origin: plainVector(origin), direction: plainVector(direction) };
}
