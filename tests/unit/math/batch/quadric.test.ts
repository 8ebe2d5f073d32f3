import { describe, expect, test } from 'vitest';
import {
  type Answers,
  createAnswers,
  type Kernel,
  packRays,
  VERDICTS,
  verdictsOfClasses,
  verdictsOfRoots,
} from '../../../../src/math/batch/batch.ts';
import { exactKernel } from '../../../../src/math/batch/exact.ts';
import { solveExactly } from '../../../../src/math/batch/exact-quadric.ts';
import { quadricOf } from '../../../../src/math/batch/quadric.ts';
import { FAMILIES, type Family, findFamily } from '../../../../src/math/families.ts';
import { nextDown, nextUp } from '../../../../src/math/float/ulp.ts';
import { certifiedKernel } from '../../../../src/math/methods/certified/kernel.ts';
import { integer, seeded } from '../../../../src/math/rng.ts';
import { many } from '../../many.ts';
import { rayCases, readAll } from '../read-vectors.ts';

const curved = rayCases.filter(({ shape }) => quadricOf(shape));

function answersOf(kernel: Kernel, c: (typeof curved)[number]) {
  const rays = packRays([c.ray]);
  const out = createAnswers(1);
  kernel.both(rays, out);
  const [verdict] = verdictsOfRoots(out, 1);
  const roots = [out.t0[0] as number, out.t1[0] as number].filter((t) => !Number.isNaN(t));
  kernel.classes(rays, out);
  return { verdict, roots, byClasses: verdictsOfClasses(out, 1, kernel.met)[0] };
}

test('there are curved cases', () => expect(curved.length).toBeGreaterThan(900));

test('exact is bit-equal to the vectors', () => {
  for (const c of curved) {
    const slot = { t0: 0, t1: 0 };
    const q = quadricOf(c.shape);
    if (!q) throw new Error('no quadric');
    const verdict = solveExactly(q, ...c.ray.origin, ...c.ray.direction, slot);
    const roots = [slot.t0, slot.t1].filter((t) => !Number.isNaN(t));
    expect([c.id, VERDICTS[verdict], roots]).toEqual([
      c.id,
      c.expect.class,
      readAll(c.expect.roots),
    ]);
  }
});

describe('certified', () => {
  test('class and faithful roots on the vectors', () => {
    for (const c of curved) {
      const q = quadricOf(c.shape);
      if (!q) throw new Error('no quadric');
      const { verdict, roots, byClasses } = answersOf(certifiedKernel(q), c);
      expect([c.id, verdict, byClasses]).toEqual([c.id, c.expect.class, c.expect.class]);
      expect(roots).toHaveLength(c.expect.faithful.length);
      roots.forEach((t, k) => {
        const around = readAll(c.expect.faithful[k] ?? []);
        expect([c.id, k, t, around, around.includes(t)]).toEqual([c.id, k, t, around, true]);
      });
    }
  });
});

describe('first is what both roots and the range give, to the bit', () => {
  const least = (out: Answers, i: number, tMin: number, tMax: number): number =>
    [out.t0[i] as number, out.t1[i] as number].find((t) => t >= tMin && t <= tMax) ?? Number.NaN;
  const all = FAMILIES().map(({ id }) => id);
  test.each(all)('%s', (id) => {
    const random = seeded(321);
    const { shape, rays: list } = (findFamily(id) as Family).batch(random, many(400));
    const q = quadricOf(shape);
    if (!q) return;
    const rays = packRays(list);
    const [pairs, out] = [createAnswers(rays.count), createAnswers(rays.count)];
    for (const [name, kernel] of [
      ['certified', certifiedKernel(q)],
      ['exact', exactKernel(shape)],
    ] as const) {
      kernel?.both(rays, pairs);
      // Ranges about a ray's own roots, and so beside, between and around those of the others.
      const i = integer(random, 0, rays.count - 1);
      const [near, far] = [pairs.t0[i] as number, pairs.t1[i] as number];
      const middle = (near + far) / 2;
      const ranges = [
        [0, Infinity],
        [-Infinity, 0],
        [-Infinity, Infinity],
        [near, middle],
        [middle, far],
        [middle, middle],
        [nextUp(near), nextDown(far)],
        [far, near],
      ] as const;
      for (const [tMin, tMax] of ranges) {
        kernel?.first(rays, tMin, tMax, out);
        const want = list.map((_, k) => least(pairs, k, tMin, tMax));
        expect([name, tMin, tMax, [...out.t0.subarray(0, rays.count)]]).toEqual([
          name,
          tMin,
          tMax,
          want,
        ]);
      }
    }
  });
});
