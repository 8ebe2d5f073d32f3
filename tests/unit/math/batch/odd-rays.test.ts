import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { accelerate, decelerate } from '../../../../src/math/accelerate.ts';
import { createAnswers, packRays, type Rays } from '../../../../src/math/batch/batch.ts';
import { batchOf } from '../../../../src/math/batch/kernels.ts';
import { InvalidInput, SHAPES } from '../../../../src/math/index.ts';
import { certified } from '../../../../src/math/methods/certified.ts';
import { exact } from '../../../../src/math/methods/exact.ts';
import { integer, seeded, uniform } from '../../../../src/math/rng.ts';
import { initialShape } from '../../../../src/state/state.ts';

/*
 * One ray of a batch that is none, at any place and in any number: said with its index, and no
 * answer is left standing.
 */

const COUNT = 37;
const PARTS = ['Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz'] as const;
const ODD = [Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY] as const;
const FORMS = ['both', 'classes', 'first'] as const;

const random = seeded(241);

function someRays(): Rays {
  const at = () => uniform(random, -4, 4);
  return packRays(
    Array.from({ length: COUNT }, () => ({
      origin: [at(), at(), at()] as const,
      direction: [at(), at(), at()] as const,
    })),
  );
}

const answers = ({ t0, t1, margin }: ReturnType<typeof createAnswers>): number[] => [
  ...t0,
  ...t1,
  ...margin,
];

describe.each([
  ['certified by WebAssembly', certified, true],
  ['certified', certified, false],
  ['exact', exact, false],
] as const)('%s', (_, method, fast) => {
  beforeAll(() => {
    expect(fast ? accelerate() : true).toBe(true);
  });
  afterAll(decelerate);

  describe.each(SHAPES)('$kind', ({ kind }) => {
    const kernel = batchOf(method, initialShape(kind));
    const ask = (rays: Rays, form: (typeof FORMS)[number], out = createAnswers(COUNT)) => {
      if (form === 'first') kernel.first(rays, 0, Number.POSITIVE_INFINITY, out);
      else kernel[form](rays, out);
      return out;
    };
    const refused = (rays: Rays, form: (typeof FORMS)[number], message: string): void => {
      const out = createAnswers(COUNT);
      out.rareCount = 3;
      expect(() => ask(rays, form, out)).toThrow(new InvalidInput(message));
      expect(answers(out).every(Number.isNaN)).toBe(true);
      expect(out.rareCount).toBe(0);
    };
    const unseen = (part: string): boolean => kind === 'cylinder' && part.endsWith('y');

    test.each(PARTS.flatMap((part) => ODD.map((x) => [part, x] as const)))('%s = %d', (part, x) => {
      for (const form of FORMS) {
        const i = integer(random, 0, COUNT - 1);
        const rays = someRays();
        const before = ask(rays, form);
        rays[part][i] = x;
        if (unseen(part)) expect(answers(ask(rays, form))).toEqual(answers(before));
        else refused(rays, form, `ray ${i}: ${part} must be a finite number, got ${x}`);
      }
    });

    test('no direction', () => {
      for (const form of FORMS) {
        const i = integer(random, 0, COUNT - 1);
        const rays = someRays();
        for (const part of ['dx', 'dy', 'dz'] as const) rays[part][i] = 0;
        refused(rays, form, `ray ${i}: direction must not be zero, got (0, 0, 0)`);
      }
    });
  });
});
