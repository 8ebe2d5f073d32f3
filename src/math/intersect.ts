import { answerWithEnds } from './answer-with-ends.ts';
import { DEFAULT_METHOD, methodOf } from './find-method.ts';
import { checkedRay } from './given-ray.ts';
import type { Coefficients, Intersection } from './intersection.ts';
import { requireFields } from './invalid-input.ts';
import { withoutStart } from './leaving-ray.ts';
import type { Ray } from './ray.ts';
import { type Cut, checkedSolid } from './shapes/checked.ts';
import type { Shape, Solid } from './shapes/index.ts';
import { checkedShape, definitionOf } from './shapes/lookup.ts';
import type { Given } from './vec3.ts';

interface IntersectOptions {
  /**
   * The shape whose surface the ray is declared to start on, because E was computed as a hit on it.
   * If it is `shape` itself (the same object, or one with equal numbers), the root nearest to t = 0
   * is where the ray starts and not a hit: it is dropped by this rule of identity, at whatever
   * distance, without any epsilon. Two equally near roots: the positive one is dropped.
   *
   * `certified` and `exact` decide which root is nearer exactly, the other methods by comparing
   * their own rounded roots. What no rule can know: whether E was on the surface at all. A ray
   * declared to leave a surface that it does not start on loses a true hit; and where E has been
   * rounded so far that the line misses the surface, there is nothing to drop.
   */
  readonly from?: Given<Solid> | null | undefined;
}

/**
 * Where the whole line R(t) = E + t d meets the shape: its class, and its hits in ascending t, of
 * any sign. What the answer is worth depends on the method: see its `promise`.
 *
 * @param shape its kind and each of its parameters, in units of length; a slope, a flare and a
 *   normal have none. Vectors may be any list of three numbers, a Float64Array for one. Beside a
 *   curved shape's own, `between: [low, high]`: only its part with low ≤ y ≤ high is there, and
 *   with `caps: true` discs close both ends. Then each hit has a `fate`: 'hit'; 'cut' for a root
 *   where nothing is left of the surface; 'cap' for a way through a disc. The class stays that of
 *   the line and the whole surface. By `certified` and `exact` the fates are those of exact
 *   arithmetic.
 * @param ray `origin` is E, in units of length; `direction` is d, of any length but 0. t counts in
 *   lengths of d.
 * @param method the `id` of one of METHODS.
 * @param options `from`: the shape that the ray starts on, whose root there is no hit.
 * @throws InvalidInput on NaN, infinity, a zero direction or normal, a negative radius or side, an
 *   unknown kind or method, and on a field that is not the shape's, the ray's or an option.
 * @see NUMERICS.md, section 1: formulas; section 4: what is promised of the answer.
 * @example
 * const cylinder = { kind: 'cylinder', center: [0, 0, 0], radius: 5 } as const;
 * const ray = { origin: [-10, 0, 3], direction: [1, 0, 0] } as const;
 * intersect(cylinder, ray).class; // → 'two'
 * intersect(cylinder, ray).hits.map(({ t }) => t); // → [6, 14]
 * intersect(cylinder, ray, 'textbook').hits[0]?.normal; // → [-4, 0, 3]
 * const can = { ...cylinder, between: [-1, 1], caps: true } as const;
 * const steep = { origin: [0, 4, 0], direction: [1, -1, 0] } as const;
 * intersect(can, steep).hits.map(({ t, fate }) => [t, fate]);
 * // → [[-5, 'cut'], [3, 'cap'], [5, 'hit']]
 * intersect(cylinder, { ...ray, direction: [0, 0, 0] });
 * // throws InvalidInput: direction must not be zero, got (0, 0, 0)
 */
export function intersect(
  shape: Given<Solid>,
  ray: Given<Ray>,
  method: string = DEFAULT_METHOD,
  options?: IntersectOptions | null,
): Intersection {
  const chosen = methodOf(method);
  const { between, caps } = shape ?? {};
  const isWhole = between === undefined && caps === undefined;
  const { shape: surface, cut } = isWhole
    ? { shape: checkedShape(shape), cut: null }
    : parts(shape);
  const line = checkedRay(ray);
  const whole = chosen.intersect(surface, line);
  const found = cut ? answerWithEnds(whole, surface, cut, line) : whole;
  if (options) requireFields('set of options', options, OPTIONS);
  const from = options?.from;
  if (from === undefined || from === null) return found;
  return withoutStart(found, surface, parts(from).shape);
}

const OPTIONS = ['from'];

const parts = (solid: Given<Solid>): { readonly shape: Shape; readonly cut: Cut | null } =>
  checkedSolid(definitionOf(solid as Shape), solid);

/**
 * A, B and C of f(t) = A t² + B t + C, the surface's equation with the ray put in. For a flat shape
 * f is the line with A = 0, B = N·d and C = N·(E − P). By 'exact' and 'certified' each is correctly
 * rounded (±Infinity where it is beyond the doubles); by 'textbook' it is the course's own float64
 * evaluation.
 *
 * @param shape as for `intersect`.
 * @param ray as for `intersect`. f counts t in lengths of d.
 * @param method the `id` of one of METHODS.
 * @throws InvalidInput as `intersect` does.
 * @see NUMERICS.md, section 1: A, B and C; section 4: what is rounded and how.
 * @example
 * coefficients(
 *   { kind: 'cylinder', center: [0, 0, 0], radius: 5 },
 *   { origin: [-10, 0, 3], direction: [1, 0, 0] },
 * ); // → { A: 1, B: -20, C: 84 }
 */
export function coefficients(
  shape: Given<Shape>,
  ray: Given<Ray>,
  method: string = DEFAULT_METHOD,
): Coefficients {
  const chosen = methodOf(method);
  return chosen.coefficients(checkedShape(shape), checkedRay(ray));
}
