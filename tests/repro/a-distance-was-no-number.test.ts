import { expect, test } from 'vitest';
import { intersect } from '../../src/math/intersect.ts';
import { METHODS } from '../../src/math/methods/index.ts';
import type { Ray } from '../../src/math/ray.ts';
import type { Shape } from '../../src/math/shapes/index.ts';

/*
 * compensated said "outside the square" and gave NaN for how far: coordinates of 1e200 are within
 * the reach of double-double, their squares are not. (And moment gave a negative distance for a
 * place that its own rounding moved into the circle: tests/unit/math/methods-batch.test.ts asks for
 * that.)
 */
const square: Shape = { kind: 'square', corner: [0, 0, 0], side: 1, axis: 'z' };
const ray: Ray = { origin: [3e200, 4e200, 1], direction: [0, 0, -1] };

test.each(METHODS.map(({ id }) => id))('%s: beside a square by 5e200', (id) => {
  const { class: verdict, details } = intersect(square, ray, id);
  if (details.family !== 'flat') throw new Error('a square is flat');
  // 5e200 is beyond float32.
  if (verdict === 'undecided') return;
  expect(verdict).toBe('none');
  const { distance } = details.plane ?? { distance: Number.NaN };
  // In doubles the squares overflow, and that is said by an infinity.
  const mayOverflow = !['compensated', 'certified', 'exact'].includes(id);
  if (mayOverflow && distance === Infinity) return;
  expect(Math.abs(distance / 5e200 - 1)).toBeLessThan(1e-15);
});
