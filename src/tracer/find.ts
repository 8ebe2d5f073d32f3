import type { Rays } from '../math/batch/batch.ts';
import type { Feelers, Wave } from '../scene/effects/body.ts';
import { AHEAD, type Asker, createAsker, type HeightsEffect, startOf } from './ask.ts';
import { type Boxed, type Hierarchy, hierarchyOf, meetBox } from './boxes.ts';
import type { Tally } from './ledger.ts';
import { NOTHING, type StartRule } from './types.ts';
import type { Target } from './world.ts';

export interface Finder {
  /** The nearest hit of each ray of the wave, into t and surface. */
  nearest(wave: Wave, tally: Tally): void;
  /** Whether anything that blocks light is hit before the limit, into blocker. */
  blocked(feelers: Feelers, tally: Tally): void;
}

/**
 * Boxes pay from this many surfaces that have one. Below, every surface is asked about every ray, and what a method gets wrong outside of a
 * shape's box is seen, too.
 */
export const BOXES_PAY = 6;

interface Groups {
  /** Asked about every ray. */
  readonly open: readonly Target[];
  readonly boxed: readonly Hierarchy[];
}

function groupsOf(targets: readonly Target[], pays: boolean): Groups {
  const boxed = targets.flatMap(({ box, surface }): Boxed[] => (box ? [{ box, surface }] : []));
  if (!pays || boxed.length === 0) return { open: targets, boxed: [] };
  return { open: targets.filter(({ box }) => !box), boxed: [hierarchyOf(boxed)] };
}

/** Scratch for as many rays as asked for so far. */
interface Room {
  readonly capacity: number;
  readonly asker: Asker;
  readonly everyone: Int32Array;
  /** Lists for the levels of a hierarchy. */
  readonly lists: Int32Array[];
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
}

export function createFinder(
  targets: readonly Target[],
  start: StartRule,
  heights: HeightsEffect | undefined,
  least = BOXES_PAY,
): Finder {
  const pays = targets.filter(({ box }) => box).length >= least;
  const all = groupsOf(targets, pays);
  const blocking = groupsOf(
    targets.filter(({ blocks }) => blocks),
    pays,
  );
  const tMin = startOf(start);
  let room = roomFor(2048);

  function roomFor(capacity: number): Room {
    return {
      capacity,
      asker: createAsker(capacity, start, heights),
      everyone: Int32Array.from({ length: capacity }, (_, i) => i),
      lists: [],
      x: new Float64Array(capacity),
      y: new Float64Array(capacity),
      z: new Float64Array(capacity),
    };
  }

  function enough(count: number): Room {
    if (room.capacity < count) room = roomFor(2 * count);
    return room;
  }

  function list(depth: number): Int32Array {
    const { lists, capacity } = room;
    while (lists.length <= depth) lists.push(new Int32Array(capacity));
    return lists[depth] as Int32Array;
  }

  function slopes({ dx, dy, dz }: Rays, count: number): void {
    const { x, y, z } = room;
    for (let i = 0; i < count; i++) {
      x[i] = 1 / (dx[i] as number);
      y[i] = 1 / (dy[i] as number);
      z[i] = 1 / (dz[i] as number);
    }
  }

  function nearest(wave: Wave, tally: Tally): void {
    const { count, t, surface } = wave;
    const { everyone, asker } = enough(count);
    t.fill(Number.POSITIVE_INFINITY, 0, count);
    surface.fill(NOTHING, 0, count);
    // Camera rays leave nothing: any t > 0 counts for them.
    const least = wave.depth === 0 ? AHEAD : tMin;
    const ask = (target: Target, rays: Int32Array, n: number): void => {
      if (wave.depth === 0 && rays === everyone) {
        asker.firstOf(target, wave.rays, least, tally);
        takeNearer(target.surface, everyone, asker.out.t0, count, wave);
        return;
      }
      asker.pack(target, wave.rays, wave.from, rays, n, tally);
      asker.firstOf(target, asker.others.rays, least, tally);
      const { others, leaving, out } = asker;
      takeNearer(target.surface, others.index, out.t0, others.rays.count, wave);
      asker.firstOfLeaving(target, tally);
      takeNearer(target.surface, leaving.index, out.t0, leaving.rays.count, wave);
    };
    const descend = (node: Hierarchy, rays: Int32Array, n: number, depth: number): void => {
      const kept = list(depth);
      const m = meetBox(node.box, wave.rays, room, t, rays, n, kept);
      if (m === 0) return;
      if (node.leaf) ask(targets[node.surface] as Target, kept, m);
      else {
        descend(node.near, kept, m, depth + 1);
        descend(node.far, kept, m, depth + 1);
      }
    };
    if (all.boxed.length > 0) slopes(wave.rays, count);
    for (const target of all.open) ask(target, everyone, count);
    for (const node of all.boxed) descend(node, everyone, count, 0);
    for (let i = 0; i < count; i++) {
      if (surface[i] === NOTHING) t[i] = Number.NaN;
    }
  }

  function blocked(feelers: Feelers, tally: Tally): void {
    const { count, blocker, limit, t } = feelers;
    const { everyone, asker } = enough(count);
    blocker.fill(NOTHING, 0, count);
    t.set(limit.subarray(0, count));
    const take = (target: Target, index: Int32Array, n: number): void => {
      const { t0 } = asker.out;
      for (let k = 0; k < n; k++) {
        const i = index[k] as number;
        if (!((t0[k] as number) < (limit[i] as number))) continue;
        blocker[i] = target.surface;
        t[i] = t0[k] as number;
      }
    };
    const ask = (target: Target, rays: Int32Array, n: number): void => {
      const { others, leaving } = asker;
      asker.pack(target, feelers.rays, feelers.from, rays, n, tally);
      asker.keepMeeting(target, tally);
      asker.firstOf(target, others.rays, tMin, tally);
      take(target, others.index, others.rays.count);
      asker.firstOfLeaving(target, tally);
      take(target, leaving.index, leaving.rays.count);
    };
    /** Those of the list that nothing blocks so far. */
    const free = (rays: Int32Array, n: number, kept: Int32Array): number => {
      let m = 0;
      for (let k = 0; k < n; k++) {
        const i = rays[k] as number;
        kept[m] = i;
        m += blocker[i] === NOTHING ? 1 : 0;
      }
      return m;
    };
    const descend = (node: Hierarchy, rays: Int32Array, n: number, depth: number): void => {
      const kept = list(depth);
      const m = meetBox(node.box, feelers.rays, room, limit, rays, n, kept);
      const left = free(kept, m, kept);
      if (left === 0) return;
      if (node.leaf) ask(targets[node.surface] as Target, kept, left);
      else {
        descend(node.near, kept, left, depth + 1);
        descend(node.far, kept, left, depth + 1);
      }
    };
    if (blocking.boxed.length > 0) slopes(feelers.rays, count);
    for (const node of blocking.boxed) descend(node, everyone, count, 0);
    for (const target of blocking.open) {
      const kept = list(0);
      const left = free(everyone, count, kept);
      if (left > 0) ask(target, kept, left);
    }
  }

  return { nearest, blocked };
}

/** Of two surfaces at the same t the first of the scene counts, in whatever order they are asked. */
function takeNearer(
  target: number,
  index: Int32Array,
  found: Float64Array,
  count: number,
  { t, surface }: Wave,
): void {
  for (let k = 0; k < count; k++) {
    const i = index[k] as number;
    const x = found[k] as number;
    const best = t[i] as number;
    if (x < best || (x === best && target < (surface[i] as number))) {
      t[i] = x;
      surface[i] = target;
    }
  }
}
