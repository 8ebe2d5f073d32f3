import { describe, expect, test } from 'vitest';
import { FAMILIES } from '../../../src/math/families.ts';
import { nextDown, nextUp } from '../../../src/math/float/ulp.ts';
import { intersect } from '../../../src/math/intersect.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { integer, pick, type Random, seeded, uniform, wide } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { disagreement, misplaced } from './against-exact.ts';
import { rayCases, readAll } from './read-vectors.ts';

const stages = (questions: readonly { shape: Shape; ray: Ray }[]) => {
  const count = { formula: 0, filter: 0, 'double-double': 0, exact: 0 };
  for (const { shape, ray } of questions) {
    expect(disagreement(shape, ray)).toBeNull();
    count[intersect(shape, ray, 'certified').decidedBy] += 1;
  }
  return count;
};

test('keeps the promise on every vector: class, faithful roots, points and normals', () => {
  for (const c of rayCases) {
    const found = intersect(c.shape, c.ray, 'certified');
    expect([c.id, found.class]).toEqual([c.id, c.expect.class]);
    expect(found.hits).toHaveLength(c.expect.faithful.length);
    found.hits.forEach(({ t, singular }, k) => {
      const around = readAll(c.expect.faithful[k] ?? []);
      expect([c.id, t, around.includes(t)]).toEqual([c.id, t, true]);
      expect([c.id, singular]).toEqual([c.id, c.expect.singular[k]]);
    });
    expect([c.id, misplaced(c)]).toEqual([c.id, []]);
  }
});

describe('agrees with exact on', () => {
  test.each(FAMILIES().map((family) => [family.id, family] as const))(
    '%s (seed 21)',
    (_, family) => {
      const random = seeded(21);
      const questions = Array.from({ length: 150 }, () => family.make(random));
      stages(questions);
      expect(questions.flatMap((question) => misplaced(question))).toEqual([]);
    },
  );

  test('small whole numbers, which meet every degenerate class (seed 22)', () => {
    const random = seeded(22);
    const whole = () => integer(random, -3, 3);
    const met = new Set<string>();
    for (let k = 0; k < 6000; k++) {
      const shape = anyShape(random, whole, () => Math.abs(whole()));
      const ray = {
        origin: anyRay(whole).origin,
        direction: anyRay(() => integer(random, -1, 1)).direction,
      };
      expect(disagreement(shape, ray)).toBeNull();
      met.add(`${shape.kind} ${intersect(shape, ray, 'certified').class}`);
    }
    const of = (kind: string) =>
      [...met]
        .filter((m) => m.startsWith(kind))
        .map((m) => m.slice(kind.length + 1))
        .sort();
    expect(of('cylinder')).toEqual(['contained', 'none', 'tangent', 'two']);
    expect(of('cone')).toEqual(['contained', 'none', 'one', 'tangent', 'two']);
    expect(of('hyperboloid')).toEqual(['contained', 'none', 'one', 'tangent', 'two']);
    for (const flat of ['plane', 'circle', 'square'])
      expect(of(flat)).toEqual(['contained', 'none', 'one']);
  });

  test('points of which a coordinate cancels: E and t d agree in many digits (seed 24)', () => {
    const random = seeded(24);
    const questions = Array.from({ length: 1500 }, (_, k) => {
      const t = uniform(random, 1, 50);
      const d: Vec3 = [uniform(random, 1, 3), uniform(random, -1, 1), uniform(random, 1, 3)];
      const off = (): number => 2 ** -integer(random, 20, 56);
      const origin: Vec3 = [
        -t * d[0] * (1 + off()),
        uniform(random, -1, 1),
        -t * d[2] * (1 - off()),
      ];
      const shape: Shape =
        k % 3 === 0
          ? { kind: 'plane', normal: [1, 0, uniform(random, 0.5, 2)], point: [0, 0, 0] }
          : k % 3 === 1
            ? {
                kind: 'cylinder',
                center: [uniform(random, 0, 1), 0, 0],
                radius: uniform(random, 0, 1),
              }
            : { kind: 'cylinder', center: [1, 0, 0], radius: 1 - off() };
      return { shape, ray: { origin, direction: d } };
    });
    stages(questions);
    expect(questions.flatMap((question) => misplaced(question))).toEqual([]);
  });

  test('any exponents at all (seed 23)', () => {
    const random = seeded(23);
    const some = () => (random() < 0.2 ? 0 : wide(random));
    for (let k = 0; k < 3000; k++) {
      const shape = anyShape(random, some, () => Math.abs(some()));
      expect(disagreement(shape, anyRay(some))).toBeNull();
    }
  });
});

function anyShape(random: Random, any: () => number, size: () => number): Shape {
  const at = (): Vec3 => [any(), any(), any()];
  const normal = (): Vec3 => {
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

function anyRay(any: () => number): Ray {
  const direction: [number, number, number] = [any(), any(), any()];
  if (direction.every((x) => x === 0)) direction[0] = 1;
  return { origin: [any(), any(), any()], direction };
}

describe('a walk of single doubles through a tangency changes class once, where exact does', () => {
  const steps = 60;
  /** The doubles from `steps` below x to `steps` above. */
  function* around(x: number): Generator<number> {
    let at = x;
    for (let k = 0; k < steps; k++) at = nextDown(at);
    for (let k = 0; k <= 2 * steps; k++) {
      yield at;
      at = nextUp(at);
    }
  }
  const walks: [string, number, (x: number) => { shape: Shape; ray: Ray }][] = [
    [
      'radius of a cylinder',
      2.5,
      (radius) => ({
        shape: { kind: 'cylinder', center: [0.5, 0, 1], radius },
        ray: { origin: [-3, 2, 3.5], direction: [1, 0.25, 0] },
      }),
    ],
    [
      'E.z beside a cylinder',
      3.5,
      (z) => ({
        shape: { kind: 'cylinder', center: [0.5, 0, 1], radius: 2.5 },
        ray: { origin: [-3, 2, z], direction: [1, 0.25, 0] },
      }),
    ],
    [
      'flare of a sphere-like shape',
      -1,
      (flare) => ({
        shape: { kind: 'hyperboloid', center: [0, 0, 0], flare, radius: 1 },
        ray: { origin: [-3, 1, 0], direction: [1, 0, 0] },
      }),
    ],
    [
      'rim of a circle',
      5,
      (radius) => ({
        shape: { kind: 'circle', normal: [0, 0, 2], center: [0, 0, 0], radius },
        ray: { origin: [3, 4, 2], direction: [0, 0, -1] },
      }),
    ],
    [
      'edge of a square',
      1,
      (x) => ({
        shape: { kind: 'square', corner: [0, 0, 0], side: 1, axis: 'z' },
        ray: { origin: [x, 0.5, 2], direction: [0, 0, -1] },
      }),
    ],
  ];
  test.each(walks)('%s', (_, at, make) => {
    const classes = [...around(at)].map((x) => {
      const { shape, ray } = make(x);
      expect(disagreement(shape, ray)).toBeNull();
      return intersect(shape, ray, 'certified').class;
    });
    const changes = classes.filter((c, k) => k > 0 && c !== classes[k - 1]).length;
    const throughTangent = classes.includes('tangent');
    expect([changes, throughTangent]).toEqual(throughTangent ? [2, true] : [1, false]);
    const exactAt = make(at);
    expect(classes[steps]).toBe(intersect(exactAt.shape, exactAt.ray, 'exact').class);
  });
});

test('what is named by the stage that decides is what decided', () => {
  const cylinder: Shape = { kind: 'cylinder', center: [0, 0, 0], radius: 1 };
  const by = (origin: Vec3, direction: Vec3) =>
    intersect(cylinder, { origin, direction }, 'certified').decidedBy;
  expect(by([-3, 0, 0.25], [1, 0.5, 0])).toBe('filter');
  expect(by([-3, 0, 1 - 2 ** -45], [1, 0.3, 0])).toBe('double-double');
  expect(by([-3, 0, 1], [1, 0.3, 0])).toBe('exact');
});
