import { describe, expect, test } from 'vitest';
import {
  FAMILIES,
  type Family,
  findFamily,
  madeFamilies,
  type Question,
} from '../../../src/math/families.ts';
import { checkedRay } from '../../../src/math/given-ray.ts';
import type { CurvedDetails, FlatDetails, Intersection } from '../../../src/math/intersection.ts';
import { exact } from '../../../src/math/methods/exact.ts';
import { type Random, seeded } from '../../../src/math/rng.ts';
import { SHAPES, type Shape } from '../../../src/math/shapes/index.ts';
import { checkedShape, findShape } from '../../../src/math/shapes/lookup.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { onBoundary } from './boundary.ts';
import { rayCases } from './read-vectors.ts';

const COUNT = 200;
const SEED = 51;

interface Asked extends Question {
  readonly found: Intersection;
}

const family = (id: string): Family => findFamily(id) as Family;

function draw(id: string, difficulty?: number, count = COUNT): Asked[] {
  const random = seeded(SEED);
  return Array.from({ length: count }, () => {
    const question = family(id).make(random, difficulty);
    return { ...question, found: exact.intersect(question.shape, question.ray) };
  });
}

const curved = ({ found }: Asked): CurvedDetails => found.details as CurvedDetails;
const flat = ({ found }: Asked): FlatDetails => found.details as FlatDetails;
const roots = ({ found }: Asked): number[] => found.hits.map(({ t }) => t);
const classesOf = (asked: readonly Asked[]): string[] =>
  [...new Set(asked.map(({ found }) => found.class))].sort();
const kindsOf = (asked: readonly Question[]): string[] =>
  [...new Set(asked.map(({ shape }) => shape.kind))].sort();
const share = <T>(all: readonly T[], has: (one: T) => boolean): number =>
  all.filter(has).length / all.length;
const CURVED = ['cone', 'cylinder', 'hyperboloid'];

const lengthOf = (v: Vec3): number => Math.hypot(...v);
const centerOf = (shape: Shape): Vec3 =>
  'vertex' in shape
    ? shape.vertex
    : 'center' in shape
      ? shape.center
      : 'point' in shape
        ? shape.point
        : shape.corner;
const distanceOf = ({ shape, ray: { origin } }: Question): number => {
  const [x, y, z] = centerOf(shape);
  return lengthOf([origin[0] - x, origin[1] - y, origin[2] - z]);
};
/** dx² + dz² + |a|dy²: what A would be if nothing cancelled. */
function wholeA({ shape, ray: { direction } }: Question): number {
  const a = 'slope' in shape ? shape.slope ** 2 : 'flare' in shape ? Math.abs(shape.flare) : 0;
  const [x, y, z] = direction;
  return x * x + z * z + a * y * y;
}

describe('the list', () => {
  test('has every family of the vectors for the course’s shapes, each id once', () => {
    const ids = FAMILIES().map(({ id }) => id);
    expect(new Set(ids).size).toBe(ids.length);
    const known = rayCases.filter(({ shape }) => findShape(shape.kind)?.ownFamilies);
    expect(ids).toEqual(expect.arrayContaining(known.map((c) => c.family)));
  });

  test('every shape has its own families or is given some of each hardness', () => {
    for (const { kind, ownFamilies } of SHAPES) {
      const made = (['ordinary', 'special', 'hard'] as const).map((h) => madeFamilies(kind, h));
      expect([kind, made.every((list) => list.length > 0)]).toEqual([kind, !ownFamilies]);
      expect([kind, made.some((list) => list.length > 0)]).toEqual([kind, !ownFamilies]);
    }
  });

  test('every one says what is in it in a sentence', () => {
    for (const { idea, title } of FAMILIES()) {
      expect(idea).toMatch(/^\S.{20,}[^.]\.$/);
      expect(title).not.toBe('');
    }
  });
});

describe.each(FAMILIES())('$id', ({ make, batch, dial }) => {
  const many = (random: Random, difficulty?: number): Question[] =>
    Array.from({ length: 60 }, () => make(random, difficulty));

  test('asks valid questions, at both ends of its dial too', () => {
    for (const difficulty of [undefined, ...(dial ? dial.range : [])]) {
      for (const { shape, ray } of many(seeded(1), difficulty)) {
        checkedShape(shape);
        checkedRay(ray);
      }
    }
  });

  test('the same seed asks the same, another one does not', () => {
    expect(many(seeded(2))).toEqual(many(seeded(2)));
    expect(many(seeded(2))).not.toEqual(many(seeded(3)));
  });

  test('a batch is many rays for one shape', () => {
    const { shape, rays } = batch(seeded(4), 50);
    checkedShape(shape);
    rays.forEach(checkedRay);
    expect(rays).toHaveLength(50);
    expect(new Set(rays.map((ray) => JSON.stringify(ray))).size).toBeGreaterThan(10);
    expect(shape).toEqual(make(seeded(4)).shape);
  });

  test('its usual difficulty is on the dial', () => {
    if (!dial) return;
    expect(dial.usual[0]).toBeGreaterThanOrEqual(dial.range[0]);
    expect(dial.usual[1]).toBeLessThanOrEqual(dial.range[1]);
    expect(dial.range[0]).toBeLessThan(dial.range[1]);
  });
});

describe('ordinary ones', () => {
  test('typical: all curved kinds, hits and misses, nothing large or small', () => {
    const asked = draw('typical');
    expect(kindsOf(asked)).toEqual(CURVED);
    expect(classesOf(asked)).toEqual(['none', 'two']);
    const numbers = asked.flatMap(({ ray }) => [lengthOf(ray.origin), lengthOf(ray.direction)]);
    expect(Math.min(...numbers)).toBeGreaterThan(0.01);
    expect(Math.max(...numbers)).toBeLessThan(30);
  });

  test('mix: as many hard rays as the dial says', () => {
    const far = (percent: number) => share(draw('mix', percent, 1000), (q) => distanceOf(q) > 90);
    expect(far(0)).toBe(0);
    // Two of the six hard kinds are far away.
    expect(far(100)).toBeGreaterThan(0.25);
    expect(far(100)).toBeLessThan(0.42);
    expect(far(10)).toBeGreaterThan(0.015);
    expect(far(10)).toBeLessThan(0.06);
  });

  test.each([0, 4, 8, 12])('far-origin at 10^%d: so far away, and nearly all hit', (k) => {
    const asked = draw('far-origin', k);
    expect(Math.min(...asked.map(distanceOf))).toBeGreaterThan(k === 0 ? 0 : 0.15 * 10 ** k);
    expect(Math.max(...asked.map(distanceOf))).toBeLessThan(6 * 10 ** k);
    expect(share(asked, ({ found }) => found.class === 'two')).toBeGreaterThan(0.85);
    expect(kindsOf(asked)).toEqual(CURVED);
  });
});

describe('around tangents', () => {
  /** |D| / (B² + |4AC|). */
  const relativeD = (asked: Asked): number => {
    const { A, B, C, D } = curved(asked);
    return Math.abs(D) / (B * B + Math.abs(4 * A * C));
  };
  const median = (xs: number[]): number => xs.sort((a, b) => a - b)[xs.length >> 1] as number;

  test.each([2, 6, 10, 14])('near-tangent: D shrinks with the gap 10^-%d, both signs', (k) => {
    const asked = draw('near-tangent', k);
    // A cylinder curves one way only: both classes mean that the gap is on both sides.
    expect(classesOf(asked.filter(({ shape }) => shape.kind === 'cylinder'))).toEqual([
      'none',
      'two',
    ]);
    expect(median(asked.map(relativeD)) * 10 ** k).toBeGreaterThan(0.01);
    expect(median(asked.map(relativeD)) * 10 ** k).toBeLessThan(1);
  });

  test('near-tangent-far: near and far at once', () => {
    const asked = draw('near-tangent-far', 5);
    expect(classesOf(asked)).toEqual(['none', 'two']);
    expect(Math.min(...asked.map(distanceOf))).toBeGreaterThan(1e4);
    expect(median(asked.map(relativeD))).toBeLessThan(1e-15);
  });

  test('exact-tangent: always, on every curved shape, cones away from the vertex too', () => {
    const asked = draw('exact-tangent');
    expect(classesOf(asked)).toEqual(['tangent']);
    expect(kindsOf(asked)).toEqual(CURVED);
    expect(share(asked, ({ found }) => found.hits.every(({ singular }) => singular))).toBe(0);
  });

  test('vertex: through the singular point, or past it by a hair', () => {
    const asked = draw('vertex');
    const through = asked.filter(({ found }) => found.hits.some(({ singular }) => singular));
    expect(share(asked, (q) => through.includes(q))).toBeGreaterThan(0.4);
    expect(classesOf(through)).toEqual(['tangent']);
    expect(classesOf(asked)).toEqual(['none', 'tangent', 'two']);
    // The rest starts at the vertex, give or take some doubles.
    expect(share(asked, (q) => relativeD(q) < 1e-12)).toBeGreaterThan(0.9);
  });
});

describe('where A vanishes', () => {
  test.each([2, 6, 10, 14])('near-axis: A is about 10^-%d of its terms', (k) => {
    const asked = draw('near-axis', k);
    const relativeA = asked.map((q) => Math.abs(curved(q).A) / wholeA(q));
    expect(kindsOf(asked)).toEqual(CURVED);
    expect(share(relativeA, (x) => x < 20 * 10 ** -k || x > 0.99)).toBe(1);
    // A cylinder's A has no terms that cancel: there it is d that nearly has only a dy.
    const tilts = asked.map(({ ray: { direction: d } }) => Math.hypot(d[0], d[2]) / Math.abs(d[1]));
    const level = asked.map(
      ({ shape }, i) => shape.kind !== 'cylinder' || (tilts[i] ?? 1) < 10 ** -k * 2,
    );
    expect(level).not.toContain(false);
  });

  test('linear: A is exactly 0, with one root or none', () => {
    const asked = draw('linear');
    expect(asked.every((q) => curved(q).signs.A === 0)).toBe(true);
    expect(classesOf(asked)).toEqual(['none', 'one']);
    expect(kindsOf(asked)).toEqual(CURVED);
  });

  test('generator: always contained', () => {
    const asked = draw('generator');
    expect(classesOf(asked)).toEqual(['contained']);
    expect(kindsOf(asked)).toEqual(CURVED);
  });

  test('near-generator: a few doubles from there, and every class', () => {
    const asked = draw('near-generator', undefined, 600);
    expect(classesOf(asked)).toEqual(['contained', 'none', 'one', 'tangent', 'two']);
    expect(
      Math.max(...asked.map((q) => Math.abs(curved(q).A) / wholeA(q)).filter((x) => x < 1)),
    ).toBeLessThan(1e-14);
    expect(share(asked, ({ found }) => found.class === 'contained')).toBeLessThan(0.5);
  });

  test('linear-cancellation: A is tiny, the products of B cancel', () => {
    for (const q of draw('linear-cancellation', 6)) {
      const { center } = q.shape as { center: Vec3 };
      const { origin: E, direction: d } = q.ray;
      const whole = 2 * Math.hypot(d[0], d[2]) * Math.hypot(E[0] - center[0], E[2] - center[2]);
      expect(Math.abs(curved(q).B)).toBeLessThan(0.2 * whole);
      expect(curved(q).A).toBeLessThan(1e-11);
    }
  });
});

describe('where the ray starts', () => {
  test('on-surface: C is exactly 0, and so is a root', () => {
    const asked = draw('on-surface');
    expect(asked.every((q) => curved(q).signs.C === 0 && roots(q).includes(0))).toBe(true);
    expect(kindsOf(asked)).toEqual(CURVED);
  });

  test('near-surface: a root of rounding size, seldom 0', () => {
    const asked = draw('near-surface');
    const least = asked.map((q) => Math.min(...roots(q).map(Math.abs)));
    expect(share(least, (t) => t < 1e-14)).toBeGreaterThan(0.9);
    expect(share(least, (t) => t === 0)).toBeLessThan(0.2);
  });

  test.each([3, 7, 12])('cancellation: a root about 10^-%d of the other', (k) => {
    const asked = draw('cancellation', k).filter(({ found }) => found.class === 'two');
    expect(asked.length).toBeGreaterThan(0.9 * COUNT);
    const ratios = asked.map((q) => {
      const [t, s] = roots(q).map(Math.abs) as [number, number];
      return Math.min(t, s) / Math.max(t, s);
    });
    expect(share(ratios, (x) => x < 30 * 10 ** -k && x > 0.001 * 10 ** -k)).toBeGreaterThan(0.9);
  });
});

describe('scales', () => {
  const rootsOf = (id: string, k: number): number[][] => draw(id, k, 60).map(roots);

  test('scale-ray: d times a power of two, t divided by it exactly', () => {
    for (const [k, bits] of [
      [100, 332],
      [-150, -498],
    ] as const) {
      const expected = rootsOf('scale-ray', 0).map((ts) => ts.map((t) => t * 2 ** -bits));
      expect(rootsOf('scale-ray', k)).toEqual(expected);
    }
  });

  test.each([140, -140])('scale-world at 10^%d: the same t', (k) => {
    expect(rootsOf('scale-world', k)).toEqual(rootsOf('scale-world', 0));
    const sizes = draw('scale-world', k).map(({ ray }) => Math.log10(lengthOf(ray.direction)));
    expect(Math.abs(Math.min(...sizes) - k)).toBeLessThan(3);
  });

  test('out-of-range: beyond the largest double, below the normal ones, and 0', () => {
    const asked = draw('out-of-range');
    const normal = (t: number): boolean => Math.abs(t) >= 2 ** -1022 && Number.isFinite(t);
    expect(classesOf(asked)).toEqual(['two']);
    expect(asked.filter((q) => roots(q).every(normal))).toEqual([]);
    const all = asked.flatMap(roots);
    expect(all).toContain(Infinity);
    expect(all.some((t) => t === 0)).toBe(true);
    expect(all.some((t) => t !== 0 && Math.abs(t) < 2 ** -1022)).toBe(true);
  });

  test('extreme-parameter: sizes across twenty powers of ten, zeros, a < 0', () => {
    const asked = draw('extreme-parameter');
    const sizes = asked.flatMap(({ shape }) =>
      Object.values(shape).filter((x): x is number => typeof x === 'number'),
    );
    expect(Math.max(...sizes)).toBeGreaterThan(1e7);
    expect(Math.min(...sizes)).toBeLessThan(-1e7);
    expect(sizes.filter((x) => x === 0).length).toBeGreaterThan(20);
    expect(Math.min(...sizes.map(Math.abs).filter((x) => x > 0))).toBeLessThan(1e-10);
    expect(kindsOf(asked)).toEqual(CURVED);
  });
});

describe('small whole numbers', () => {
  test('degenerate: every class', () => {
    expect(classesOf(draw('degenerate', undefined, 1500))).toEqual([
      'contained',
      'none',
      'one',
      'tangent',
      'two',
    ]);
  });

  test('flat-degenerate: parallel, in the plane through the figure and past it', () => {
    const asked = draw('flat-degenerate');
    expect(kindsOf(asked)).toEqual(['circle', 'plane', 'square']);
    expect(share(asked, (q) => flat(q).signs.rate === 0)).toBeGreaterThan(0.4);
    expect(classesOf(asked)).toEqual(['contained', 'none', 'one']);
    expect([...new Set(asked.map((q) => flat(q).meetsFigure))]).toEqual(
      expect.arrayContaining([true, false]),
    );
  });
});

describe('flat shapes', () => {
  test('plane, circle and square: ordinary, inside and outside', () => {
    expect(classesOf(draw('plane'))).toEqual(['one']);
    expect(classesOf(draw('circle'))).toEqual(['none', 'one']);
    expect(classesOf(draw('square'))).toEqual(['none', 'one']);
    for (const id of ['circle', 'square']) {
      const inside = share(draw(id), ({ found }) => found.class === 'one');
      expect(inside).toBeGreaterThan(0.3);
      expect(inside).toBeLessThan(0.75);
    }
  });

  test('plane-grazing: parallel or off that by a few doubles', () => {
    const asked = draw('plane-grazing');
    expect(classesOf(asked)).toEqual(['contained', 'none', 'one']);
    expect(share(asked, (q) => flat(q).signs.rate === 0)).toBeGreaterThan(0.3);
    const rates = asked.map((q) => {
      const { normal } = q.shape as { normal: Vec3 };
      return Math.abs(flat(q).rate) / lengthOf(normal) / lengthOf(q.ray.direction);
    });
    expect(Math.max(...rates)).toBeLessThan(1e-14);
  });

  test.each([3, 12])('plane-far: at 10^%d', (k) => {
    const asked = draw('plane-far', k);
    expect(Math.min(...asked.map(distanceOf))).toBeGreaterThan(0.9 * 10 ** k);
    expect(classesOf(asked)).toEqual(['one']);
  });

  test.each(['circle-rim', 'square-edge'])('%s: on it exactly, just inside, just outside', (id) => {
    const asked = draw(id);
    const there = asked.filter(({ shape, ray }) => onBoundary(shape, ray));
    expect(there.length / COUNT).toBeGreaterThan(0.35);
    expect(classesOf(there)).toEqual(['one']);
    const beside = asked.filter((q) => !there.includes(q));
    expect(classesOf(beside)).toEqual(['none', 'one']);
    const distances = beside.map((q) => flat(q).plane?.distance ?? Number.NaN);
    expect(Math.max(...distances)).toBeLessThan(1e-9);
  });
});
