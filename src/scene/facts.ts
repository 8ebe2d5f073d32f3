import { planarOf } from '../math/batch/planar.ts';
import { quadricOf } from '../math/batch/quadric.ts';
import type { Vec3 } from '../math/vec3.ts';
import type { Placed, Scene } from './types.ts';

/* What effects ask of a scene. */

export const isGlass = ({ material }: Placed): boolean => material.glass !== undefined;

/** Glass lets light through (without bending a shadow ray: see the README), so it stands in no light's way. */
export const blocks = (thing: Placed): boolean => !isGlass(thing);

/** Why nothing in the scene can lie in a shadow, or null if something may. */
export function whyNoShadow(scene: Scene): string | null {
  const [only, ...others] = scene.things;
  if (!only) return 'there is nothing in the scene';
  if (!scene.things.some(blocks)) return 'everything is glass, which lets light through';
  if (others.length === 0 && shadesNothing(only, scene.camera.eye)) {
    return 'one shape alone, and the side that is seen cannot shade itself';
  }
  return null;
}

/**
 * A flat shape, or a whole cylinder or ellipsoid seen from outside: convex, so that a line from a seen point to a light on its
 * outer side does not meet it again.
 */
function shadesNothing({ shape, between }: Placed, eye: Vec3): boolean {
  if (planarOf(shape)) return true;
  const q = quadricOf(shape);
  if (!q || between) return false;
  const convex = !q.hasY || (!q.squared && q.flare < 0);
  const x = eye[0] - q.Cx;
  const y = eye[1] - q.Cy;
  const z = eye[2] - q.Cz;
  return convex && x * x + z * z - (q.hasY ? q.flare * y * y : 0) > q.r * q.r;
}
