import { expect, test } from 'vitest';
import { packRays } from '../../../src/math/batch/batch.ts';
import { quadricOf } from '../../../src/math/batch/quadric.ts';
import { FAMILIES } from '../../../src/math/families.ts';
import { intersect } from '../../../src/math/intersect.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { seeded, uniform } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { departs } from '../../../src/tracer/departs.ts';

const says = (shape: Shape, ray: Ray): boolean | null => {
  const q = quadricOf(shape);
  if (!q) return null;
  const a = q.squared ? q.flare * q.flare : q.hasY ? q.flare : 0;
  return departs(q, a, packRays([ray]), 0);
};
const comesBack = (shape: Shape, ray: Ray): boolean =>
  intersect(shape, ray, 'exact', { from: shape }).hits.some(({ t }) => t > 0);

test('never says so of a ray that comes back: stored hits of all families (seed 11)', () => {
  const random = seeded(11);
  const said = { departs: 0, leaves: 0, asked: 0 };
  for (const family of FAMILIES()) {
    for (let k = 0; k < 150; k++) {
      const { shape, ray } = family.make(random);
      const [hit] = intersect(shape, ray, 'exact').hits;
      if (!hit?.point.every(Number.isFinite)) continue;
      const towards = [hit.normal, ray.direction, [0, 1, 0]][k % 3] ?? hit.normal;
      const direction = towards.map((x) => x + uniform(random, -1, 1)) as [number, number, number];
      const leaving: Ray = { origin: hit.point, direction };
      const answer = says(shape, leaving);
      if (answer === null) continue;
      const back = comesBack(shape, leaving);
      said.asked += 1;
      if (!back) said.leaves += 1;
      if (!answer) continue;
      said.departs += 1;
      expect([family.id, shape, leaving, back]).toEqual([family.id, shape, leaving, false]);
    }
  }
  expect(said.asked).toBeGreaterThan(1500);
  expect(said.departs).toBeGreaterThan(0.5 * said.leaves);
});

test('nor of one that starts anywhere else: on the axis, far inside, far outside (seed 12)', () => {
  const random = seeded(12);
  const pick = (): number => (random() < 0.2 ? 0 : uniform(random, -3, 3));
  for (let k = 0; k < 4000; k++) {
    const shape: Shape = [
      { kind: 'cylinder', center: [0, 0, 0], radius: 1 } as const,
      { kind: 'cone', vertex: [0, 1, 0], slope: 0.5 } as const,
      { kind: 'hyperboloid', center: [0, 0, 0], flare: uniform(random, -1, 1), radius: 1 } as const,
    ][k % 3] as Shape;
    const direction = [pick(), pick(), pick() || 1] as const;
    const ray: Ray = { origin: [pick(), pick(), pick()], direction };
    if (says(shape, ray)) expect(comesBack(shape, ray)).toBe(false);
  }
});
