import { expect, test } from 'vitest';
import { createAnswers, packRays, VERDICTS } from '../../../src/math/batch/batch.ts';
import { exactKernel } from '../../../src/math/batch/exact.ts';
import { type RootSlot, solveExactly } from '../../../src/math/batch/exact-quadric.ts';
import { quadricOf } from '../../../src/math/batch/quadric.ts';
import { FAMILIES } from '../../../src/math/families.ts';
import { roundedRoots, UNKNOWN } from '../../../src/math/methods/certified/doubled.ts';
import { seeded } from '../../../src/math/rng.ts';

test.each(FAMILIES.map(({ id }) => id))(
  'twice the digits give the roots of whole numbers, to the bit, or none: %s',
  (id) => {
    const family = FAMILIES.find((one) => one.id === id);
    const random = seeded(77);
    const slot: RootSlot = { t0: 0, t1: 0 };
    const whole: RootSlot = { t0: 0, t1: 0 };
    for (let k = 0; k < 12; k++) {
      const batch = family?.batch(random, 100);
      const q = batch && quadricOf(batch.shape);
      if (!q) continue;
      const out = createAnswers(100);
      exactKernel(batch.shape)?.both(packRays(batch.rays), out);
      batch.rays.forEach((ray, i) => {
        const { origin: E, direction: d } = ray;
        const verdict = solveExactly(q, E[0], E[1], E[2], d[0], d[1], d[2], whole);
        expect([out.t0[i], out.t1[i]]).toEqual([whole.t0, whole.t1]);
        const quick = roundedRoots(q, ray, slot);
        if (quick === UNKNOWN) return;
        const told = (v: number, { t0, t1 }: RootSlot) => [VERDICTS[v], t0, t1];
        expect(told(quick, slot)).toEqual(told(verdict, whole));
      });
    }
  },
);
