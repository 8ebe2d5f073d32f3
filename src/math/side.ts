import type { Sign } from './intersection.ts';
import { exactSide } from './methods/exact-line.ts';
import type { Shape } from './shapes/index.ts';
import { definitionOf } from './shapes/lookup.ts';
import type { Vec3 } from './vec3.ts';

/**
 * On which side of a curved surface a point lies, exactly: the sign of C for a ray from there, −1
 * inside, 0 on the surface, 1 outside. Null for a flat shape, which has no inside.
 *
 * @param shape as for `intersect`.
 * @param at a point, in units of length.
 * @returns no unit: −1, 0, 1, or null.
 * @see NUMERICS.md, section 1: C.
 * @example
 * const sphere = { kind: 'sphere', center: [0, 0, 0], radius: 2 } as const;
 * [sideOf(sphere, [0, 1, 0]), sideOf(sphere, [0, 2, 0]), sideOf(sphere, [0, 3, 0])];
 * // → [-1, 0, 1]
 */
export function sideOf(shape: Shape, at: Vec3): Sign | null {
  return exactSide(definitionOf(shape), shape, at);
}
