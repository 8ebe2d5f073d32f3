import { expect, test } from 'vitest';
import type { Ray, Shape } from '../../src/math/index.ts';
import { disagreement, misplaced } from '../unit/math/against-exact.ts';

/*
 * Points of `certified` that were off by up to 150 orders of magnitude: the stage that finds the
 * roots had refilled, in units of its own, the numbers that the point was then made of.
 */
const CASES: readonly [Shape, Ray][] = [
  [
    { kind: 'cone', vertex: [0, 0, 0], slope: 1 },
    { origin: [1e-119, 1.00000001e-119, 0], direction: [6e29, 0, 0] },
  ],
  [
    { kind: 'cylinder', center: [0, 0, 0], radius: 1e-119 },
    { origin: [1.00000001e-119, 0, 0], direction: [6e29, 0, 1e29] },
  ],
  [
    { kind: 'cylinder', center: [0, 0, 0], radius: 1e-121 },
    { origin: [1.0001e-121, 0, 0], direction: [3e28, 0, 0] },
  ],
];

test.each(CASES)('%o %o', (shape, ray) => {
  expect(disagreement(shape, ray)).toBeNull();
  expect(misplaced({ shape, ray })).toEqual([]);
});
