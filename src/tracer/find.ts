import type { Feelers, Wave } from '../scene/effects/body.ts';
import { type HeightsEffect, startOf } from './ask.ts';
import { findBlocked } from './blocked.ts';
import { groupsOf } from './groups.ts';
import type { Tally } from './ledger.ts';
import { findNearest } from './nearest.ts';
import { createScratch } from './scratch.ts';
import type { StartRule } from './types.ts';
import type { Target } from './world.ts';

interface Finder {
  /** The nearest hit of each ray of the wave, into t and surface. */
  nearest(wave: Wave, tally: Tally): void;
  /** Whether anything that blocks light is hit before the limit, into blocker. */
  blocked(feelers: Feelers, tally: Tally): void;
}

/**
 * From this many surfaces with an end on, boxes are used. They pay from the second one
 * (docs/bench-tracer.md); below this every surface is asked about every ray all the same, so that
 * what a method gets wrong outside of a shape's box is seen, too. `certified` and `exact` answer
 * alike with and without.
 */
const BOXES_FROM = 6;

/** `targets` go by surface. `heights` is undefined where none of them is cut. */
export function createFinder(
  targets: readonly Target[],
  start: StartRule,
  heights: HeightsEffect | undefined,
  least = BOXES_FROM,
): Finder {
  const useBoxes = targets.filter(({ box }) => box).length >= least;
  const all = groupsOf(targets, useBoxes);
  const blocking = groupsOf(
    targets.filter(({ blocks }) => blocks),
    useBoxes,
  );
  const tMin = startOf(start);
  const scratch = createScratch(start, heights);
  return {
    nearest: (wave, tally) => findNearest(wave, all, targets, tMin, scratch, tally),
    blocked: (feelers, tally) => findBlocked(feelers, blocking, targets, tMin, scratch, tally),
  };
}
