import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { accelerate, decelerate } from '../../../../src/math/accelerate.ts';
import { type Answers, type Rays, verdictsOfClasses } from '../../../../src/math/batch/batch.ts';
import { STRAIGHT as GENERATED } from '../../../../src/math/batch/generated/index.ts';
import { batchOf, targetOf } from '../../../../src/math/batch/kernels.ts';
import type { Target } from '../../../../src/math/batch/target.ts';
import { FAMILIES } from '../../../../src/math/families.ts';
import type { Method } from '../../../../src/math/methods/define.ts';
import { METHODS } from '../../../../src/math/methods/index.ts';
import type { Ray } from '../../../../src/math/ray.ts';
import { integer, pick, seeded } from '../../../../src/math/rng.ts';
import type { Shape } from '../../../../src/math/shapes/index.ts';
import { arraysIn, BESIDE, blank, difference, found, packed, type Where } from '../both-ways.ts';

/*
 * The kernels made of trees in WebAssembly: the bits and the list of those in TypeScript, whatever
 * is asked, wherever the arrays are, and nothing is written beyond the rays.
 */

const STRAIGHT = METHODS.filter(({ id }) => Object.hasOwn(GENERATED, id));
const FORMS = ['both', 'classes', 'first'] as const;
const WHERE: readonly [Where, Where] = ['memory', 'ordinary'];

type Form = (typeof FORMS)[number];

/** Every sixth element on, a few of them, of arrays that are longer. */
const partOf = <T extends Rays | Answers>(all: T, from: number, to: number): T =>
  Object.fromEntries(
    Object.entries(all).map(([name, x]) => [
      name,
      typeof x === 'number' || name.startsWith('rare') ? x : x.subarray(from, to),
    ]),
  ) as unknown as T;

function ask(method: Method, shape: Shape, target: Target, form: Form, rays: Rays, out: Answers) {
  const kernel = batchOf(method, shape, target);
  if (form === 'first') kernel.first(rays, 0.25, 4, out);
  else kernel[form](rays, out);
  return kernel.met;
}

describe.each(STRAIGHT.map((method) => [method.id, method] as const))('%s', (_, method) => {
  beforeAll(() => {
    accelerate();
  });
  afterAll(decelerate);

  test.each(FORMS)('%s, any number of rays, in arrays anywhere (seed 251)', (form) => {
    const random = seeded(251);
    for (const family of FAMILIES()) {
      for (const count of [integer(random, 1, 5), integer(random, 6, 40)]) {
        const { shape, rays: list } = family.batch(random, count);
        const [given, made] = [pick(random, WHERE), pick(random, WHERE)];
        const from = integer(random, 0, 3);
        const answers = (['typescript', 'simd'] as const).map((target) => {
          const rays = arraysIn(given, () => packed(list, count + 7));
          const out = arraysIn(made, () => blank(count + 7));
          const part = partOf(rays, from, count + 7);
          part.count = count - Math.min(from, count - 1);
          const kept = partOf(out, from, count + 7);
          accelerate();
          const met = ask(method, shape, target, form, part, kept);
          for (const array of [out.t0, out.t1, out.margin]) {
            expect([array[from - 1] ?? BESIDE, array[from + part.count]]).toEqual([BESIDE, BESIDE]);
          }
          return { ...found(kept), verdicts: verdictsOfClasses(kept, part.count, met) };
        });
        const [want, got] = answers as [(typeof answers)[number], (typeof answers)[number]];
        const told = JSON.stringify({ shape, given, made, from, count });
        expect([told, got.rare]).toEqual([told, want.rare]);
        if (form === 'classes') expect([told, got.verdicts]).toEqual([told, want.verdicts]);
        else expect([told, difference(want.t0, got.t0)]).toEqual([told, null]);
        if (form !== 'classes') expect([told, difference(want.t1, got.t1)]).toEqual([told, null]);
      }
    }
  });

  test.each(FORMS)('%s, more rays than one call takes (seed 252)', (form) => {
    const family = FAMILIES().find(({ id }) => id === 'exact-tangent') as ReturnType<
      typeof FAMILIES
    >[number];
    const { shape, rays: some } = family.batch(seeded(252), 350);
    const list = Array.from({ length: 2 ** 14 + 5 }, (_, i) => some[i % some.length] as Ray);
    const [want, got] = (['typescript', 'simd'] as const).map((target) => {
      const out = arraysIn('memory', () => blank(list.length));
      const rays = arraysIn('memory', () => packed(list, list.length));
      accelerate();
      ask(method, shape, target, form, rays, out);
      return found(out);
    });
    expect(got?.rare).toEqual(want?.rare);
    if (form === 'classes' || !want || !got) return;
    expect([difference(want.t0, got.t0), difference(want.t1, got.t1)]).toEqual([null, null]);
  });

  test('there is SIMD for every shape that its numbers fit', () => {
    const shape: Shape = { kind: 'square', corner: [0, 1, 2], side: 2, axis: 'z' };
    expect(targetOf(method, shape)).toBe('simd');
  });
});
