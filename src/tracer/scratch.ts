import type { Rays } from '../math/batch.ts';
import { type Asker, createAsker, type HeightsEffect } from './ask.ts';
import type { Slopes } from './boxes.ts';
import type { StartRule } from './types.ts';

/** Buffers for one wave at a time; `need` enlarges them for so many rays. */
export interface Scratch {
  asker(): Asker;
  /** 0, 1, 2, … */
  everyone(): Int32Array;
  /** A list for each level of a hierarchy of boxes. */
  list(depth: number): Int32Array;
  /** 1/d of rays 0 … count − 1. */
  slopes(rays: Rays, count: number): Slopes;
  need(count: number): void;
}

export function createScratch(start: StartRule, heights: HeightsEffect | undefined): Scratch {
  let capacity = 0;
  let asker = createAsker(0, start, heights);
  let everyone = new Int32Array(0);
  let lists: Int32Array[] = [];
  let slopes = { x: new Float64Array(0), y: new Float64Array(0), z: new Float64Array(0) };
  return {
    asker: () => asker,
    everyone: () => everyone,
    list(depth) {
      while (lists.length <= depth) lists.push(new Int32Array(capacity));
      return lists[depth] as Int32Array;
    },
    slopes({ dx, dy, dz }, count) {
      const { x, y, z } = slopes;
      for (let i = 0; i < count; i++) {
        x[i] = 1 / (dx[i] as number);
        y[i] = 1 / (dy[i] as number);
        z[i] = 1 / (dz[i] as number);
      }
      return slopes;
    },
    need(count) {
      if (capacity >= count) return;
      capacity = 2 * count;
      asker = createAsker(capacity, start, heights);
      everyone = Int32Array.from({ length: capacity }, (_, i) => i);
      lists = [];
      const array = (): Float64Array<ArrayBuffer> => new Float64Array(capacity);
      slopes = { x: array(), y: array(), z: array() };
    },
  };
}
