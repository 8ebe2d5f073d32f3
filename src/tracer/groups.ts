import type { Rays } from '../math/batch.ts';
import {
  type Boxed,
  BUNDLE,
  bundle,
  bundlesAtBox,
  type Hierarchy,
  type HierarchyLeaf,
  hierarchyOf,
  meetBox,
} from './boxes.ts';
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
 * Asks each surface of a hierarchy about the rays that meet its box before their limit. `keep`
 * leaves rays out of a list and returns the number of those that stay.
 */
export function askBoxed(
  { boxed }: Groups,
  { rays, count, limit }: Asked,
  scratch: Scratch,
  ask: (surface: number, list: Int32Array, n: number) => void,
  keep?: (list: Int32Array, n: number) => number,
): void {
  if (boxed.length === 0) return;
  const { bundles, kept } = scratch;
  const all = bundle(rays, count, bundles());

  const askLeaf = (leaf: HierarchyLeaf, list: Int32Array, n: number): void => {
    const meeting = scratch.meeting();
    let m = 0;
    for (let k = 0; k < n; k++) {
      const first = BUNDLE * (list[k] as number);
      const end = Math.min(first + BUNDLE, count);
      for (let i = first; i < end; i++) meeting[m++] = i;
    }
    if (keep) m = keep(meeting, m);
    m = meetBox(leaf.box, rays, bundles(), limit, meeting, m, meeting);
    if (m > 0) ask(leaf.surface, meeting, m);
  };
  const descend = (node: Hierarchy, list: Int32Array, n: number, depth: number): void => {
    const those = kept(depth);
    const left = bundlesAtBox(node.box, bundles(), list, n, those);
    if (left === 0) return;
    if (node.leaf) askLeaf(node, those, left);
    else {
      descend(node.near, those, left, depth + 1);
      descend(node.far, those, left, depth + 1);
    }
  };
  for (const node of boxed) descend(node, scratch.everyone(), all, 0);
}
