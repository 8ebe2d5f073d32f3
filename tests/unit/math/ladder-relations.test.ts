import { describe, expect, test } from 'vitest';
import { exact as exactly } from '../../../src/math/arithmetic/exact.ts';
import { FAMILIES, type Question } from '../../../src/math/families.ts';
import { scale } from '../../../src/math/float/bits.ts';
import type { Hit } from '../../../src/math/intersection.ts';
import { certified } from '../../../src/math/methods/certified.ts';
import { exact } from '../../../src/math/methods/exact.ts';
import { seeded } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { findShape } from '../../../src/math/shapes/lookup.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { disagreement } from './against-exact.ts';
import { polynomial } from './surface.ts';

/*
 * What must happen to the answer when the question is turned, mirrored, scaled or moved without a
 * rounding: by exact to the last bit, by certified to the class and the doubles around each root,
 * on every family, however hard. (The contract suite asks the same of every method on rays that
 * round nothing.)
 */

const SEED = 111;
const COUNT = 25;

const questions = (id: string): Question[] => {
  const random = seeded(SEED);
  const family = FAMILIES().find((f) => f.id === id);
  return Array.from({ length: COUNT }, () => family?.make(random) as Question);
};

/** Applies `v` to every place and direction of the question, `n` to N, `k` to every length. */
function mapped(
  { shape, ray }: Question,
  v: (x: Vec3) => Vec3,
  length: (x: number) => number = (x) => x,
): Question {
  const turned = (key: string, x: unknown): unknown => {
    if (key === 'normal') return undirected(v, x as Vec3);
    if (Array.isArray(x)) return v(x as unknown as Vec3);
    const param = findShape(shape.kind)?.params.find((one) => one.key === key);
    return param?.type === 'number' && param.unit === 'length' ? length(x as number) : x;
  };
  const entries = Object.entries(shape).map(([key, x]) => [key, turned(key, x)] as const);
  return {
    shape: Object.fromEntries(entries) as unknown as Shape,
    ray: { origin: v(ray.origin), direction: v(ray.direction) },
  };
}

/** N is a direction, whose length must not leave the doubles: it is not scaled. */
const undirected = (v: (x: Vec3) => Vec3, n: Vec3): Vec3 => {
  const image = v(n);
  return Math.abs(image[0]) + Math.abs(image[1]) + Math.abs(image[2]) < 1e100 &&
    Math.abs(image[0]) + Math.abs(image[1]) + Math.abs(image[2]) > 1e-100
    ? image
    : n;
};

const plusZero = (x: number): number => x + 0;
const shown = (hits: readonly Hit[], t: (x: number) => number, v: (x: Vec3) => Vec3, n = v) =>
  hits.map((hit) => ({
    t: plusZero(t(hit.t)),
    point: v(hit.point).map(plusZero),
    normal: n(hit.normal).map(plusZero),
    singular: hit.singular,
  }));
const same = <T>(x: T): T => x;

function expectImage(
  q: Question,
  image: Question,
  t: (x: number) => number,
  v: (x: Vec3) => Vec3,
  n = v,
): void {
  const [before, after] = [
    exact.intersect(q.shape, q.ray),
    exact.intersect(image.shape, image.ray),
  ];
  expect(after.class, JSON.stringify(q)).toBe(before.class);
  const expected = shown(before.hits, t, v, n);
  if (t(1) < 0) expected.reverse();
  expect(shown(after.hits, same, same), JSON.stringify(q)).toEqual(expected);
  expectCertified(q, image);
}

/**
 * The same class; and each root, before and after, one of the two doubles around the exact one.
 * Which of the two may change with the question, so the bits are not compared with each other.
 */
function expectCertified(q: Question, image: Question): void {
  const [before, after] = [q, image].map(({ shape, ray }) => certified.intersect(shape, ray));
  expect(after?.class, JSON.stringify(q)).toBe(before?.class);
  expect([disagreement(q.shape, q.ray), disagreement(image.shape, image.ray)]).toEqual([
    null,
    null,
  ]);
}

const swapped = ([x, y, z]: Vec3): Vec3 => [z, y, x];
const mirrored = ([x, y, z]: Vec3): Vec3 => [-x, y, z];
/**
 * Squares start at their lower left corner, so they are not mirrored; and an axis is renamed by an
 * exchange.
 */
const isSquare = ({ shape }: Question): boolean => shape.kind === 'square';
const exchanged = (q: Question): Question => {
  const image = mapped(q, swapped);
  if (q.shape.kind !== 'square') return image;
  return {
    ...image,
    shape: { ...image.shape, axis: ({ x: 'z', y: 'y', z: 'x' } as const)[q.shape.axis] } as Shape,
  };
};

/** Not every surface has these symmetries: its equation along some rays says whether it does. */
function isSameSurface(q: Question, image: Question, v: (x: Vec3) => Vec3): boolean {
  const directions: readonly Vec3[] = [q.ray.direction, [1, 0, 0], [0, 0, 1], [1, 2, 3]];
  return directions.every((direction) => {
    const f = polynomial(q.shape, { ...q.ray, direction });
    const g = polynomial(image.shape, { ...image.ray, direction: v(direction) });
    return (['A', 'B', 'C'] as const).every((id) => exactly.sign(exactly.sub(f[id], g[id])) === 0);
  });
}

const normal = (x: number): boolean => x === 0 || (Math.abs(x) > 1e-290 && Math.abs(x) < 1e290);
/**
 * A change of scale rounds no number of the question or of its answer; a root that is 0 did not
 * underflow.
 */
function roomy(q: Question): boolean {
  const { hits, details } = exact.intersect(q.shape, q.ray);
  const asked = [...Object.values(q.shape), q.ray.origin, q.ray.direction].flat();
  const answered = hits.flatMap(({ t, point, normal: n }) => [t, ...point, ...n]);
  const start = details.family === 'curved' ? details.signs.C : details.signs.offset;
  return (
    asked.every((x) => typeof x !== 'number' || normal(x)) &&
    answered.every(normal) &&
    hits.every(({ t }) => t !== 0 || start === 0)
  );
}

describe.each(FAMILIES().map(({ id }) => id))('%s (seed 111)', (id) => {
  const asked = questions(id);

  test('−d: t changes its sign, the order turns round', () => {
    for (const q of asked) {
      const [x, y, z] = q.ray.direction;
      const image = {
        shape: q.shape,
        ray: { origin: q.ray.origin, direction: [-x, -y, -z] as const },
      };
      expectImage(q, image, (t) => -t, same);
    }
  });

  test('x and z exchanged', () => {
    for (const q of asked) {
      const image = exchanged(q);
      if (isSameSurface(q, image, swapped)) expectImage(q, image, same, swapped);
    }
  });

  test('mirrored in x', () => {
    for (const q of asked) {
      const image = mapped(q, mirrored);
      if (!isSquare(q) && isSameSurface(q, image, mirrored)) expectImage(q, image, same, mirrored);
    }
  });

  test('d times 2^7 and 2^-9: t divided by it', () => {
    for (const q of asked.filter(roomy)) {
      for (const k of [7, -9]) {
        const [x, y, z] = q.ray.direction;
        const direction: Vec3 = [scale(x, k), scale(y, k), scale(z, k)];
        expectImage(q, { shape: q.shape, ray: { ...q.ray, direction } }, (t) => scale(t, -k), same);
      }
    }
  });

  test('every length times 2^11: the same t, places scaled', () => {
    const times =
      (k: number) =>
      ([x, y, z]: Vec3): Vec3 => [scale(x, k), scale(y, k), scale(z, k)];
    for (const q of asked.filter(roomy)) {
      const image = mapped(q, times(11), (x) => scale(x, 11));
      // A square's normal is always 1 long; the others' went along.
      expectImage(q, image, same, times(11), isSquare(q) ? same : times(11));
    }
  });
});

describe.each([
  'exact-tangent',
  'generator',
  'linear',
  'degenerate',
  'flat-degenerate',
  'circle-rim',
  'square-edge',
  'plane-grazing',
])('%s moved by a whole vector (seed 111)', (id) => {
  test('the same t, places moved', () => {
    const by: Vec3 = [1024, -512, 256];
    const moved = ([x, y, z]: Vec3): Vec3 => [x + by[0], y + by[1], z + by[2]];
    let asked = 0;
    for (const q of questions(id)) {
      const entries = Object.entries(q.shape).map(([key, x]) => [
        key,
        ['center', 'vertex', 'corner', 'point'].includes(key) ? moved(x as Vec3) : x,
      ]);
      const image: Question = {
        shape: Object.fromEntries(entries) as Shape,
        ray: { ...q.ray, origin: moved(q.ray.origin) },
      };
      const back = image.ray.origin.map((x, i) => x - (by[i] as number));
      if (back.some((x, i) => x !== q.ray.origin[i])) continue;
      asked += 1;
      const [before, after] = [
        exact.intersect(q.shape, q.ray),
        exact.intersect(image.shape, image.ray),
      ];
      expect(after.class).toBe(before.class);
      expectCertified(q, image);
      expect(after.hits.map(({ t, normal }) => ({ t, normal }))).toEqual(
        before.hits.map(({ t, normal }) => ({ t, normal })),
      );
    }
    expect(asked).toBeGreaterThan(5);
  });
});
