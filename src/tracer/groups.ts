import { type Boxed, type Hierarchy, hierarchyOf } from './boxes.ts';
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
