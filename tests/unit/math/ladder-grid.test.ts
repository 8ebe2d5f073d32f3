import { describe, expect, test } from 'vitest';
import {
  createAnswers,
  packRays,
  verdictsOfClasses,
  verdictsOfRoots,
} from '../../../src/math/batch/batch.ts';
import { batchOf } from '../../../src/math/batch/kernels.ts';
import { nextDown, nextUp } from '../../../src/math/float/ulp.ts';
import { certified } from '../../../src/math/methods/certified.ts';
import { exact } from '../../../src/math/methods/exact.ts';
import { interval } from '../../../src/math/methods/interval.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { many } from '../many.ts';
import { disagreement } from './against-exact.ts';

/*
 * Small whole numbers, all of them: E from (0, 0, −2) to (3, 3, 3), every d from −2 to 2 up to its
 * sign, about a centre that is not 0; `exact` is asked some of these rays by each shape,
 * the next shape the next ones, and `certified` all of them. What the answer must be is found here
 * in whole numbers that doubles hold exactly, so `exact` is not compared with anything of its own.
 * No rounding anywhere also means that `interval` must decide, and rightly.
 */

const range = (low: number, high: number): number[] =>
  Array.from({ length: high - low + 1 }, (_, i) => low + i);
const triples = (xs: number[], ys: number[], zs: number[]): Vec3[] =>
  xs.flatMap((x) => ys.flatMap((y) => zs.map((z): Vec3 => [x, y, z])));

const ORIGINS = triples(range(0, 3), range(0, 3), range(-2, 3));
const SMALL = range(-2, 2);
/** One of d and −d each. */
const DIRECTIONS = triples(SMALL, SMALL, SMALL).filter(
  ([x, y, z]) => x > 0 || (x === 0 && (y > 0 || (y === 0 && z > 0))),
);
const CENTER: Vec3 = [1, -1, 2];
const rays: Ray[] = ORIGINS.flatMap((p) =>
  DIRECTIONS.map((direction) => ({
    origin: [p[0] + CENTER[0], p[1] + CENTER[1], p[2] + CENTER[2]] as Vec3,
    direction,
  })),
);

/** Every seventh ray, in `npm test` fewer, beginning with another one for each shape. */
const thin = (k: number, step = many(4) === 4 ? 7 : 17): Ray[] =>
  rays.filter((_, i) => i % step === k % step);

interface Expected {
  readonly class: string;
  /**
   * Correctly rounded: quotients of small whole numbers, or (−B ± √D) / 2A with D no square, to a
   * few ulps.
   */
  readonly roots: readonly number[];
  readonly rational: boolean;
}

/** 4(A t² + B t + C), in whole numbers. */
function curved(a4: number, r: number, { origin, direction: d }: Ray): Expected {
  const [px, py, pz] = origin.map((x, i) => x - (CENTER[i] as number)) as [number, number, number];
  const A = 4 * (d[0] * d[0] + d[2] * d[2]) - a4 * d[1] * d[1];
  const B = 8 * (d[0] * px + d[2] * pz) - 2 * a4 * d[1] * py;
  const C = 4 * (px * px + pz * pz - r * r) - a4 * py * py;
  if (A === 0) {
    if (B !== 0) return { class: 'one', roots: [-C / B], rational: true };
    return { class: C === 0 ? 'contained' : 'none', roots: [], rational: true };
  }
  const D = B * B - 4 * A * C;
  if (D < 0) return { class: 'none', roots: [], rational: true };
  if (D === 0) return { class: 'tangent', roots: [-B / (2 * A)], rational: true };
  const s = Math.sqrt(D);
  const roots = [(-B - s) / (2 * A), (-B + s) / (2 * A)].sort((t, u) => t - u);
  return { class: 'two', roots, rational: Math.round(s) ** 2 === D };
}

function agrees(shape: Shape, ray: Ray, expected: Expected): boolean {
  const found = exact.intersect(shape, ray);
  if (found.class !== expected.class || found.hits.length !== expected.roots.length) return false;
  return found.hits.every(({ t }, i) => {
    const want = expected.roots[i] as number;
    return expected.rational
      ? t === want
      : Math.abs(t - want) <= 1e-13 * Math.max(1, Math.abs(want));
  });
}

const cylinder = (radius: number): Shape => ({ kind: 'cylinder', center: CENTER, radius });
const cone = (slope: number): Shape => ({ kind: 'cone', vertex: CENTER, slope });
const hyperboloid = (flare: number, radius: number): Shape => ({
  kind: 'hyperboloid',
  center: CENTER,
  flare,
  radius,
});

const CURVED: [name: string, shape: Shape, a4: number, r: number][] = [
  ...range(0, 2).map((r): [string, Shape, number, number] => [
    `cylinder r = ${r}`,
    cylinder(r),
    0,
    r,
  ]),
  ...[0, 0.5, -1, 2].map((c): [string, Shape, number, number] => [
    `cone c = ${c}`,
    cone(c),
    4 * c * c,
    0,
  ]),
  ...[-4, -1, 0, 1, 4].flatMap((a4) =>
    [0, 1, 2].map((r): [string, Shape, number, number] => [
      `hyperboloid a = ${a4 / 4}, r = ${r}`,
      hyperboloid(a4 / 4, r),
      a4,
      r,
    ]),
  ),
];

describe(`some of ${rays.length} rays at each curved shape`, () => {
  test.each(CURVED.map((one, k) => [...one, k] as const))('%s', (_, shape, a4, r, k) => {
    const wrong = thin(k).filter((ray) => !agrees(shape, ray, curved(a4, r, ray)));
    expect(wrong).toEqual([]);
  });

  test('every class is among them', () => {
    const seen = new Set(
      CURVED.flatMap(([, , a4, r]) => rays.map((ray) => curved(a4, r, ray).class)),
    );
    expect([...seen].sort()).toEqual(['contained', 'none', 'one', 'tangent', 'two']);
  });

  test('interval decides some of them, and rightly', () => {
    for (const [k, [name, shape, a4, r]] of CURVED.entries()) {
      for (const ray of thin(k, many(4) === 4 ? 19 : 41)) {
        const got = interval.intersect(shape, ray).class;
        if (got !== curved(a4, r, ray).class)
          expect([name, ray, got]).toBe(curved(a4, r, ray).class);
      }
    }
  });
});

const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** `inside` is asked of w = (X − P)·(N·d) and N·d, all whole. */
function flat(N: Vec3, ray: Ray, inside: (w: Vec3, rate: number) => boolean): Expected {
  const p = minus(ray.origin, CENTER);
  const rate = dot(N, ray.direction);
  const offset = dot(N, p);
  if (rate === 0) return { class: offset === 0 ? 'contained' : 'none', roots: [], rational: true };
  const at = (i: 0 | 1 | 2): number => p[i] * rate - ray.direction[i] * offset;
  const hit = inside([at(0), at(1), at(2)], rate);
  return { class: hit ? 'one' : 'none', roots: hit ? [-offset / rate + 0] : [], rational: true };
}

const NORMALS: Vec3[] = [
  [0, 1, 0],
  [2, 0, 0],
  [1, 0, -1],
  [1, 2, 2],
];
const AXES = ['x', 'y', 'z'] as const;
type Inside = (w: Vec3, rate: number) => boolean;

const FLAT: [name: string, shape: Shape, N: Vec3, inside: Inside][] = [
  ...NORMALS.map((normal): [string, Shape, Vec3, Inside] => [
    `plane N = ${normal}`,
    { kind: 'plane', normal, point: CENTER },
    normal,
    () => true,
  ]),
  ...NORMALS.flatMap((normal) =>
    range(0, 3).map((radius): [string, Shape, Vec3, Inside] => [
      `circle N = ${normal}, r = ${radius}`,
      { kind: 'circle', normal, center: CENTER, radius },
      normal,
      (w, rate) => dot(w, w) <= radius * radius * rate * rate,
    ]),
  ),
  ...AXES.flatMap((axis, n) =>
    range(0, 2).map((side): [string, Shape, Vec3, Inside] => [
      `square ⟂ ${axis}, L = ${side}`,
      { kind: 'square', corner: CENTER, side, axis },
      [0, 1, 2].map((i) => (i === n ? 1 : 0)) as unknown as Vec3,
      (w, rate) =>
        w.every((x, i) => i === n || (x * rate >= 0 && Math.abs(x) <= side * Math.abs(rate))),
    ]),
  ),
];

describe(`certified at every one of ${rays.length} rays`, () => {
  const packed = packRays(rays);
  const out = createAnswers(rays.length);

  /**
   * What the batch gets wrong: each class, by roots and by `classes`, and each root that is a
   * quotient of whole numbers.
   */
  function wrongInBatch(shape: Shape, expected: (ray: Ray) => Expected): unknown[] {
    const kernel = batchOf(certified, shape);
    if (!kernel) throw new Error(`no kernel for ${shape.kind}`);
    kernel.classes(packed, out);
    const byClass = verdictsOfClasses(out, rays.length, kernel.met);
    kernel.both(packed, out);
    const byRoots = verdictsOfRoots(out, rays.length);
    return rays.filter((ray, i) => {
      const { class: verdict, roots, rational } = expected(ray);
      const got = [out.t0[i] as number, out.t1[i] as number].slice(0, roots.length);
      const right = got.every((t, k) => !rational || besides(t, roots[k] as number));
      return byClass[i] !== verdict || byRoots[i] !== verdict || !right;
    });
  }

  /**
   * A quotient of whole numbers below 2^20, rounded, and the neighbours of it: unless it is a
   * double, and that it is if it has few bits.
   */
  function besides(t: number, rounded: number): boolean {
    if (Math.fround(rounded) === rounded) return Object.is(t, rounded + 0);
    return t === rounded || t === nextUp(rounded) || t === nextDown(rounded);
  }

  test.each(CURVED.map((one, k) => [...one, k] as const))(
    '%s: every class, and some of the roots to the two doubles around each',
    (_, shape, a4, r, k) => {
      expect(wrongInBatch(shape, (ray) => curved(a4, r, ray))).toEqual([]);
      expect(
        thin(k)
          .map((ray) => disagreement(shape, ray))
          .filter(Boolean),
      ).toEqual([]);
    },
  );

  test.each(FLAT.map((one, k) => [...one, k] as const))(
    '%s: every class, and some of the roots to the two doubles around each',
    (_, shape, N, inside, k) => {
      expect(wrongInBatch(shape, (ray) => flat(N, ray, inside))).toEqual([]);
      expect(
        thin(k)
          .map((ray) => disagreement(shape, ray))
          .filter(Boolean),
      ).toEqual([]);
    },
  );
});

describe(`some of ${rays.length} rays at each flat shape`, () => {
  test.each(FLAT.map((one, k) => [...one, k] as const))('%s', (_, shape, N, inside, k) => {
    const wrong = thin(k).filter((ray) => !agrees(shape, ray, flat(N, ray, inside)));
    expect(wrong).toEqual([]);
  });

  test('interval decides some of them, and rightly', () => {
    for (const [k, [name, shape, N, inside]] of FLAT.entries()) {
      for (const ray of thin(k, many(4) === 4 ? 19 : 41)) {
        const got = interval.intersect(shape, ray).class;
        const want = flat(N, ray, inside).class;
        if (got !== want) expect([name, ray, got]).toBe(want);
      }
    }
  });
});
