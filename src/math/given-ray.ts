import {
  countFields,
  requireFields,
  requireFiniteVector,
  requireNonZero,
} from './invalid-input.ts';
import type { Ray } from './ray.ts';
import type { Given } from './vec3.ts';
import { plainVector } from './vec3.ts';

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
