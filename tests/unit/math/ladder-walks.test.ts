import { describe, expect, test } from 'vitest';
import { exact as numbers } from '../../../src/math/arithmetic/exact.ts';
import { bracket } from '../../../src/math/exact/faithful.ts';
import type { Surd } from '../../../src/math/exact/surd.ts';
import { findFamily, type Question } from '../../../src/math/families.ts';
import { nextDown, nextUp } from '../../../src/math/float/ulp.ts';
import { exact } from '../../../src/math/methods/exact.ts';
import { type Random, seeded } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';

/*
 * A number is stepped through the place where the class changes, double by double: it must change
 * once, and there.
 */

const STEPS = 25;

/** The 25 doubles before x, x, and the 25 after it. */
function neighbours(x: number): number[] {
  const before: number[] = [];
  const after: number[] = [];
  for (let i = 0, low = x, high = x; i < STEPS; i++) {
    low = nextDown(low);
    high = nextUp(high);
    before.unshift(low);
    after.push(high);
  }
  return [...before, x, ...after];
}

const classAt = ({ shape, ray }: Question): string => exact.intersect(shape, ray).class;

function drawn(id: string, count: number, seed: number): Question[] {
  const random = seeded(seed);
  return Array.from({ length: count }, () => findFamily(id)?.make(random) as Question);
}

const withOrigin = (q: Question, i: number, x: number): Question => ({
  shape: q.shape,
  ray: { ...q.ray, origin: q.ray.origin.map((c, k) => (k === i ? x : c)) as unknown as Vec3 },
});
const withParameter = (q: Question, key: string, x: number): Question => ({
  ray: q.ray,
  shape: { ...q.shape, [key]: x } as Shape,
});

/** none … none, tangent, two … two, or the other way round. */
function expectOneFlip(questions: Question[], middle: string, ends: readonly string[]): void {
  const classes = questions.map(classAt);
  const [before, at, after] = [classes.slice(0, STEPS), classes[STEPS], classes.slice(STEPS + 1)];
  expect(at).toBe(middle);
  expect(new Set(before).size).toBe(1);
  expect(new Set(after).size).toBe(1);
  expect([before[0], after[0]].sort()).toEqual([...ends].sort());
}

describe('through an exact tangent of whole numbers', () => {
  const tangents = drawn('exact-tangent', 40, 101);

  test('with r, c or a', () => {
    let walked = 0;
    for (const q of tangents) {
      for (const key of ['radius', 'slope'] as const) {
        const at = (q.shape as unknown as Record<string, number>)[key];
        if (at === undefined) continue;
        expectOneFlip(
          neighbours(at).map((x) => withParameter(q, key, x)),
          'tangent',
          ['none', 'two'],
        );
        walked += 1;
      }
    }
    expect(walked).toBe(tangents.length);
  });

  test('with the coordinate of E along which the normal points most', () => {
    for (const q of tangents) {
      const [nx, , nz] = exact.intersect(q.shape, q.ray).hits[0]?.normal ?? [0, 0, 0];
      const i = Math.abs(nx) >= Math.abs(nz) ? 0 : 2;
      const at = q.ray.origin[i];
      expectOneFlip(
        neighbours(at).map((x) => withOrigin(q, i, x)),
        'tangent',
        ['none', 'two'],
      );
    }
  });
});

/** E − C and d as exact numbers, with moment and forms (docs/NUMERICS.md, 2) written out. */
function exactly({ shape, ray }: Question) {
  const { add, sub, mul, sqr, of } = numbers;
  const center =
    'vertex' in shape
      ? shape.vertex
      : 'center' in shape
        ? shape.center
        : 'corner' in shape
          ? shape.corner
          : shape.point;
  const p = ray.origin.map((x, i) => sub(of(x), of(center[i] as number))) as [Surd, Surd, Surd];
  const d = ray.direction.map(of) as [Surd, Surd, Surd];
  const minor = (i: 0 | 1 | 2, j: 0 | 1 | 2): Surd => sub(mul(d[i], p[j]), mul(d[j], p[i]));
  const m = [minor(1, 2), minor(2, 0), minor(0, 1)] as [Surd, Surd, Surd];
  const level = add(sqr(d[0]), sqr(d[2]));
  const side = add(sqr(m[0]), sqr(m[2]));
  return { d, m, level, side };
}

/**
 * The class on both sides of where the number, were it not a double, would make the ray a tangent.
 */
function expectFlipAt(
  q: Question,
  key: string,
  threshold: Surd,
  below: string,
  above: string,
): boolean {
  const [low, high] = bracket(threshold);
  if (low === high || !(low > 0)) return false;
  const [before, after] = [
    classAt(withParameter(q, key, low)),
    classAt(withParameter(q, key, high)),
  ];
  expect([key, JSON.stringify(q), before, after]).toEqual([key, JSON.stringify(q), below, above]);
  return true;
}

const many = (id: string, kind: string, count: number, seed: number): Question[] =>
  drawn(id, 6 * count, seed)
    .filter(({ shape }) => shape.kind === kind)
    .slice(0, count);

describe('through a tangency between two doubles', () => {
  const { div, sqr, sqrt, sub, mul, of, sign } = numbers;

  test.each(['typical', 'far-origin', 'near-axis', 'scale-world'])(
    'a cylinder’s r = |my| / √A: %s',
    (id) => {
      const asked = many(id, 'cylinder', 60, 102).filter((q) => {
        const { m, level } = exactly(q);
        return expectFlipAt(q, 'radius', sqrt(div(sqr(m[1]), level)), 'none', 'two');
      });
      expect(asked.length).toBeGreaterThan(40);
    },
  );

  test.each(['typical', 'far-origin', 'near-axis', 'scale-world'])(
    'a cone’s c = |my| / √(mx² + mz²): %s',
    (id) => {
      const asked = many(id, 'cone', 60, 103).filter((q) => {
        const { m, side } = exactly(q);
        return expectFlipAt(q, 'slope', sqrt(div(sqr(m[1]), side)), 'none', 'two');
      });
      expect(asked.length).toBeGreaterThan(40);
    },
  );

  test.each(['typical', 'far-origin', 'scale-ray'])(
    'a hyperboloid’s a, where D is linear in it: %s',
    (id) => {
      const asked = many(id, 'hyperboloid', 60, 104).filter((q) => {
        const { d, m, level, side } = exactly(q);
        const rho = sqr(of((q.shape as { radius: number }).radius));
        const slope = sub(side, mul(rho, sqr(d[1])));
        const a = div(sub(sqr(m[1]), mul(rho, level)), slope);
        const [below, above] = sign(slope) > 0 ? ['none', 'two'] : ['two', 'none'];
        return expectFlipAt(q, 'flare', a, below as string, above as string);
      });
      expect(asked.length).toBeGreaterThan(15);
    },
  );
});

describe('through rim and edge', () => {
  test('of whole numbers: the last double inside is the rim itself', () => {
    for (const [id, key] of [
      ['circle-rim', 'radius'],
      ['square-edge', 'side'],
    ] as const) {
      let walked = 0;
      const random: Random = seeded(105);
      for (let i = 0; i < 60; i++) {
        const q = findFamily(id)?.make(random) as Question;
        const at = boundOf(q);
        if (at === null || at <= 0) continue;
        const classes = neighbours(at).map((x) => classAt(withParameter(q, key, x)));
        expect(classes).toEqual(classes.map((_, k) => (k < STEPS ? 'none' : 'one')));
        walked += 1;
      }
      expect(walked).toBeGreaterThan(15);
    }
  });

  /**
   * The least r or L for which the figure is met, if that is a double; null for a square that is
   * missed anyway.
   */
  function boundOf(q: Question): number | null {
    const found = thresholdOf(q);
    if (!found) return null;
    const [low, high] = bracket(found);
    return low === high ? low : null;
  }

  /** r = |w| / |N·d|; L = the larger of the two coordinates, if none is negative. */
  function thresholdOf(q: Question): Surd | null {
    const { add, sub, mul, div, sqr, sqrt, of, sign, neg } = numbers;
    const { d, m } = exactly(q);
    const axis = 'axis' in q.shape ? { x: 0, y: 1, z: 2 }[q.shape.axis] : -1;
    const normal =
      'normal' in q.shape ? q.shape.normal : [0, 1, 2].map((i) => (i === axis ? 1 : 0));
    const N = normal.map(of) as [Surd, Surd, Surd];
    const rate = d.map((x, i) => mul(x, N[i] as Surd)).reduce(add);
    const minor = (i: 0 | 1 | 2, j: 0 | 1 | 2): Surd => sub(mul(m[i], N[j]), mul(m[j], N[i]));
    const w = [minor(1, 2), minor(2, 0), minor(0, 1)];
    if (q.shape.kind === 'circle') return sqrt(div(w.map(sqr).reduce(add), sqr(rate)));
    const places = w.filter((_, i) => i !== axis).map((x) => div(x, rate));
    if (places.some((x) => sign(x) < 0)) return null;
    const [u, v] = places as [Surd, Surd];
    return sign(add(u, neg(v))) > 0 ? u : v;
  }

  test.each([
    ['circle', 'circle', 'radius'],
    ['square', 'square', 'side'],
  ])('between two doubles: %s', (id, kind, key) => {
    const asked = many(id, kind, 80, 106).filter((q) => {
      const at = thresholdOf(q);
      return at !== null && expectFlipAt(q, key, at, 'none', 'one');
    });
    expect(asked.length).toBeGreaterThan(30);
  });
});
