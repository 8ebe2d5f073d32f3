import type { Vec3 } from '../math/index.ts';
import { sideOf } from '../math/shapes.ts';
import { isGlass } from '../scene/facts.ts';
import { type Surface, surfacesOf } from '../scene/surfaces.ts';
import type { Scene } from '../scene/types.ts';

/**
 * Surface of the glass thing that contains the point, or −1: the medium of rays from a camera
 * there. A glass plane has no inside (two of them make a slab), so a camera between planes is in
 * air.
 */
export function mediumAt(scene: Scene, at: Vec3): number {
  return surfacesOf(scene).findIndex((surface) => {
    const placed = scene.things[surface.thing];
    return placed !== undefined && isGlass(placed) && isWithin(surface, at);
  });
}

function isWithin({ shape, between }: Surface, at: Vec3): boolean {
  const [low, high] = between ?? [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY];
  return at[1] > low && at[1] < high && sideOf(shape, at) === -1;
}
