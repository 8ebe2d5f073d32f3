import { describe, expect, test } from 'vitest';
import {
  createAnswers,
  createRays,
  packRays,
  verdictsOfClasses,
  verdictsOfRoots,
} from '../../../src/math/batch/batch.ts';
import { batchOf } from '../../../src/math/batch/kernels.ts';
import { FAMILIES, type Question } from '../../../src/math/families.ts';
import type { Method } from '../../../src/math/methods/define.ts';
import { METHODS } from '../../../src/math/methods/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { seeded } from '../../../src/math/rng.ts';
import { SHAPES, type Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { many } from '../many.ts';
import { rayCases } from './read-vectors.ts';
import { wild } from './wild.ts';

/*
 * The batch kernels of the methods that are made of trees: class and roots bit-equal to those, ray
 * by ray.
 */

const BATCH_METHODS = METHODS.filter(({ parts }) => parts);

interface Answer {
  readonly class: string;
  readonly roots: readonly number[];
}

const tree = (method: Method, { shape, ray }: Question): Answer => {
  const found = method.intersect(shape, ray);
  return { class: found.class, roots: found.hits.map(({ t }) => t) };
};

/** By `both` and by `classes`, which must agree. */
function kernel(method: Method, shape: Shape, list: readonly Ray[]): Answer[] {
  const rays = packRays(list);
  const out = createAnswers(list.length);
  const asked = batchOf(method, shape);
  asked.classes(rays, out);
  const classes = verdictsOfClasses(out, rays.count, asked.met);
  asked.both(rays, out);
  const verdicts = verdictsOfRoots(out, rays.count);
  return verdicts.map((verdict, i) => {
    const roots = [out.t0[i] as number, out.t1[i] as number].filter((t) => !Number.isNaN(t));
    return { class: verdict === classes[i] ? verdict : `${verdict} but ${classes[i]}`, roots };
  });
}

const differing = (method: Method, shape: Shape, rays: readonly Ray[]): unknown[] =>
  kernel(method, shape, rays).flatMap((got, i) => {
    const ray = rays[i] as Ray;
    const want = tree(method, { shape, ray });
    const same =
      got.class === want.class &&
      got.roots.length === want.roots.length &&
      got.roots.every((t, k) => Object.is(t, want.roots[k]));
    return same ? [] : [{ shape, ray, got, want }];
  });

describe.each(BATCH_METHODS)('$id: bit-equal to its tree', (method) => {
  test.each(FAMILIES().map(({ id, batch }) => [id, batch] as const))('family %s', (_, batch) => {
    const random = seeded(121);
    for (let i = 0; i < many(16); i++) {
      const { shape, rays } = batch(random, 12);
      expect(differing(method, shape, rays)).toEqual([]);
    }
  });

  test('vectors', () => {
    const found = rayCases.flatMap(({ shape, ray }) => differing(method, shape, [ray]));
    expect(found).toEqual([]);
  });

  test('every exponent (seed 122)', () => {
    const found = wild(122, many(5000)).flatMap(({ shape, ray }) =>
      differing(method, shape, [ray]),
    );
    expect(found.slice(0, 2)).toEqual([]);
  });

  test('outside of a figure there is a distance, and it is no less than 0 (seed 125)', () => {
    const planes = wild(125, 500 * SHAPES.length).map(
      ({ shape, ray }) => method.intersect(shape, ray).details,
    );
    const outside = planes.flatMap((d) => (d.family === 'flat' && d.plane ? [d.plane] : []));
    expect(outside.filter(({ inside }) => inside === false).length).toBeGreaterThan(20);
    expect(outside.filter(({ distance }) => !(distance >= 0))).toEqual([]);
  });

  test('two roots that underflow to zeros of both signs', () => {
    const shape: Shape = { kind: 'hyperboloid', center: [0, 0, 0], flare: 1, radius: 0 };
    const ray: Ray = { origin: [0, -1e-180, 0], direction: [1e150, 2e150, 0] };
    expect(differing(method, shape, [ray])).toEqual([]);
  });

  test('small whole numbers', () => {
    const rays: Ray[] = [];
    for (let k = 0; k < 625; k++) {
      const digit = (n: number): number => (Math.floor(k / 5 ** n) % 5) - 2;
      const direction: Vec3 = [digit(0), digit(1), digit(2)];
      if (direction.some((x) => x !== 0)) rays.push({ origin: [digit(3), 1, -1], direction });
    }
    const center: Vec3 = [0, 1, 0];
    const shapes: Shape[] = [
      { kind: 'cylinder', center, radius: 1 },
      { kind: 'cone', vertex: center, slope: 1 },
      { kind: 'cone', vertex: center, slope: 0 },
      { kind: 'hyperboloid', center, flare: 1, radius: 1 },
      { kind: 'hyperboloid', center, flare: 0, radius: 2 },
      { kind: 'hyperboloid', center, flare: -1, radius: 1 },
      { kind: 'plane', normal: [1, 1, 0], point: center },
      { kind: 'circle', normal: [1, 2, 2], center, radius: 1 },
      { kind: 'square', corner: center, side: 1, axis: 'y' },
    ];
    for (const shape of shapes) expect(differing(method, shape, rays)).toEqual([]);
  });

  test('first: the least root in the window, of those that both gives', () => {
    const { shape, rays: list } = (FAMILIES()[0] as ReturnType<typeof FAMILIES>[number]).batch(
      seeded(123),
      200,
    );
    const rays = packRays(list);
    const out = createAnswers(200);
    const asked = batchOf(method, shape);
    for (const [tMin, tMax] of [
      [0, Infinity],
      [0.2, 0.9],
      [-Infinity, 0],
    ] as const) {
      asked?.first(rays, tMin, tMax, out);
      const want = list.map((ray) => {
        const { roots } = tree(method, { shape, ray });
        return roots.find((t) => t >= tMin && t <= tMax) ?? Number.NaN;
      });
      expect([...out.t0]).toEqual(want);
    }
  });

  test('no rays, and arrays that are longer than the count', () => {
    const { shape } = (FAMILIES()[0] as ReturnType<typeof FAMILIES>[number]).make(seeded(124));
    const out = createAnswers(4);
    out.t0.fill(7);
    batchOf(method, shape).both(createRays(4), out);
    expect([...out.t0, out.rareCount]).toEqual([7, 7, 7, 7, 0]);
  });
});
