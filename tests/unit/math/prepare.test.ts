import { describe, expect, test } from 'vitest';
import { exact as exactly } from '../../../src/math/arithmetic/exact.ts';
import { packRays } from '../../../src/math/batch/batch.ts';
import { compare, fromNumber, type Surd } from '../../../src/math/exact/surd.ts';
import {
  FAMILIES,
  type Family,
  type Question,
  type Random,
  seeded,
} from '../../../src/math/families.ts';
import { nextDown, nextUp } from '../../../src/math/float/ulp.ts';
import {
  createHit,
  firstAmong,
  intersect,
  METHODS,
  type PreparedHit,
  prepare,
  prepareWith,
  type Ray,
  SHAPES,
  type Shape,
} from '../../../src/math/index.ts';
import { pick } from '../../../src/math/rng.ts';
import type { ShapeDefinition } from '../../../src/math/shapes/define.ts';
import { sideOf } from '../../../src/math/side.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { unlikeAll } from '../../fuzz/unlike.ts';
import { type ExactHit, exactHits, faithful, straight } from './exact-hits.ts';
import { wild } from './wild.ts';

const WHOLE = { tMin: Number.NEGATIVE_INFINITY } as const;
const SEED = 31;

/** What is not right about a hit, in words; null where all of it is. */
function wrongIn({ t, point, normal, singular }: PreparedHit, truth: ExactHit): string | null {
  if (!faithful(truth.t, t)) return `t ${t}`;
  const off = point.findIndex((x, i) => !faithful(truth.point[i] as Surd, x));
  if (off >= 0) return `point ${point}`;
  const zero = truth.normal.every((n) => exactly.sign(n) === 0);
  const inRange = normal.every(Number.isFinite) && Math.hypot(...normal) > 1e-290;
  const upright = zero ? singular : !inRange || straight(truth.normal, normal);
  return upright ? null : `normal ${normal}`;
}

/** What `all` gets wrong of the whole line; null where nothing is. */
function wrong({ shape, ray }: Question, hits: readonly PreparedHit[]): string | null {
  const truth = exactHits(shape, ray);
  const said =
    hits.length === truth.hits.length
      ? hits.map((hit, k) => wrongIn(hit, truth.hits[k] as ExactHit)).find((one) => one !== null)
      : `${hits.length} hits`;
  return said ? `${said} of ${JSON.stringify({ shape, ray })}` : null;
}

const PER_FAMILY = 25;

const familyOf = (id: string): Family => FAMILIES().find((one) => one.id === id) as Family;

describe('every root of the whole line, with point and normal', () => {
  test.each(FAMILIES().map(({ id }) => id))(`of the family %s (seed ${SEED})`, (id) => {
    const random = seeded(SEED);
    const questions = Array.from({ length: PER_FAMILY }, () => familyOf(id).make(random));
    const found = questions.map((one) => wrong(one, prepare(one.shape, WHOLE).all(one.ray)));
    expect(found.filter((one) => one !== null)).toEqual([]);
  });

  test(`of numbers of any size (seed ${SEED})`, () => {
    const found = wild(SEED, 400).map((one) => wrong(one, prepare(one.shape, WHOLE).all(one.ray)));
    expect(found.filter((one) => one !== null)).toEqual([]);
  });

  test('by the shapes that were imported alone, and by no others', () => {
    const random = seeded(SEED);
    const typical = FAMILIES().find(({ id }) => id === 'typical');
    for (const entry of SHAPES as unknown as readonly ShapeDefinition<Shape>[]) {
      const prepareOne = prepareWith(entry);
      const { shape, ray } = questionOf(entry.kind, random, typical?.make);
      expect(wrong({ shape, ray }, prepareOne(shape, WHOLE).all(ray))).toBe(null);
      const other = entry.kind === 'sphere' ? 'cone' : 'sphere';
      expect(() => prepareOne({ ...shape, kind: other } as never)).toThrow(
        `unknown shape '${other}'`,
      );
    }
  });
});

/** A question about this kind: of the family, or of the shape that its sliders begin with. */
function questionOf(kind: string, random: Random, make: ((r: Random) => Question) | undefined) {
  for (let tries = 0; make && tries < 60; tries++) {
    const question = make(random);
    if (question.shape.kind === kind) return question;
  }
  const entry = SHAPES.find((one) => one.kind === kind);
  const own = entry?.params.map(({ key, initial }) => [key, initial]) ?? [];
  const shape = { kind, ...Object.fromEntries(own) } as Shape;
  return { shape, ray: { origin: [3, 2, 1], direction: [-1, -0.5, -0.25] } as Ray };
}

/** Ends of an interval that are, or nearly are, a root; and others. */
function limitsNear(roots: readonly number[], random: Random): readonly [number, number] {
  const near = roots.flatMap((t) => [t, nextUp(t), nextDown(t), 2 * t]);
  const any = [...near, 0, -1, 1, Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY];
  const [a, b] = [pick(random, any as [number]), pick(random, any as [number])];
  return a < b ? [a, b] : [b, a];
}

describe('the first hit of an interval', () => {
  test(`is the first of all hits, to the bit (seed ${SEED})`, () => {
    const random = seeded(SEED);
    const questions = FAMILIES().flatMap(({ make }) => [make(random), make(random), make(random)]);
    const found = [...questions, ...wild(SEED, 60)].map(unlikeAll);
    expect(found.filter((one) => one !== null)).toEqual([]);
  });

  test.each(FAMILIES().map(({ id }) => id))(
    `is the first exact root in it: the family %s (seed ${SEED})`,
    (id) => {
      const random = seeded(SEED);
      const out = createHit();
      for (let i = 0; i < PER_FAMILY; i++) {
        const { shape, ray } = familyOf(id).make(random);
        const truth = exactHits(shape, ray).hits;
        const doubles = intersect(shape, ray).hits.map(({ t }) => t);
        const [tMin, tMax] = limitsNear(doubles.filter(Number.isFinite), random);
        const isIn = ({ t }: ExactHit): boolean =>
          (tMin === Number.NEGATIVE_INFINITY || compare(t, fromNumber(tMin)) >= 0) &&
          (tMax === Number.POSITIVE_INFINITY || compare(t, fromNumber(tMax)) <= 0);
        const wanted = tMin === Infinity || tMax === -Infinity ? undefined : truth.find(isIn);
        const one = prepare(shape, { tMin, tMax });
        const found = one.first(ray);
        const what = JSON.stringify({ shape, ray, tMin, tMax });
        expect(found ? wanted && wrongIn(found, wanted) : (wanted ?? null), what).toBe(null);
        expect(one.any(ray), what).toBe(wanted !== undefined);
        expect(one.first(ray, out), what).toEqual(found);
        const ts = new Float64Array(1);
        one.firsts(packRays([ray]), ts);
        expect(ts[0], what).toBe(found?.t ?? Number.NaN);
      }
    },
  );

  test('of several shapes is the nearest one', () => {
    const balls = [5, 2, 8].map((x) => prepare({ kind: 'sphere', center: [x, 0, 0], radius: 1 }));
    const ray = { origin: [0, 0, 0], direction: [1, 0, 0] } as const;
    expect(firstAmong(balls, ray)).toMatchObject({ index: 1, hit: { t: 1 } });
    expect(firstAmong(balls, { ...ray, direction: [-1, 0, 0] })).toBe(null);
  });
});

test('a ray that starts on the surface does not meet it there again', () => {
  const random = seeded(SEED);
  for (let i = 0; i < 300; i++) {
    const { shape, ray } = familyOf('on-surface').make(random);
    const wanted = intersect(shape, ray, 'certified', { from: shape }).hits.map(({ t }) => t);
    const found = prepare(shape, { ...WHOLE, from: shape }).all(ray);
    expect(found.length).toBe(wanted.length);
    found.forEach(({ t }, k) => {
      const next = wanted[k] as number;
      expect([nextDown(next), next, nextUp(next)]).toContain(t);
    });
  }
});

describe('inside', () => {
  /** Points on the surface as doubles have it, and their neighbours. */
  function pointsNear(ray: Ray, shape: Shape, random: Random): Vec3[] {
    return intersect(shape, ray).hits.flatMap(({ point }) => {
      const axis = pick(random, [0, 1, 2]);
      const moved = (by: (x: number) => number): Vec3 =>
        point.map((x, i) => (i === axis ? by(x) : x)) as unknown as Vec3;
      return [point, moved(nextUp), moved(nextDown), moved((x) => x + 1)];
    });
  }

  test(`is told by the exact sign (seed ${SEED})`, () => {
    const random = seeded(SEED);
    for (const family of FAMILIES()) {
      const { shape, ray } = family.make(random);
      const one = prepare(shape);
      for (const point of [ray.origin, ...pointsNear(ray, shape, random)]) {
        if (!point.every(Number.isFinite)) continue;
        const side = sideOf(shape, point);
        expect([one.side(point), one.inside(point)]).toEqual([side, side !== null && side <= 0]);
      }
    }
  });

  test('ends where a shape ends, and takes no point that is none', () => {
    const can = prepare({ kind: 'cylinder', center: [0, 0, 0], radius: 1, between: [0, 2] });
    const sides = [-0.001, 0, 1, 2, 2.001].map((y) => can.side([0.5, y, 0]));
    expect(sides).toEqual([1, 0, -1, 0, 1]);
    expect(can.inside([1, 1, 0])).toBe(true);
    expect(() => can.inside([0, Number.NaN, 0])).toThrow('point.y must be a finite number');
  });
});

test('every method answers, with its own roots', () => {
  const shape = { kind: 'cone', vertex: [0, 1, 0], slope: 0.5 } as const;
  const ray = { origin: [4, 0.3, 0.1], direction: [-1, 0.01, 0.02] } as const;
  for (const { id } of METHODS) {
    const found = prepare(shape, { ...WHOLE, method: id }).all(ray);
    const wanted = intersect(shape, ray, id).hits;
    if (id === 'certified') continue;
    expect(found).toEqual(wanted.map((hit) => ({ ...hit, fate: 'hit' })));
  }
});

describe('what is refused', () => {
  const ball = { kind: 'sphere', center: [0, 0, 0], radius: 1 } as const;
  const ray = { origin: [0, 0, 0], direction: [1, 0, 0] } as const;

  test.each([
    [() => prepare({ ...ball, radius: -1 }), 'radius must be ≥ 0, got -1'],
    [() => prepare(undefined as never), 'kind is missing'],
    [() => prepare({ ...ball, kind: 'torus' as never }), "unknown shape 'torus'"],
    [() => prepare(ball, { tMin: Number.NaN }), 'tMin must be a number, got NaN'],
    [() => prepare(ball, { method: 'newton' }), "unknown method 'newton'"],
    [() => prepare(ball, { tmin: 1 } as never), "'tmin' means nothing for a set of options"],
    [() => prepare(ball).first({ ...ray, origin: [0, Number.NaN, 0] }), 'origin.y must be'],
    [() => prepare(ball).any({ ...ray, direction: [0, 0, 0] }), 'direction must not be zero'],
    [() => prepare(ball).all({} as never), 'origin'],
  ])('%#', (ask, words) => {
    expect(ask).toThrow(words);
  });

  test('a shape that changes later changes nothing', () => {
    const center: [number, number, number] = [0, 0, 0];
    const one = prepare({ kind: 'sphere', center, radius: 1 });
    center[0] = 100;
    expect(one.first({ origin: [-3, 0, 0], direction: [1, 0, 0] })?.t).toBe(2);
    expect(one.side([0, 0, 0])).toBe(-1);
  });
});
