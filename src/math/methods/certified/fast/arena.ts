import type { Allocate } from '../../../batch/memory.ts';
import { ARENA, PAGES } from './layout.ts';

/** Arrays that begin a power of two apart would fall into the same lines of the cache. */
const GAP = 192;
const LINE = 64;
const END = PAGES * 65536;

/**
 * Arrays in the kernels' memory. What the collector finds unused is given out again, to arrays of the same size; when the memory is full there is null, and the
 * caller's ordinary array is copied block by block instead.
 */
export function createArena(buffer: ArrayBuffer): Allocate {
  const free = new Map<number, number[]>();
  const unused = new FinalizationRegistry(
    ({ offset, bytes }: { offset: number; bytes: number }) => {
      free.set(bytes, [...(free.get(bytes) ?? []), offset]);
    },
  );
  let next = ARENA;
  return (length) => {
    const bytes = LINE * Math.ceil((8 * length) / LINE) + GAP;
    let offset = free.get(bytes)?.pop();
    if (offset === undefined) {
      if (!(next + bytes <= END)) return null;
      offset = next;
      next += bytes;
    }
    const array = new Float64Array(buffer, offset, length).fill(0);
    unused.register(array, { offset, bytes });
    return array;
  };
}
