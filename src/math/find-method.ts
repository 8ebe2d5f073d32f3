import { checkedRay } from './given-ray.ts';
import type { Intersection } from './intersection.ts';
import { InvalidInput, quote } from './invalid-input.ts';
import { lazily } from './lazily.ts';
import type { Method } from './methods/define.ts';
import { METHODS } from './methods/index.ts';
import type { Ray } from './ray.ts';
import type { Shape } from './shapes/index.ts';
import { checkedShape } from './shapes/lookup.ts';
import type { Given } from './vec3.ts';

/**
 * What `intersect` and the page use unless told otherwise: the class of exact arithmetic, and each
 * root one of the two doubles around it, at a price that a picture can pay. The page still compares
 * every class that it shows with the exact method's.
 */
export const DEFAULT_METHOD = 'certified';

/**
 * `intersect` for a shape without ends and a ray that starts on no surface: what a page needs
 * before its first frame.
 *
 * @param shape as for `intersect`.
 * @param ray as for `intersect`.
 * @param method the `id` of one of METHODS.
 * @throws InvalidInput as `intersect` does, and for ends.
 * @see NUMERICS.md, section 1: formulas; section 4: what is promised of the answer.
 * @example
 * const ray = { origin: [-5, 0, 0], direction: [1, 0, 0] } as const;
 * intersectWhole({ kind: 'sphere', center: [0, 0, 0], radius: 2 }, ray).class; // → 'two'
 */
export const intersectWhole = (
  shape: Given<Shape>,
  ray: Given<Ray>,
  method: string = DEFAULT_METHOD,
): Intersection => methodOf(method).intersect(checkedShape(shape), checkedRay(ray));

/**
 * The method with this `id`, or undefined.
 *
 * @param id any text.
 * @example
 * findMethod('certified')?.title; // → 'certified'
 * findMethod('newton'); // → undefined
 */
export function findMethod(id: string): Method | undefined {
  return byId().get(id);
}

const byId = lazily(
  (): ReadonlyMap<string, Method> => new Map(METHODS.map((method) => [method.id, method])),
);

/** The same; an id that there is not is refused. */
export function methodOf(id: string): Method {
  const found = findMethod(id);
  if (!found) throw new InvalidInput(`unknown method ${quote(id)}`);
  return found;
}
