import { expect, test } from 'vitest';
import { accelerate, decelerate } from '../../src/math/accelerate.ts';
import { createAnswers, packRays } from '../../src/math/batch/batch.ts';
import { batchOf } from '../../src/math/batch/kernels.ts';
import { certified } from '../../src/math/methods/certified.ts';

/*
 * The kernels write the answers of two rays at a time. Of an odd number the last one took what came
 * after it along, where the answers' arrays are longer.
 */
test('an odd number of rays leaves the rest of the answers alone', () => {
  expect(accelerate()).toBe(true);
  try {
    const ray = { origin: [-3, 0, 0], direction: [1, 0, 0] } as const;
    const out = createAnswers(20);
    out.t0.fill(7);
    out.t1.fill(7);
    const kernel = batchOf(certified, { kind: 'cylinder', center: [0, 0, 0], radius: 1 });
    kernel.both(packRays(Array(17).fill(ray)), out);
    expect([...out.t0]).toEqual([...Array(17).fill(2), 7, 7, 7]);
    expect([...out.t1]).toEqual([...Array(17).fill(4), 7, 7, 7]);
  } finally {
    decelerate();
  }
});
