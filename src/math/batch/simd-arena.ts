import { lazily } from '../lazily.ts';
import type { Allocate } from './memory.ts';

/** Arrays that begin a power of two apart would fall into the same lines of the cache. */
const GAP = 192;
const LINE = 64;

/** What a view of a part belongs to: as long as the view is reached, so is the array. */
const wholes = lazily(() => new WeakMap<ArenaArray, ArenaArray>());

class ArenaArray extends Float64Array<ArrayBuffer> {
  override subarray(begin?: number, end?: number): ArenaArray {
    // Made by this class, as JavaScript does it, so that a view of a view counts as well.
    const view = super.subarray(begin, end) as ArenaArray;
    wholes().set(view, this);
    return view;
  }
}

/**
 * Arrays in the kernels' memory, from `start` to its end. What the collector finds unused, with all
 * of its subarrays, is given out again, to arrays of the same size; when the memory is full there
 * is null, and the caller's ordinary array is copied block by block instead.
 */
export function createArena(buffer: ArrayBuffer, start: number): Allocate {
  const free = new Map<number, number[]>();
  const unused = new FinalizationRegistry(
    ({ offset, bytes }: { offset: number; bytes: number }) => {
      free.set(bytes, [...(free.get(bytes) ?? []), offset]);
    },
  );
  let next = start;
  return (length) => {
    const bytes = LINE * Math.ceil((8 * length) / LINE) + GAP;
    let offset = free.get(bytes)?.pop();
    if (offset === undefined) {
      if (!(next + bytes <= buffer.byteLength)) return null;
      offset = next;
      next += bytes;
    }
    const array = new ArenaArray(buffer, offset, length).fill(0);
    unused.register(array, { offset, bytes });
    return array;
  };
}
