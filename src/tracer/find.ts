import type { Chords, ShadowRays, Wave } from '../scene/effects/body.ts';
import { type HeightsEffect, startOf } from './ask.ts';
import { findBlocked } from './blocked.ts';
import { groupsOf } from './groups.ts';
import type { Tally } from './ledger.ts';
import { findNearest } from './nearest.ts';
import { createScratch } from './scratch.ts';
import { createChords } from './through.ts';
import type { StartRule } from './types.ts';
import type { Target } from './world.ts';

interface Finder {
  /** Puts the nearest hit of each ray of the wave into t and surface. */
  nearest(wave: Wave, tally: Tally): void;
  /** Puts a surface that blocks light before the limit into blocker. */
  blocked(shadowRays: ShadowRays, tally: Tally): void;
  /** How far each shadow ray runs through the glass of each coloured surface before its limit. */
  through(shadowRays: ShadowRays, tally: Tally): readonly Chords[];
}

/**
 * Number of bounded surfaces from which boxes are used. They pay from the second one on
 * (docs/bench-tracer.md), but with few surfaces every ray is tested against each, so that a
 * method's errors outside of a shape's box are seen. `certified` and `exact` do not depend on it.
 */
export const BOXES_FROM = 6;

/** @param targets by surface. @param heights undefined if no target is cut off. */
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
    through: createChords(
      groupsOf(
        targets.filter(({ absorbs }) => absorbs),
        useBoxes,
      ),
      targets,
      scratch,
    ),
    blocked: (shadowRays, tally) =>
      findBlocked(shadowRays, blocking, targets, tMin, scratch, tally),
  };
}
