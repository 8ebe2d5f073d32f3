import { expect, test } from 'vitest';
import { intersect } from '../../src/math/intersect.ts';
import type { Ray } from '../../src/math/ray.ts';
import type { Shape } from '../../src/math/shapes/index.ts';
import { disagreement, misplaced } from '../unit/math/against-exact.ts';

/*
 * Both roots of this ray are below the doubles, and t = ±0 is faithful; but t d is as long as the
 * cone is wide, since d is 1e286. Certified called E the point of both hits. Found by `npm run fuzz
 * -- --seed 2`.
 */
const cone: Shape = { kind: 'cone', vertex: [0, 0, 0], slope: 2 };
const ray: Ray = { origin: [0, 8.32e-78, -3.41e-77], direction: [0, 0, -1.16e286] };

test('a root that underflows has its own point', () => {
  expect(disagreement(cone, ray)).toBeNull();
  expect(misplaced({ shape: cone, ray })).toEqual([]);
  const [near, far] = intersect(cone, ray, 'certified').hits;
  expect([near?.point[2], far?.point[2]].map((z) => z?.toPrecision(3))).toEqual([
    '1.66e-77',
    '-1.66e-77',
  ]);
});
