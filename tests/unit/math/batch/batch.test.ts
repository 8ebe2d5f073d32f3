import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { accelerate, decelerate } from '../../../../src/math/accelerate.ts';
import {
  createAnswers,
  packRays,
  verdictsOfClasses,
  verdictsOfRoots,
} from '../../../../src/math/batch/batch.ts';
import { batchOf } from '../../../../src/math/batch/kernels.ts';
import type { Target } from '../../../../src/math/batch/target.ts';
import { FAMILIES } from '../../../../src/math/families.ts';
import type { Method } from '../../../../src/math/methods/define.ts';
import { METHODS } from '../../../../src/math/methods/index.ts';
import { stableByTrees } from '../../../../src/math/methods/stable.ts';
import { textbookByTrees } from '../../../../src/math/methods/textbook.ts';
import type { Ray } from '../../../../src/math/ray.ts';
import { integer, pick, seeded, wide } from '../../../../src/math/rng.ts';
import type { Shape } from '../../../../src/math/shapes/index.ts';
import { rayCases } from '../read-vectors.ts';

interface Question {
  readonly id: string;
  readonly shape: Shape;
  readonly rays: readonly Ray[];
}

const vectors: Question[] = rayCases.map(({ id, shape, ray }) => ({ id, shape, rays: [ray] }));

const families: Question[] = FAMILIES().flatMap((family) => {
  const random = seeded(11);
  return [0, 1, 2].map((k) => ({ id: `${family.id} ${k}`, ...family.batch(random, 20) }));
});

/** Small whole numbers meet every case distinction. */
function grid(seed: number, count: number): Question[] {
  const random = seeded(seed);
  const whole = () => integer(random, -3, 3);
  return Array.from({ length: count }, (_, k) => ({
    id: `grid ${k}`,
    shape: anyShape(whole, () => integer(random, 0, 3), random),
    rays: Array.from({ length: 8 }, () => rayOf(whole)),
  }));
}

function anyShape(any: () => number, size: () => number, random: () => number): Shape {
  const at = (): [number, number, number] => [any(), any(), any()];
  const normal = (): [number, number, number] => {
    const v = at();
    return v.every((x) => x === 0) ? [0, 1, 0] : v;
  };
  return pick<() => Shape>(random, [
    () => ({ kind: 'cylinder', center: at(), radius: size() }),
    () => ({ kind: 'cone', vertex: at(), slope: any() }),
    () => ({ kind: 'hyperboloid', center: at(), flare: any(), radius: size() }),
    () => ({ kind: 'plane', normal: normal(), point: at() }),
    () => ({ kind: 'circle', normal: normal(), center: at(), radius: size() }),
    () => ({ kind: 'square', corner: at(), side: size(), axis: pick(random, ['x', 'y', 'z']) }),
  ])();
}

function rayOf(any: () => number): Ray {
  const direction: [number, number, number] = [any(), any(), any()];
  if (direction.every((x) => x === 0)) direction[2] = 1;
  return { origin: [any(), any(), any()], direction };
}

/** Any exponent at all, and zeros. */
function anywhere(seed: number, count: number): Question[] {
  const random = seeded(seed);
  const some = () => (random() < 0.15 ? 0 : wide(random));
  return Array.from({ length: count }, (_, k) => ({
    id: `anywhere ${k}`,
    shape: anyShape(some, () => Math.abs(some()), random),
    rays: Array.from({ length: 4 }, () => rayOf(some)),
  }));
}

const questions = [...vectors, ...families, ...grid(1, 300), ...anywhere(2, 300)];

function byObject(method: Method, { shape, rays }: Question) {
  return rays.map((ray) => {
    const { class: verdict, hits } = method.intersect(shape, ray);
    return [verdict, ...hits.map(({ t }) => t)];
  });
}

function byBatch(method: Method, { shape, rays }: Question, target: Target) {
  const kernel = batchOf(method, shape, target);
  const packed = packRays(rays);
  const out = createAnswers(rays.length);
  kernel.classes(packed, out);
  const classes = verdictsOfClasses(out, rays.length, kernel.met);
  kernel.both(packed, out);
  const roots = verdictsOfRoots(out, rays.length).map((verdict, i) => [
    verdict,
    ...[out.t0[i] as number, out.t1[i] as number].filter((t) => !Number.isNaN(t)),
  ]);
  return { classes, roots };
}

const TARGETS = ['typescript', 'simd'] as const;

describe.each(METHODS.flatMap((m) => TARGETS.map((target) => [m.id, target, m] as const)))(
  'the batch of %s in %s',
  (_, target, method) => {
    beforeAll(() => {
      expect(accelerate()).toBe(true);
    });
    afterAll(decelerate);

    test(`is bit-equal to its method on ${questions.length} shapes`, () => {
      for (const question of questions) {
        const expected = byObject(method, question);
        const { classes, roots } = byBatch(method, question, target);
        expect([question.id, roots]).toEqual([question.id, expected]);
        expect([question.id, classes]).toEqual([question.id, expected.map(([verdict]) => verdict)]);
      }
    });

    test('first is the smallest root in the interval, and t1 no number', () => {
      for (const { id, shape, rays } of families) {
        const kernel = batchOf(method, shape, target);
        const packed = packRays(rays);
        const out = createAnswers(rays.length);
        for (const array of [out.t0, out.t1]) array.fill(77);
        kernel.first(packed, 0.25, 4, out);
        const firsts = rays.map((ray) => {
          const ts = method.intersect(shape, ray).hits.map(({ t }) => t);
          return ts.find((t) => t >= 0.25 && t <= 4) ?? Number.NaN;
        });
        expect([id, [...out.t0]]).toEqual([id, firsts]);
        expect([id, ...out.t1]).toEqual([id, ...rays.map(() => Number.NaN)]);
        const listed = Array.from(out.rareIndex.subarray(0, out.rareCount)).sort((i, j) => i - j);
        const untold = rays.flatMap((ray, i) =>
          /contained|undecided/.test(method.intersect(shape, ray).class) ? [i] : [],
        );
        expect([id, ...listed]).toEqual([id, ...untold]);
      }
    });
  },
);

describe.each([
  ['textbook', textbookByTrees],
  ['stable', stableByTrees],
] as const)('%s without its trees', (id, walked) => {
  test('is bit-equal to them in everything that it answers', () => {
    const fast = METHODS.find((m) => m.id === id) as Method;
    for (const question of questions) {
      for (const ray of question.rays) {
        const expected = walked.intersect(question.shape, ray);
        expect([question.id, fast.intersect(question.shape, ray)]).toEqual([question.id, expected]);
      }
    }
  });
});
