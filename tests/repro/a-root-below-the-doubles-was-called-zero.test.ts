import { expect, test } from 'vitest';
import type { Ray } from '../../src/math/ray.ts';
import type { Shape } from '../../src/math/shapes/index.ts';
import { disagreement } from '../unit/math/against-exact.ts';

/*
 * Certified took a root for faithful whose bound was a multiple of the root when that underflowed:
 * the bound was 0 then as well. E is off the surface by the least double, so the root is tiny and
 * has a sign. Found by the rays fuzzer (seed 61).
 */
const cases: readonly { shape: Shape; ray: Ray }[] = [
  {
    shape: { kind: 'cone', vertex: [-2, 0, -5e-324], slope: 1.75 },
    ray: { origin: [37.375, -58.5, 94.5], direction: [0, 26, 0] },
  },
  {
    shape: { kind: 'cylinder', center: [5e-324, 0, 0], radius: 1 },
    ray: { origin: [1, 0, 0], direction: [-137438953472, 0, 2] },
  },
  {
    shape: { kind: 'hyperboloid', center: [-5e-324, 0, 0], flare: 0, radius: 2 },
    ray: { origin: [2, 0, 0], direction: [2, 0, 0] },
  },
  {
    shape: { kind: 'hyperboloid', center: [0, 2, -2], flare: 5e-324, radius: 2 },
    ray: { origin: [0, 1, 0], direction: [1, 0, -1] },
  },
];

test.each(cases)('$shape.kind', ({ shape, ray }) => {
  expect(disagreement(shape, ray)).toBeNull();
});
