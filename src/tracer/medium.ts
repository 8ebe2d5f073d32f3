import type { Vec3 } from '../math/index.ts';
import { sideOf } from '../math/shapes.ts';
import { isGlass } from '../scene/facts.ts';
import { type Surface, surfacesOf } from '../scene/surfaces.ts';
import type { Scene } from '../scene/types.ts';

/**
 * The round glass that a point lies in, as a surface of it, or −1: what a ray from a camera within
 * it begins in. Glass planes have no inside of their own (two of them make a slab), so a camera
 * between them begins in air.
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
