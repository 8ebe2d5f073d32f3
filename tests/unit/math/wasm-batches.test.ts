import { describe, expect, test } from 'vitest';
import { accelerate, decelerate } from '../../../src/math/accelerate.ts';
import { batchOf } from '../../../src/math/batch/kernels.ts';
import { quadricOf } from '../../../src/math/batch/quadric.ts';
import { FAMILIES, type Family } from '../../../src/math/families.ts';
import { certifiedQuadric, latticeOf } from '../../../src/math/methods/certified/numbers.ts';
import { certified } from '../../../src/math/methods/certified.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { seeded } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import {
  type Ask,
  arraysIn,
  ask,
  blank,
  difference,
  found,
  packed,
  type Where,
} from './both-ways.ts';
import { wild } from './wild.ts';

/*
 * Certified's batches by WebAssembly: the same bits and the same verdicts as by the stages in
 * TypeScript, whatever is asked and wherever the arrays are.
 */

const CURVED = FAMILIES().filter(({ make }) => quadricOf(make(seeded(1)).shape) !== null);
const isCurved = (shape: Shape): boolean => quadricOf(shape) !== null;

interface Places {
  readonly rays?: Where;
  readonly out?: Where;
  /** Elements of the arrays beyond the rays. */
  readonly spare?: number;
  readonly form?: Ask;
}

/** What differs, in words; null if nothing does. */
function differs(shape: Shape, list: readonly Ray[], places: Places = {}): string | null {
  const { rays = 'memory', out = 'memory', spare = 0, form = 'both' } = places;
  const capacity = list.length + spare;
  const plainRays = arraysIn('ordinary', () => packed(list, capacity));
  const plain = arraysIn('ordinary', () => blank(capacity));
  ask(false, form, shape, plainRays, plain);
  const fastRays = arraysIn(rays, () => packed(list, capacity));
  const fast = arraysIn(out, () => blank(capacity));
  ask(true, form, shape, fastRays, fast);
  const [want, got] = [found(plain), found(fast)];
  const wrong =
    difference(want.t0, got.t0) ??
    difference(want.t1, got.t1) ??
    (form === 'classes' ? difference(plain.margin, fast.margin) : null) ??
    (want.rare.join() === got.rare.join() ? null : `${want.rare} and ${got.rare} are listed`) ??
    (['Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz'] as const)
      .map((name) => difference(plainRays[name], fastRays[name]))
      .find((d) => d !== null);
  return wrong ? `${JSON.stringify(shape)}, ${list.length} rays: ${wrong}` : null;
}

/**
 * One batch for several shapes' rays would not do: each shape is asked about all rays of the same
 * draw.
 */
function wildBatches(seed: number, shapes: number, count: number): [Shape, Ray[]][] {
  const drawn = wild(seed, 2 * shapes);
  const rays = wild(seed + 1, count).map(({ ray }) => ray);
  return drawn
    .map(({ shape }) => shape)
    .filter(isCurved)
    .map((shape) => [shape, rays]);
}

test('there is WebAssembly where the tests run', () => {
  expect(accelerate()).toBe(true);
  decelerate();
});

describe.each(CURVED.map((family): [string, Family] => [family.id, family]))(
  'family %s (seed 141)',
  (_, family) => {
    test('both, first and classes', () => {
      const random = seeded(141);
      for (let k = 0; k < 6; k++) {
        const { shape, rays } = family.batch(random, k % 2 ? 65 : 400);
        for (const form of ['both', 'first', 'classes'] as const) {
          expect(differs(shape, rays, { form })).toBeNull();
        }
      }
    });
  },
);

describe('sizes and places (seed 142)', () => {
  const SIZES = [1, 2, 15, 16, 17, 31, 127, 128, 129, 255, 256, 257, 1023, 1024, 1025, 1026, 3000];
  const ids = ['typical', 'mix', 'near-tangent', 'far-origin'];
  const random = seeded(142);
  const batches = ids.map((id) =>
    (CURVED.find((family) => family.id === id) as Family).batch(random, 3001),
  );

  test.each([...SIZES, 3001])('%i rays', (n) => {
    for (const { shape, rays } of batches) {
      expect(differs(shape, rays.slice(0, n))).toBeNull();
      expect(differs(shape, rays.slice(-n))).toBeNull();
    }
  });

  test.each([4095, 4096, 4097, 8195])('%i rays, more than one call takes', (n) => {
    for (const { shape, rays } of batches) {
      expect(differs(shape, [...rays, ...rays, ...rays].slice(0, n))).toBeNull();
    }
  });

  const places: [Where, Where][] = [
    ['memory', 'ordinary'],
    ['ordinary', 'memory'],
    ['ordinary', 'ordinary'],
  ];
  test.each(places)('rays in %s, answers in %s arrays', (rays, out) => {
    for (const n of [16, 17, 129, 1024, 1025, 2500]) {
      for (const batch of batches) {
        expect(differs(batch.shape, batch.rays.slice(0, n), { rays, out })).toBeNull();
        expect(differs(batch.shape, batch.rays.slice(0, n), { rays, out, spare: 40 })).toBeNull();
      }
    }
  });

  test('arrays longer than the count: what is beyond stays as it was', () => {
    for (const n of [15, 16, 17, 18, 127, 128, 129, 1023, 1024, 1025, 2047]) {
      for (const { shape, rays } of batches) {
        for (const spare of [1, 2, 3, 50]) {
          expect(differs(shape, rays.slice(0, n), { spare })).toBeNull();
        }
      }
    }
  });

  test('some arrays in the memory, some not, some parts of longer ones', () => {
    const n = 1501;
    for (const { shape, rays: list } of batches) {
      const plain = arraysIn('ordinary', () => packed(list.slice(1, n + 1)));
      const want = arraysIn('ordinary', () => blank(n));
      ask(false, 'both', shape, plain, want);
      const inMemory = arraysIn('memory', () => packed(list.slice(0, n + 1)));
      const parts = { ...plain, Ex: inMemory.Ex.subarray(1), dz: inMemory.dz.subarray(1, n + 1) };
      const long = arraysIn('memory', () => blank(n + 1));
      const mixtures = [
        { ...long, t1: new Float64Array(n) },
        { ...long, t0: new Float64Array(n) },
        { ...long, t0: long.t0.subarray(1), t1: long.t1.subarray(1) },
      ];
      for (const out of mixtures) {
        long.t0.fill(-5);
        long.t1.fill(-5);
        ask(true, 'both', shape, parts, out);
        expect(difference(want.t0, out.t0.subarray(0, n))).toBeNull();
        expect(difference(want.t1, out.t1.subarray(0, n))).toBeNull();
        expect(found(out).rare).toEqual(found(want).rare);
      }
      expect([long.t0[0], long.t1[0]]).toEqual([-5, -5]);
    }
  });

  test('answers that follow each other in one array', () => {
    const n = 129;
    const { shape, rays: list } = batches[0] as (typeof batches)[number];
    const rays = arraysIn('memory', () => packed(list.slice(0, n)));
    const want = arraysIn('ordinary', () => blank(n));
    ask(false, 'both', shape, rays, want);
    const all = arraysIn('memory', () => blank(2 * n + 1));
    const out = { ...all, t0: all.t0.subarray(n, 2 * n), t1: all.t0.subarray(0, n) };
    for (const order of [out, { ...out, t0: out.t1, t1: out.t0 }]) {
      ask(true, 'both', shape, rays, order);
      expect(difference(want.t0, order.t0)).toBeNull();
      expect(difference(want.t1, order.t1)).toBeNull();
    }
  });

  test('nothing else in the memory is written to', () => {
    const random = seeded(143);
    const { shape, rays: list } = (CURVED[0] as Family).batch(random, 1027);
    const neighbours = arraysIn('memory', () => [
      blank(64).t0,
      ...[packed(list)].flatMap(({ Ex, dz }) => [Ex, dz]),
      blank(3).t1,
    ]);
    const before = neighbours.map((array) => array.slice());
    const rays = arraysIn('memory', () => packed(list));
    const out = arraysIn('memory', () => blank(list.length));
    const after = arraysIn('memory', () => blank(64).t0);
    const margin = out.margin.slice();
    ask(true, 'both', shape, rays, out);
    neighbours.forEach((array, k) => {
      expect(difference(array, before[k] as Float64Array)).toBeNull();
    });
    expect(after.every((x) => x === 77.5)).toBe(true);
    expect(out.margin.length).toBe(margin.length);
  });
});

describe('shapes and rays of every exponent (seed 144)', () => {
  const batches = wildBatches(144, 60, 90);

  test('they include shapes without a lattice, and shapes outside of the box', () => {
    const quadrics = batches.map(([shape]) => quadricOf(shape)).filter((q) => q !== null);
    expect(quadrics.filter((q) => latticeOf(q) === null).length).toBeGreaterThan(10);
    expect(quadrics.filter((q) => latticeOf(q) !== null).length).toBeGreaterThan(2);
    const boxed = quadrics.filter((q) => certifiedQuadric(q).inBox);
    expect(boxed.length).toBeGreaterThan(5);
    expect(boxed.length).toBeLessThan(quadrics.length);
    expect(boxed.filter((q) => latticeOf(q) === null).length).toBeGreaterThan(2);
  });

  test('the same bits', () => {
    for (const [shape, rays] of batches) {
      expect(differs(shape, rays)).toBeNull();
      expect(differs(shape, rays, { form: 'first' })).toBeNull();
    }
  });

  test('ordinary shapes and rays of every exponent', () => {
    const shapes: Shape[] = [
      { kind: 'cylinder', center: [1, 2, 3], radius: 1 },
      { kind: 'cone', vertex: [1, 2, 3], slope: 0.5 },
      { kind: 'hyperboloid', center: [1, -2, 3], flare: -1.3, radius: 2 },
      { kind: 'hyperboloid', center: [0, 0, 0], flare: 0, radius: 0 },
      { kind: 'cylinder', center: [2 ** 90, 0, -(2 ** 70)], radius: 2 ** 80 },
    ];
    const rays = wild(146, 900).map(({ ray }) => ray);
    for (const shape of shapes) expect(differs(shape, rays)).toBeNull();
  });
});

test('all miss, all hit, and a shape met twice by all but the last (seed 145)', () => {
  const shape: Shape = { kind: 'cylinder', center: [0.25, 0, 0.5], radius: 1 };
  const random = seeded(145);
  const hit = (): Ray => ({
    origin: [-3 - random(), random(), 0.5],
    direction: [1, random(), 0.1 * random()],
  });
  const miss = (): Ray => ({ origin: [3 + random(), random(), 0.5], direction: [0, random(), 1] });
  for (const n of [16, 17, 128, 129, 1024, 1025, 1300]) {
    const hits = Array.from({ length: n }, hit);
    const misses = Array.from({ length: n }, miss);
    for (const list of [hits, misses, [...hits.slice(1), miss()], [...misses.slice(1), hit()]]) {
      expect(differs(shape, list, { spare: 1 })).toBeNull();
    }
  }
});

test('two kernels in turn, each with its own shape', () => {
  accelerate();
  const [first, second] = ['typical', 'extreme-parameter'].map((id, k) => {
    const { shape, rays } = (CURVED.find((f) => f.id === id) as Family).batch(seeded(147 + k), 77);
    const want = arraysIn('ordinary', () => blank(77));
    ask(
      false,
      'both',
      shape,
      arraysIn('ordinary', () => packed(rays)),
      want,
    );
    return { shape, want, rays: arraysIn('memory', () => packed(rays)) };
  }) as [Turn, Turn];
  interface Turn {
    readonly shape: Shape;
    readonly want: ReturnType<typeof blank>;
    readonly rays: ReturnType<typeof packed>;
  }
  accelerate();
  const kernels = [first, second].map(({ shape }) => batchOf(certified, shape));
  for (const k of [0, 1, 1, 0, 1, 0]) {
    const { want, rays } = [first, second][k] as Turn;
    accelerate();
    const out = blank(77);
    kernels[k]?.both(rays, out);
    decelerate();
    expect(difference(want.t0, out.t0)).toBeNull();
    expect(difference(want.t1, out.t1)).toBeNull();
  }
});
