import { describe, expect, test } from 'vitest';
import {
  createAnswers,
  type Kernel,
  packRays,
  VERDICTS,
  verdictsOfClasses,
  verdictsOfRoots,
} from '../../../../src/math/batch/batch.ts';
import { solveExactly } from '../../../../src/math/batch/exact-quadric.ts';
import { quadricOf } from '../../../../src/math/batch/quadric.ts';
import { certifiedKernel } from '../../../../src/math/methods/certified/quadric-kernel.ts';
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
