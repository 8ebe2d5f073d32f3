import { expect, test } from 'vitest';
import type { Ray } from '../../src/math/ray.ts';
import type { Shape } from '../../src/math/shapes/index.ts';
import { disagreement } from '../unit/math/against-exact.ts';

/*
 * Certified called C exactly zero, and the root +0, when the only coordinate that kept E off the
 * surface was so small that its square is 0 in doubles. The root is tiny and has a sign. Found by
 * the rays fuzzer (seed 1).
 */
const cases: readonly { shape: Shape; ray: Ray }[] = [
  {
    shape: { kind: 'cone', vertex: [-2, -2, 0], slope: 1 },
    ray: { origin: [0, 0, 4.26e-317], direction: [2, 0, 1] },
  },
  {
    shape: { kind: 'cylinder', center: [-3, 2, -1.91e-317], radius: 1 },
    ray: { origin: [-2, 1, 0], direction: [1, 1, 0] },
  },
  {
    shape: { kind: 'hyperboloid', center: [8, 0, -4], flare: 1, radius: 1.625 },
    ray: { origin: [8.625, -2.42e-273, -5.5], direction: [0, 0, 3] },
  },
  {
    shape: { kind: 'cylinder', center: [1.5, 0, 0], radius: 1.75 },
    ray: { origin: [-0.25, 0, -5.45e-288], direction: [-1, 1, 0] },
  },
];

test.each(cases)('$shape.kind', ({ shape, ray }) => {
  expect(disagreement(shape, ray)).toBeNull();
});
