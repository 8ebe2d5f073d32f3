import { describe, expect, test } from 'vitest';
import { createAnswers, packRays, verdictsOfRoots } from '../../../src/math/batch/batch.ts';
import { batchOf } from '../../../src/math/batch/kernels.ts';
import { FAMILIES } from '../../../src/math/families.ts';
import { METHODS } from '../../../src/math/methods/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { SHAPES, type Shape } from '../../../src/math/shapes/index.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';
import { drawJudged, type Judged, judged, medianBits, method, score, worst } from './measure.ts';
import { rayCases } from './read-vectors.ts';
import { wild } from './wild.ts';

/*
 * Every method held to its own promise, on the vectors and on seeded families. What the methods get
 * wrong by design is in ladder-facts.test.ts.
 */

const SEED = 71;
const COUNT = 60;
const drawn = new Map(FAMILIES().map(({ id }) => [id, drawJudged(id, COUNT, SEED)]));
const of = (id: string): Judged[] => drawn.get(id) as Judged[];

const vectors = new Map<string, Judged[]>();
for (const family of new Set(rayCases.map((c) => c.family))) {
  vectors.set(family, judged(rayCases.filter((c) => c.family === family)));
}

/** A hit at t = 2 exactly and a miss of the shape, in small numbers that float32 holds too. */
const PLAIN: readonly [shape: Shape, hit: Ray, miss: Ray][] = [
  [
    { kind: 'plane', normal: [0, 2, 0], point: [5, 1, 0] },
    { origin: [0, 3, 0], direction: [0.5, -1, 0] },
    { origin: [0, 3, 0], direction: [1, 0, 1] },
  ],
  [
    { kind: 'cylinder', center: [0, 9, 0], radius: 1 },
    { origin: [-3, 0, 0], direction: [1, 0.5, 0] },
    { origin: [-3, 0, 2], direction: [1, 0.5, 0] },
  ],
  [
    { kind: 'cone', vertex: [0, 0, 0], slope: 0.5 },
    { origin: [-3, 2, 0], direction: [1, 0, 0] },
    { origin: [-3, 2, 2], direction: [1, 0, 0] },
  ],
  [
    { kind: 'hyperboloid', center: [0, 0, 0], flare: 1, radius: 1 },
    { origin: [-3, 0, 0], direction: [1, 0, 0] },
    { origin: [-3, 0, 2], direction: [1, 0, 0] },
  ],
  [
    { kind: 'circle', normal: [0, 1, 0], center: [0, 0, 0], radius: 1 },
    { origin: [0, 2, 0], direction: [0.25, -1, 0] },
    { origin: [0, 2, 0], direction: [0.75, -1, 0] },
  ],
  [
    { kind: 'square', corner: [0, 0, 0], side: 1, axis: 'z' },
    { origin: [0.5, 0.5, 2], direction: [0.125, 0.25, -1] },
    { origin: [0.5, 0.5, 2], direction: [0.125, 0.5, -1] },
  ],
  [
    { kind: 'sphere', center: [0, 0, 0], radius: 1 },
    { origin: [-3, 0, 0], direction: [1, 0, 0] },
    { origin: [-3, 0, 2], direction: [1, 0, 0] },
  ],
  [
    { kind: 'paraboloid', vertex: [0, 0, 0], width: 1 },
    { origin: [-3, 1, 0], direction: [1, 0, 0] },
    { origin: [-3, -1, 0], direction: [1, 0, 0] },
  ],
];

describe.each(METHODS)('$id', (tested) => {
  test.each(PLAIN.map((one) => [one[0].kind, ...one] as const))(
    'meets a %s where it is, and misses it where it is not',
    (_, shape, hit, miss) => {
      const found = tested.intersect(shape, hit);
      expect(found.class).toBe(
        definitionOf(shape).formula(shape).family === 'flat' ? 'one' : 'two',
      );
      expect(found.hits[0]?.t).toBe(2);
      expect(found.hits[0]?.point).toEqual(
        hit.origin.map((x, i) => x + 2 * (hit.direction[i] ?? 0)),
      );
      expect(tested.intersect(shape, miss)).toMatchObject({
        class: 'none',
        hits: [],
        method: tested.id,
      });
    },
  );

  test('says what it is, what it promises and where it is from', () => {
    for (const text of [tested.idea, tested.promise, tested.source])
      expect(text, 'at least 32 characters, with a full stop').toMatch(/^\S.{30,}\.$/s);
  });

  test('never shows a number that is not one, and hits in order', () => {
    const wrong = [...drawn.values()].flat().filter(({ shape, ray }) => {
      const { class: verdict, hits } = tested.intersect(shape, ray);
      const ts = hits.map(({ t }) => t);
      const shown = hits.flatMap(({ t, point, normal }) => [t, ...point, ...normal]);
      const beyond = !tested.proven && !ts.every(Number.isFinite);
      const count = { two: 2, tangent: 1, one: 1 }[verdict as string] ?? 0;
      const inOrder = ts.length < 2 || (ts[0] as number) <= (ts[1] as number);
      return shown.some(Number.isNaN) || beyond || ts.length !== count || !inOrder;
    });
    expect(wrong).toEqual([]);
  });
});

/** Where each method's class is always right: its domain, in families and vectors alike. */
const RIGHT: Readonly<Record<string, readonly string[]>> = {
  textbook32: [
    'typical',
    'linear',
    'generator',
    'on-surface',
    'degenerate',
    'flat-degenerate',
    'plane',
    'plane-far',
    'circle',
    'square',
  ],
  textbook: [
    'typical',
    'exact-tangent',
    'near-axis',
    'linear',
    'generator',
    'on-surface',
    'near-surface',
    'cancellation',
    'linear-cancellation',
    'scale-ray',
    'degenerate',
    'flat-degenerate',
    'plane',
    'plane-far',
    'circle',
    'square',
  ],
  stable: [
    'typical',
    'exact-tangent',
    'near-axis',
    'linear',
    'generator',
    'on-surface',
    'near-surface',
    'cancellation',
    'linear-cancellation',
    'scale-ray',
    'degenerate',
    'flat-degenerate',
    'plane',
    'plane-far',
    'circle',
    'square',
  ],
  moment: [
    'typical',
    'far-origin',
    'exact-tangent',
    'near-axis',
    'linear',
    'generator',
    'on-surface',
    'near-surface',
    'cancellation',
    'linear-cancellation',
    'scale-ray',
    'degenerate',
    'flat-degenerate',
    'plane',
    'plane-far',
    'circle',
    'square',
  ],
  compensated: [
    'typical',
    'mix',
    'far-origin',
    'near-tangent',
    'near-tangent-far',
    'exact-tangent',
    'near-axis',
    'linear',
    'generator',
    'on-surface',
    'near-surface',
    'cancellation',
    'linear-cancellation',
    'degenerate',
    'flat-degenerate',
    'plane',
    'plane-far',
    'circle',
    'circle-rim',
    'square',
    'square-edge',
  ],
};

describe.each(Object.entries(RIGHT))('%s gives the right class on its domain', (id, families) => {
  test.each(families)('%s', (family) => {
    for (const questions of [of(family), vectors.get(family) ?? []]) {
      expect(score(id, questions)).toMatchObject({ wrong: 0, undecided: 0 });
    }
  });
});

describe('interval: whenever it decides, it is right', () => {
  test.each([...drawn])('family %s', (_, questions) => {
    expect(score('interval', questions).wrong).toBe(0);
  });
  test.each([...vectors])('vectors %s', (_, questions) => {
    expect(score('interval', questions).wrong).toBe(0);
  });
  const sweeps = FAMILIES().flatMap(({ id, dial }) =>
    dial
      ? Array.from(
          { length: 6 },
          (_, i) => [id, dial.range[0] + ((dial.range[1] - dial.range[0]) * i) / 5] as const,
        )
      : [],
  );
  test.each(sweeps)('%s at %d', (id, difficulty) => {
    expect(score('interval', drawJudged(id, 30, SEED + 1, difficulty)).wrong).toBe(0);
  });

  test('on every exponent: subnormals, overflow, zeros, ends (6000 rays, seed 131)', () => {
    const questions = wild(131, 6000);
    const out = createAnswers(1);
    const decided = new Map<string, number>();
    for (const { shape, ray } of questions) {
      const { class: verdict, hits } = method('interval').intersect(shape, ray);
      if (verdict === 'undecided') continue;
      batchOf(method('exact'), shape).both(packRays([ray]), out);
      const [truth] = verdictsOfRoots(out, 1);
      expect([JSON.stringify({ shape, ray }), verdict]).toEqual([
        JSON.stringify({ shape, ray }),
        truth,
      ]);
      expect(hits.every(({ t }) => Number.isFinite(t))).toBe(true);
      decided.set(shape.kind, (decided.get(shape.kind) ?? 0) + 1);
    }
    // It is not right by keeping silent, on any of the shapes.
    for (const { kind } of SHAPES) expect(decided.get(kind)).toBeGreaterThan(100);
  });

  /** Families that it decides completely: it is not right by keeping silent. */
  test.each([
    'typical',
    'mix',
    'far-origin',
    'exact-tangent',
    'near-axis',
    'linear',
    'generator',
    'on-surface',
    'near-surface',
    'cancellation',
    'linear-cancellation',
    'scale-ray',
    'degenerate',
    'flat-degenerate',
    'plane',
    'plane-far',
    'circle',
    'square',
  ])('and it decides all of %s', (id) => {
    expect(score('interval', of(id)).undecided).toBe(0);
  });
});

describe('digits', () => {
  test('textbook32: some seven on ordinary rays', () => {
    // A float32 has 29 bits less than a double; two more for what the formula loses.
    expect(medianBits(score('textbook32', of('typical')))).toBeLessThan(31);
  });

  test('textbook32 answers for the ray rounded to float32', () => {
    const { fround } = Math;
    const single = (x: unknown): unknown =>
      typeof x === 'number' ? fround(x) : Array.isArray(x) ? x.map(single) : x;
    const tested = method('textbook32');
    for (const { shape, ray } of [...of('typical'), ...of('circle'), ...of('square')]) {
      const near = Object.fromEntries(Object.entries(shape).map(([k, v]) => [k, single(v)]));
      const rounded = { origin: single(ray.origin), direction: single(ray.direction) };
      expect(tested.intersect(near as unknown as typeof shape, rounded as typeof ray)).toEqual(
        tested.intersect(shape, ray),
      );
    }
  });

  test('stable: the class, A, B, C and D of textbook to the last bit', () => {
    for (const { shape, ray } of [...drawn.values()].flat()) {
      const a = method('textbook').intersect(shape, ray);
      const b = method('stable').intersect(shape, ray);
      expect(b.details).toEqual(a.details);
      if (a.class !== 'undecided') expect(b.class).toBe(a.class);
    }
  });

  test('compensated: correctly rounded but for 1 ulp, where its range and A allow', () => {
    for (const id of [
      'typical',
      'far-origin',
      'near-tangent',
      'near-tangent-far',
      'near-axis',
      'cancellation',
      'linear-cancellation',
      'on-surface',
      'plane',
      'plane-far',
      'circle',
      'square',
    ]) {
      expect([id, worst(score('compensated', of(id))) <= 1]).toEqual([id, true]);
    }
  });
});
