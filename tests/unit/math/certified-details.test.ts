import { describe, expect, test } from 'vitest';
import { doubleDouble } from '../../../src/math/arithmetic/double-double.ts';
import { exact } from '../../../src/math/arithmetic/exact.ts';
import { createAnswers, packRays } from '../../../src/math/batch/batch.ts';
import { quadricOf } from '../../../src/math/batch/quadric.ts';
import { type Family, findFamily, type Question } from '../../../src/math/families.ts';
import { nextDown, nextUp } from '../../../src/math/float/ulp.ts';
import { intersect } from '../../../src/math/intersect.ts';
import type { CurvedDetails } from '../../../src/math/intersection.ts';
import {
  createAlgebra,
  createRoots,
  putAlgebra,
} from '../../../src/math/methods/certified/algebra.ts';
import { plainQuadric } from '../../../src/math/methods/certified/curved.ts';
import { putRoots } from '../../../src/math/methods/certified/doubled.ts';
import { openClasses } from '../../../src/math/methods/certified/kernel.ts';
import { certifiedQuadric } from '../../../src/math/methods/certified/numbers.ts';
import { type Random, seeded, uniform } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { exactHits } from './exact-hits.ts';

const SEED = 95;

/** Where A, b, C or D cancels to any share of its terms, with and without hits. */
const CANCELLED: readonly [string, (random: Random) => Question][] = [
  [
    'b, from beside the point nearest to the axis',
    (r) => {
      const { of, add, mul, div, sub, toNumber } = doubleDouble();
      const [x, y, z] = [uniform(r, -1, 1), uniform(r, -1, 1), uniform(r, 0.3, 1)];
      const [px, py] = [uniform(r, -3, 3), uniform(r, -3, 3)];
      const along = add(mul(of(x), of(px)), mul(mul(of(y), of(py)), of(0.5)));
      const foot = div(along, of(-z));
      const near = toNumber(foot);
      const by = r() < 0.5 ? 1 : 1 + 2 ** -uniform(r, 5, 40);
      // The rest of it is the centre's, so that b has twice the digits to cancel.
      const rest = toNumber(sub(foot, of(near))) * (1 + 2 ** -uniform(r, 0, 52));
      return {
        shape: { kind: 'hyperboloid', center: [0, 0, -rest], flare: -0.5, radius: 2 },
        ray: { origin: [px, py, near * by], direction: [x, y, z] },
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
    'A and C, where a small coordinate makes up for what a large one leaves',
    (r) => {
      const { of, add, mul, sub, toNumber } = doubleDouble();
      const [flare, py] = [uniform(r, 0.3, 2), uniform(r, 0.3, 2)];
      const by = r() < 0.5 ? 1 : 1.5;
      const more = (square: typeof wide, x: number): number =>
        Math.sqrt(Math.max(toNumber(sub(square, mul(of(x), of(x)))), 0)) * by;
      const wide = add(of(4), mul(of(flare), mul(of(py), of(py))));
      const x = Math.sqrt(flare) * (1 - 2 ** -uniform(r, 5, 50));
      const px = Math.sqrt(toNumber(wide)) * (1 - 2 ** -uniform(r, 5, 50));
      return {
        shape: { kind: 'hyperboloid', center: [0, 0, 0], flare, radius: 2 },
        ray: { origin: [px, py, more(wide, px)], direction: [x, 1, more(of(flare), x)] },
      };
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
    const algebra = createAlgebra();
    const roots = createRoots();
    let plain = 0;
    for (let k = 0; k < 600; k++) {
      const { shape, ray } = make(random);
      const q = quadricOf(shape);
      const found = q && plainQuadric(q, ray);
      if (!found) continue;
      plain += 1;
      putAlgebra(q, ray, algebra);
      putRoots(algebra, roots);
      for (const [k, hit] of exactHits(shape, ray).hits.entries()) {
        const at = roots.subarray(3 * k, 3 * k + 3);
        const told = exact.add(exact.of(at[0] as number), exact.of(at[1] as number));
        const off = exact.sub(told, hit.t);
        const size = exact.sign(off) < 0 ? exact.neg(off) : off;
        expect(exact.sign(exact.sub(exact.of(at[2] as number), size))).not.toBe(-1);
      }
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
