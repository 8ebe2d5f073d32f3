import { afterAll, expect } from 'vitest';
import { decelerate } from '../../src/math/accelerate.ts';
import { kernelArray } from '../../src/math/batch/memory.ts';

/* Test files share their modules: what one leaves switched on, the next one of its thread finds. */

afterAll(() => {
  const { byteLength } = kernelArray(1).buffer;
  decelerate();
  expect(byteLength, 'accelerate() is undone in the file that called it').toBe(8);
});
