import { serialize, setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { afterAll, beforeAll, describe, expect, test, vi } from 'vitest';
import { accelerate, decelerate } from '../../../src/math/accelerate.ts';
import { createAnswers, createRays, packRays } from '../../../src/math/batch/batch.ts';
import { kernelArray, type MakeArray, ownArray } from '../../../src/math/batch/memory.ts';

/*
 * What becomes of batch arrays in the kernels' memory when parts of them are kept, with a real
 * collector, and what cloning them costs.
 */

setFlagsFromString('--expose-gc');
const collect = runInNewContext('gc') as () => void;
const COUNT = 96;

beforeAll(() => {
  expect(accelerate()).toBe(true);
});
afterAll(decelerate);

const placeOf = (array: Float64Array): string => `${array.byteOffset}`;

/**
 * Drops an array of this length without views, collects, and waits until its place is given out
 * again.
 */
async function untilReused(length: number): Promise<void> {
  const dropped = new Set<string>();
  await vi.waitFor(() => {
    collect();
    const place = placeOf(kernelArray(length));
    const again = dropped.has(place);
    dropped.add(place);
    expect(again).toBe(true);
  }, 20_000);
}

/** Views of what nobody holds any more. */
const views: Readonly<Record<string, (whole: Float64Array) => Float64Array>> = {
  'a part': (whole) => whole.subarray(8, 24),
  'a part of a part': (whole) => whole.subarray(4).subarray(4, 20),
  'all of it': (whole) => whole.subarray(),
};

describe.each<[string, MakeArray]>([
  ['ordinary arrays', ownArray],
  ["arrays in the kernels' memory", kernelArray],
])('%s', (_, make) => {
  test.each(Object.entries(views))('%s that is kept alone is nobody else’s', async (_, viewOf) => {
    const view = viewOf(createRays(COUNT, make).Ex.fill(7));
    await untilReused(COUNT);
    for (let k = 0; k < 64; k++) createRays(COUNT, make).Ex.fill(77);
    collect();
    const after = Array.from({ length: 64 }, () => createRays(COUNT, make).Ex.fill(78));
    expect(view.every((x) => x === 7)).toBe(true);
    expect(after.every((array) => array[0] === 78)).toBe(true);
  });
});

test('a subarray is what it is of any array: same numbers, same memory, negative ends', () => {
  const whole = kernelArray(10);
  whole.set([0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
  expect([...whole.subarray(-3, -1)]).toEqual([7, 8]);
  whole.subarray(2, 4).fill(5);
  expect([...whole.slice(1, 5)]).toEqual([1, 5, 5, 4]);
  expect(whole.slice().buffer).not.toBe(whole.buffer);
});

test('cloning what createRays, packRays and createAnswers make copies what they hold', () => {
  const ray = { origin: [1, 2, 3], direction: [0, 0, 1] } as const;
  for (const made of [createAnswers(10), createRays(10), packRays(Array(10).fill(ray))]) {
    expect(serialize(made).byteLength).toBeLessThan(2000);
    expect(structuredClone(made)).toEqual(made);
  }
  const { t0 } = createAnswers(10);
  expect(t0.buffer.byteLength).toBe(80);
});
