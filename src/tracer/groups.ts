import type { Rays } from '../math/batch.ts';
import { type Boxed, type Hierarchy, hierarchyOf, meetBox } from './boxes.ts';
import type { Scratch } from './scratch.ts';
import type { Target } from './world.ts';

/** Surfaces without a box, tested against every ray, and a hierarchy of the others. */
export interface Groups {
  readonly open: readonly Target[];
  readonly boxed: readonly Hierarchy[];
}

export function groupsOf(targets: readonly Target[], useBoxes: boolean): Groups {
  const boxed = targets.flatMap(({ box, surface }): Boxed[] => (box ? [{ box, surface }] : []));
  if (!useBoxes || boxed.length === 0) return { open: targets, boxed: [] };
  return { open: targets.filter(({ box }) => !box), boxed: [hierarchyOf(boxed)] };
}

interface Asked {
  readonly rays: Rays;
  readonly count: number;
  readonly limit: Float64Array;
}

/**
 * Asks each surface of a hierarchy about the rays that meet its box, and those around it, before
 * their limit. `keep` leaves rays out of a list and returns the number of those that stay.
 */
export function askBoxed(
  { boxed }: Groups,
  { rays, count, limit }: Asked,
  scratch: Scratch,
  ask: (surface: number, list: Int32Array, n: number) => void,
  keep?: (list: Int32Array, n: number) => number,
): void {
  if (boxed.length === 0) return;
  const slopes = scratch.slopes(rays, count);
  const descend = (node: Hierarchy, list: Int32Array, n: number, depth: number): void => {
    const kept = scratch.list(depth);
    const met = meetBox(node.box, rays, slopes, limit, list, n, kept);
    const left = keep ? keep(kept, met) : met;
    if (left === 0) return;
    if (node.leaf) ask(node.surface, kept, left);
    else {
      descend(node.near, kept, left, depth + 1);
      descend(node.far, kept, left, depth + 1);
    }
  };
  for (const node of boxed) descend(node, scratch.everyone(), count, 0);
}
