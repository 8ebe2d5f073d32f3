import { describe, expect, test } from 'vitest';
import { createAnswers, packRays } from '../../../src/math/batch/batch.ts';
import { quadricOf } from '../../../src/math/batch/quadric.ts';
import { type Family, findFamily, type Question } from '../../../src/math/families.ts';
import { nextDown, nextUp } from '../../../src/math/float/ulp.ts';
import { intersect } from '../../../src/math/intersect.ts';
import type { CurvedDetails } from '../../../src/math/intersection.ts';
import { openClasses } from '../../../src/math/methods/certified/class-quadric.ts';
import { plainQuadric } from '../../../src/math/methods/certified/plain-quadric.ts';
import { certifiedQuadric } from '../../../src/math/methods/certified/scaled-quadric.ts';
import { type Random, seeded, uniform } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';

const SEED = 95;

/** Where A, b, C or D cancels to any share of its terms, with and without hits. */
const CANCELLED: readonly [string, (random: Random) => Question][] = [
  [
    'b, from beside the point nearest to the axis',
    (r) => {
      const direction: Vec3 = [uniform(r, -1, 1), uniform(r, -1, 1), uniform(r, 0.3, 1)];
      const foot: Vec3 = [uniform(r, -3, 3), uniform(r, -3, 3), 0];
      const along = foot[0] * direction[0] - foot[1] * direction[1] * -0.5;
      const z = (-along / direction[2]) * (1 + 2 ** -uniform(r, 10, 80));
      return {
        shape: { kind: 'hyperboloid', center: [0, 0, 0], flare: -0.5, radius: 2 },
        ray: { origin: [foot[0], foot[1], z], direction },
      };
    },
  ],
  [
    'A, near the cone of directions',
    (r) => {
      const phi = uniform(r, 0, 6.3);
      const by = 1 + 2 ** -uniform(r, 10, 80);
      const direction: Vec3 = [0.7 * by * Math.cos(phi), 1, 0.7 * by * Math.sin(phi)];
      const origin: Vec3 = [uniform(r, -3, 3), uniform(r, -3, 3), uniform(r, -3, 3)];
      const shape: Shape = { kind: 'hyperboloid', center: [0, 0, 0], flare: 0.7 * 0.7, radius: 2 };
      return { shape, ray: { origin, direction } };
    },
  ],
  [
    'C, from beside the surface',
    (r) => {
      const phi = uniform(r, 0, 6.3);
      const by = 2 * (1 + 2 ** -uniform(r, 5, 80));
      const shape: Shape = { kind: 'hyperboloid', center: [0, 0, 0], flare: 0.3, radius: 2 };
      const direction: Vec3 = [uniform(r, -1, 1), uniform(r, -1, 1), uniform(r, -1, 1)];
      return { shape, ray: { origin: [by * Math.cos(phi), 0, by * Math.sin(phi)], direction } };
    },
  ],
  ['D, near a tangent', (r) => (findFamily('near-tangent') as Family).make(r)],
];

test.each(CANCELLED)(
  '%s: what one ray is told in plain numbers is faithful (seed 95)',
  (_, make) => {
    const random = seeded(SEED);
    let plain = 0;
    for (let k = 0; k < 600; k++) {
      const { shape, ray } = make(random);
      const q = quadricOf(shape);
      const found = q && plainQuadric(q, ray);
      if (!found) continue;
      plain += 1;
      const got = found.details as CurvedDetails;
      const truth = intersect(shape, ray, 'exact').details as CurvedDetails;
      expect(got.signs).toEqual(truth.signs);
      for (const key of ['A', 'B', 'C', 'D'] as const) {
        const x = truth[key];
        expect([nextDown(x), x, nextUp(x)]).toContain(got[key]);
      }
    }
    expect(plain).toBeGreaterThan(50);
  },
);

test('most rays are told in plain numbers (seed 96)', () => {
  const random = seeded(96);
  let plain = 0;
  for (let k = 0; k < 500; k++) {
    const { shape, ray } = (findFamily('typical') as Family).make(random);
    const q = quadricOf(shape);
    if (q && plainQuadric(q, ray)) plain += 1;
  }
  expect(plain).toBeGreaterThan(400);
});

describe('classes by the moment, where the direct form cannot tell', () => {
  const shape: Shape = { kind: 'hyperboloid', center: [0, 0, 0], flare: -1, radius: 1 };
  const out = createAnswers(1);
  const left = { count: 0, open: new Int32Array(1) };
  const opened = (origin: Vec3, direction: Vec3, of: Shape = shape): number => {
    const q = quadricOf(of);
    if (!q) throw new Error('no quadric');
    openClasses(q, certifiedQuadric(q), packRays([{ origin, direction }]), out, left);
    return left.count;
  };
  test('from far away', () => {
    expect(opened([-1e9, 0.5, 0.3], [1, 0, 0])).toBe(0);
    expect(out.margin[0]).toBeGreaterThan(0);
    expect(opened([-1e9, 1.5, 0.3], [1, 0, 0])).toBe(0);
    expect(out.margin[0]).toBeLessThan(0);
  });
  test('not outside of the box that its bound is derived for', () => {
    const wide: Shape = { kind: 'hyperboloid', center: [0, 0, 0], flare: -1, radius: 2 ** 75 };
    expect(opened([-(2 ** 99), 0, 2 ** 74], [1, 0, 0], wide)).toBe(0);
    expect(opened([-(2 ** 101), 0, 2 ** 74], [1, 0, 0], wide)).toBe(1);
    expect(opened([-(2 ** 99), 0, 2 ** 74], [2 ** 101, 0, 0], wide)).toBe(1);
    expect(opened([-(2 ** 99), 0, 2 ** 74], [2 ** -101, 0, 0], wide)).toBe(1);
  });
});
