import { afterEach, expect, test } from 'vitest';
import { accelerate, decelerate } from '../../../../src/math/accelerate.ts';
import { createAnswers, packRays } from '../../../../src/math/batch/batch.ts';
import { batchOf, targetOf } from '../../../../src/math/batch/kernels.ts';
import { isFast } from '../../../../src/math/methods/certified/kernel.ts';
import { METHODS } from '../../../../src/math/methods/index.ts';
import type { Shape } from '../../../../src/math/shapes/index.ts';

const shape: Shape = { kind: 'cylinder', center: [0, 0, 0], radius: 5 };
const certified = METHODS.find(({ id }) => id === 'certified') as (typeof METHODS)[number];

afterEach(decelerate);

test('a kernel is SIMD only while accelerated, and never where TypeScript is asked for', () => {
  expect(targetOf(certified, shape)).toBe('typescript');
  expect(targetOf(certified, shape, 'simd')).toBe('typescript');
  accelerate();
  expect(targetOf(certified, shape)).toBe('simd');
  expect(targetOf(certified, shape, 'simd')).toBe('simd');
  expect(targetOf(certified, shape, 'typescript')).toBe('typescript');
  expect(targetOf(METHODS[METHODS.length - 1] as (typeof METHODS)[number], shape)).toBe(
    'typescript',
  );
});

test.each(METHODS.map((method) => [method.id, method] as const))(
  '%s in TypeScript leaves the module as accelerated as it was',
  (_, method) => {
    accelerate();
    const rays = packRays([{ origin: [-10, 0, 3], direction: [1, 0, 0] }]);
    const out = createAnswers(1);
    batchOf(method, shape, 'typescript').both(rays, out);
    expect([out.t0[0], out.t1[0], isFast()]).toEqual([6, 14, true]);
  },
);
