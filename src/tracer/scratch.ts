import { type Asker, createAsker, type HeightsEffect } from './ask.ts';
import { BUNDLE, type Bundles, createBundles } from './boxes.ts';
import type { StartRule } from './types.ts';

/** Buffers for one wave at a time; `need` enlarges them for so many rays. */
export interface Scratch {
  asker(): Asker;
  /** 0, 1, 2, … */
  everyone(): Int32Array;
  /** A list of rays. */
  meeting(): Int32Array;
  bundles(): Bundles;
  /** A list of bundles for each level of a hierarchy of boxes. */
  kept(depth: number): Int32Array;
  need(count: number): void;
}

export function createScratch(start: StartRule, heights: HeightsEffect | undefined): Scratch {
  let capacity = 0;
  let asker = createAsker(0, start, heights);
  let everyone = new Int32Array(0);
  let meeting = new Int32Array(0);
  let lists: Int32Array[] = [];
  let bundles = createBundles(0);
  return {
    asker: () => asker,
    everyone: () => everyone,
    meeting: () => meeting,
    bundles: () => bundles,
    kept(depth) {
      while (lists.length <= depth) lists.push(new Int32Array(Math.ceil(capacity / BUNDLE)));
      return lists[depth] as Int32Array;
    },
    need(count) {
      if (capacity >= count) return;
      capacity = 2 * count;
      asker = createAsker(capacity, start, heights);
      everyone = Int32Array.from({ length: capacity }, (_, i) => i);
      meeting = new Int32Array(capacity);
      lists = [];
      bundles = createBundles(capacity);
    },
  };
}
