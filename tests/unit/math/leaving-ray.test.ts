import { describe, expect, test } from 'vitest';
import { FAMILIES, findFamily } from '../../../src/math/families.ts';
import { intersect } from '../../../src/math/intersect.ts';
import type { Hit, Sign } from '../../../src/math/intersection.ts';
import { withoutStart } from '../../../src/math/leaving-ray.ts';
import { METHODS } from '../../../src/math/methods/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { seeded, uniform } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';

const cylinder: Shape = { kind: 'cylinder', center: [0, 0, 0], radius: 1 };
const from = (ray: Ray, method: string, shape: Shape = cylinder) =>
  intersect(shape, ray, method, { from: shape });

describe.each(METHODS.map(({ id }) => id))('a ray that leaves a surface, by %s', (method) => {
  test('drops the root where it starts, and keeps the class of the line', () => {
    const inwards = from({ origin: [1, 0, 0], direction: [-1, 0, 0] }, method);
    expect(inwards.class).toBe('two');
    expect(inwards.hits.map(({ t }) => t)).toEqual([2]);
    expect(Math.abs(inwards.dropped?.t ?? Number.NaN)).toBe(0);
    const outwards = from({ origin: [1, 0, 0], direction: [1, 0, 0] }, method);
    expect(outwards.hits.map(({ t }) => t)).toEqual([-2]);
  });

  test('two equally near roots: the positive one', () => {
    const found = from({ origin: [0, 0, 0], direction: [1, 0, 0] }, method);
    expect([found.hits.map(({ t }) => t), found.dropped?.t]).toEqual([[-1], 1]);
  });

  test('another shape is another surface, equal numbers are the same one', () => {
    const ray: Ray = { origin: [1, 0, 0], direction: [-1, 0, 0] };
    const other: Shape = { ...cylinder, center: [0, 0, 0.25] };
    expect(intersect(cylinder, ray, method, { from: other }).hits).toHaveLength(2);
    expect(intersect(cylinder, ray, method, { from: structuredClone(cylinder) }).hits).toHaveLength(
      1,
    );
    expect(intersect(cylinder, ray, method, {}).hits).toHaveLength(2);
  });
});

test('a tangent, a plane and a miss', () => {
  const grazing: Ray = { origin: [0, 0, 1], direction: [1, 0, 0] };
  expect(from(grazing, 'exact')).toMatchObject({ class: 'tangent', hits: [], dropped: { t: 0 } });
  const plane: Shape = { kind: 'plane', normal: [0, 1, 0], point: [0, 2, 0] };
  const up: Ray = { origin: [0, 2, 0], direction: [0, 1, 0] };
  expect(from(up, 'certified', plane)).toMatchObject({ class: 'one', hits: [] });
  const miss = from({ origin: [0, 0, 5], direction: [1, 0, 0] }, 'certified');
  expect([miss.class, miss.hits, miss.dropped]).toEqual(['none', [], undefined]);
});

test('which of two roots is nearer is decided exactly, though both round to the same size', () => {
  // E is 2^-60 off the axis: t = −1 ∓ …, 1 ∓ … with t1 + t2 = ∓2^-59, far below an ulp of 1.
  const off = (x: number): Ray => ({ origin: [x, 0, 0], direction: [1, 0, 0] });
  for (const method of ['certified', 'exact']) {
    expect(from(off(2 ** -60), method).dropped?.t).toBe(1);
    expect(from(off(-(2 ** -60)), method).dropped?.t).toBe(-1);
    expect(from(off(2 ** -200), method).dropped?.t).toBe(1);
    expect(from(off(-(2 ** -200)), method).dropped?.t).toBe(-1);
  }
});

test('faithful roots that are one neighbour off on either side do not mislead', () => {
  // Exactly −(1 + 0.4 · 2^-52) and 1 + 0.6 · 2^-52: the first one is nearer, though its faithful
  // double may be the larger one.
  const hit = (t: number): Hit => ({ t, point: [t, 0, 0], normal: [t, 0, 0], singular: false });
  const signs = { A: 1, B: -1, C: -1, D: 1 } as const;
  const told = (near: number, far: number, B: Sign) =>
    withoutStart(
      {
        class: 'two',
        hits: [hit(near), hit(far)],
        method: 'certified',
        decidedBy: 'filter',
        details: { family: 'curved', A: 1, B: 0, C: -1, D: 4, signs: { ...signs, B } },
      },
      cylinder,
      cylinder,
    ).dropped?.t;
  const up = 1 + 2 ** -52;
  expect(told(-up, 1, -1)).toBe(-up);
  expect(told(-1, up, 1)).toBe(up);
  // Two and three steps of the subnormals.
  expect(told(-3 * Number.MIN_VALUE, 2 * Number.MIN_VALUE, -1)).toBe(-3 * Number.MIN_VALUE);
  // Beyond that the sizes alone tell, whatever is said of A and B.
  expect(told(-1 - 2 ** -48, 1, -1)).toBe(1);
});

/** What goes wrong without it, and that it does not with it (2000 outward rays, seed 5). */
test('a ray from a hit point outwards meets its own surface only without `from`', () => {
  const random = seeded(5);
  const family = findFamily('typical') ?? FAMILIES()[0];
  let again = 0;
  let tried = 0;
  while (tried < 2000) {
    const question = family?.make(random);
    if (question?.shape.kind !== 'cylinder') continue;
    const { shape, ray } = question;
    const [hit] = intersect(shape, ray, 'exact').hits;
    if (!hit) continue;
    tried += 1;
    const [nx, , nz] = hit.normal;
    const leaving: Ray = { origin: hit.point, direction: [nx, uniform(random, -1, 1), nz] };
    if (intersect(shape, leaving, 'certified').hits.some(({ t }) => t > 0)) again += 1;
    expect(from(leaving, 'certified', shape).hits.filter(({ t }) => t > 0)).toEqual([]);
  }
  expect(again / tried).toBeGreaterThan(0.3);
});
