import { expect, test } from 'vitest';
import type { Ray, Shape } from '../../src/math/index.ts';
import { misplaced } from '../unit/math/against-exact.ts';

/*
 * F' was ∞ and its error finite: as known perfectly as can be, and so the step from the rounded
 * root to the exact one was 0.
 */
const CASES: readonly [Shape, Ray][] = [
  [
    { kind: 'cylinder', center: [0, 0, 0], radius: 1e20 },
    { origin: [0, 0, 8e19], direction: [1.7e288, 0, 0] },
  ],
  [
    { kind: 'cylinder', center: [0, 0, 0], radius: 6.15794117450272e27 },
    {
      origin: [-4.930015916278762e33, 0, 6.157941167312232e27],
      direction: [5.2950217664993044e284, 0, 0],
    },
  ],
];

test.each(CASES)('%o %o', (shape, ray) => {
  expect(misplaced({ shape, ray })).toEqual([]);
});
