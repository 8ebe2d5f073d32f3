import { expect, test } from 'vitest';
import type { Ray, Shape } from '../../src/math/index.ts';
import { misplaced } from '../unit/math/against-exact.ts';

/**
 * Found by `npm run fuzz -- --rays 1.5e6 --seed 4`: certified points off by more than a double
 * where |d| > 1e141.
 */
const CASES: readonly [Shape, Ray][] = [
  [
    { kind: 'hyperboloid', center: [0, 0, 0], flare: 1, radius: 0 },
    { origin: [0, 5192226883566150, 0], direction: [0, -2.37e149, -4.98e148] },
  ],
  [
    { kind: 'cone', vertex: [0, -25769803776, 2], slope: 18014398509481984 },
    { origin: [0, 4, 0], direction: [0, 0, 8.452652120215184e141] },
  ],
  [
    { kind: 'cone', vertex: [0, 0, 0], slope: 1 },
    { origin: [0, 0, -6078123508268702000], direction: [0, 9.21e144, 9.32e145] },
  ],
  [
    { kind: 'cylinder', center: [0, 0, 0], radius: 58280026313569360000 },
    { origin: [-160442381243221480000, 0, 0], direction: [-8.55e142, 0, 0] },
  ],
];

test.each(CASES)('%o %o', (shape, ray) => {
  expect(misplaced({ shape, ray })).toEqual([]);
});
