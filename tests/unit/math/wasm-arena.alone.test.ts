import { afterEach, describe, expect, test, vi } from 'vitest';
import { createArena } from '../../../src/math/batch/simd-arena.ts';
import { ARENA, PAGES } from '../../../src/math/batch/simd-memory.ts';
import { integer, seeded } from '../../../src/math/rng.ts';

/*
 * Arrays in the kernels' memory. The collector is played here: what it finds unused comes back when
 * the test says so.
 */

const SIZE = 65536 * PAGES;
const buffer = new ArrayBuffer(SIZE);

interface Registered {
  readonly target: Float64Array;
  readonly held: unknown;
}

/** An arena, and its arrays to give back by hand. */
function arena(): {
  readonly make: ReturnType<typeof createArena>;
  readonly drop: (array: Float64Array) => void;
} {
  const registered: Registered[] = [];
  let collected: (held: unknown) => void = () => {};
  vi.stubGlobal(
    'FinalizationRegistry',
    class {
      constructor(callback: (held: unknown) => void) {
        collected = callback;
      }
      register(target: Float64Array, held: unknown): void {
        registered.push({ target, held });
      }
    },
  );
  const make = createArena(buffer, ARENA);
  return {
    make,
    drop(array) {
      const at = registered.findIndex(({ target }) => target === array);
      expect(at).toBeGreaterThanOrEqual(0);
      for (const { held } of registered.splice(at, 1)) collected(held);
    },
  };
}

afterEach(() => {
  vi.unstubAllGlobals();
});

const made = (array: Float64Array | null): Float64Array => {
  if (!array) throw new Error('the arena is full');
  return array;
};

describe("arrays in the kernels' memory", () => {
  test('zeros of the length that is asked for, after what belongs to the kernels', () => {
    new Float64Array(buffer).fill(5);
    const { make } = arena();
    for (const n of [0, 1, 7, 8, 9, 1000]) {
      const array = made(make(n));
      expect(array.buffer).toBe(buffer);
      expect(array.length).toBe(n);
      expect(array.every((x) => Object.is(x, 0))).toBe(true);
      expect(array.byteOffset).toBeGreaterThanOrEqual(ARENA);
      expect(array.byteOffset % 64).toBe(0);
    }
  });

  test('what is given out again is zeros again, and goes to arrays of its size only', () => {
    const { make, drop } = arena();
    const first = made(make(100));
    const at = first.byteOffset;
    first.fill(3);
    drop(first);
    const longer = made(make(200));
    expect(longer.byteOffset).not.toBe(at);
    const again = made(make(100));
    expect(again.byteOffset).toBe(at);
    expect(again.every((x) => Object.is(x, 0))).toBe(true);
    expect(made(make(100)).byteOffset).not.toBe(at);
  });

  test('a place that serves a shorter array serves a longer one of the same lines wholly', () => {
    const { make, drop } = arena();
    const short = made(make(9));
    const neighbour = made(make(9));
    neighbour.fill(4);
    drop(short);
    const long = made(make(16));
    expect(long.byteOffset).toBe(short.byteOffset);
    long.fill(1);
    expect(neighbour.every((x) => x === 4)).toBe(true);
  });

  test('arrays that are alive never overlap, nor come within a pair of doubles (seed 171)', () => {
    const { make, drop } = arena();
    const random = seeded(171);
    const alive: Float64Array[] = [];
    for (let k = 0; k < 3000; k++) {
      if (alive.length > 0 && random() < 0.45) {
        drop(alive.splice(integer(random, 0, alive.length - 1), 1)[0] as Float64Array);
      } else {
        const array = make(integer(random, 0, 5) * integer(random, 0, 400));
        if (array) alive.push(array);
      }
      if (k % 50 !== 0) continue;
      const ordered = alive.toSorted((a, b) => a.byteOffset - b.byteOffset);
      ordered.forEach((array, i) => {
        const next = ordered[i + 1]?.byteOffset ?? SIZE;
        expect(array.byteOffset + array.byteLength + 16).toBeLessThanOrEqual(next);
      });
    }
    expect(alive.length).toBeGreaterThan(100);
  });

  test('null when it is full, and no sooner; then smaller ones still find room', () => {
    const { make, drop } = arena();
    const n = 2 ** 19;
    const arrays: Float64Array[] = [];
    for (let array = make(n); array; array = make(n)) arrays.push(array);
    expect(arrays.length).toBe(Math.floor((SIZE - ARENA) / (8 * n + 192)));
    expect(make(n)).toBeNull();
    expect(make(16)).not.toBeNull();
    drop(arrays[2] as Float64Array);
    expect(make(n)?.byteOffset).toBe(arrays[2]?.byteOffset);
    expect(make(n)).toBeNull();
  });

  test('a length beyond the memory is null, whatever it is', () => {
    const { make } = arena();
    for (const n of [2 ** 22, 2 ** 40, Number.POSITIVE_INFINITY, Number.NaN])
      expect(make(n)).toBeNull();
    expect(() => make(-1)).toThrow(RangeError);
    expect(made(make(4)).byteOffset).toBeGreaterThanOrEqual(ARENA);
  });
});
