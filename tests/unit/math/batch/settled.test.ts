import { expect, test } from 'vitest';
import { createAnswers, packRays } from '../../../../src/math/batch/batch.ts';
import { STRAIGHT } from '../../../../src/math/batch/generated/index.ts';
import { straightKernel } from '../../../../src/math/batch/straight.ts';
import { FAMILIES } from '../../../../src/math/families.ts';
import { METHODS } from '../../../../src/math/methods/index.ts';
import { seeded } from '../../../../src/math/rng.ts';
import { counting } from '../../../bench/left.ts';

/*
 * What a method's loops leave to the method itself costs many times a ray of theirs: a price would
 * be that of the leaving. So they settle every case distinction, in numbers of any usual size.
 */

/** Families in which D, A or N·d is often 0, and a sign unknown, in numbers of usual size. */
const SPECIAL = [
  ...['far-origin', 'near-tangent', 'near-tangent-far', 'exact-tangent', 'linear'],
  ...['generator', 'circle', 'sphere-whole', 'sphere-far', 'sphere-near-tangent'],
  ...['paraboloid-whole', 'paraboloid-far', 'paraboloid-near-tangent'],
];

/** Numbers of any size: what leaves the range in double-double left it in the trees. */
const ANY_SIZE = ['scale-world', 'sphere-scale-ray', 'paraboloid-scale-ray'];

test('compensated leaves no scene in other units to its trees, hit or not (seed 402)', () => {
  const compensated = METHODS.find(({ id }) => id === 'compensated') as (typeof METHODS)[number];
  const random = seeded(402);
  let left = 0;
  for (const family of FAMILIES().filter((one) => ANY_SIZE.includes(one.id))) {
    for (let k = 0; k < 20; k++) {
      const { shape, rays } = family.batch(random, 40);
      const kernel = straightKernel(
        compensated,
        shape,
        counting((count) => (left += count)),
      );
      expect(kernel, family.id).not.toBeNull();
      kernel?.both(packRays(rays), createAnswers(rays.length));
      kernel?.classes(packRays(rays), createAnswers(rays.length));
    }
  }
  expect(left).toBe(0);
});

test.each(Object.keys(STRAIGHT))('%s leaves no ray of usual size to its trees (seed 401)', (id) => {
  const method = METHODS.find((one) => one.id === id) as (typeof METHODS)[number];
  const random = seeded(401);
  const sum = { left: 0, listed: 0 };
  const source = counting((left, listed) => {
    sum.left += left;
    sum.listed += listed;
  });
  for (const family of FAMILIES().filter((one) => SPECIAL.includes(one.id))) {
    for (let k = 0; k < 4; k++) {
      const { shape, rays } = family.batch(random, 40);
      const kernel = straightKernel(method, shape, source);
      expect(kernel, family.id).not.toBeNull();
      const out = createAnswers(rays.length);
      kernel?.both(packRays(rays), out);
      kernel?.classes(packRays(rays), out);
    }
  }
  expect(sum.listed).toBeGreaterThan(0);
  expect(sum.left).toBe(0);
});
