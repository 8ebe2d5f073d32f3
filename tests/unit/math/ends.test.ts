import { describe, expect, test } from 'vitest';
import { exact } from '../../../src/math/arithmetic/exact.ts';
import {
  add,
  compare,
  div,
  fromNumber,
  mul,
  type Surd,
  sub,
} from '../../../src/math/exact/surd.ts';
import { FAMILIES, type Question, type Random, seeded } from '../../../src/math/families.ts';
import { nextDown, nextUp } from '../../../src/math/float/ulp.ts';
import { evaluate } from '../../../src/math/formula/evaluate.ts';
import {
  type Ends,
  type Fate,
  intersect,
  METHODS,
  prepare,
  type Ray,
  type Shape,
} from '../../../src/math/index.ts';
import { valuesOf } from '../../../src/math/methods/tree-method.ts';
import { pick } from '../../../src/math/rng.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';
import { exactHits, faithful } from './exact-hits.ts';

/*
 * Shapes with ends, against a second opinion: roots, heights and discs compared as exact numbers,
 * put into order by them.
 */

interface Met {
  readonly t: Surd;
  readonly fate: Fate;
}

/** What the line meets, as the rules say it: rims and edges belong, and are the surface's. */
function met(shape: Shape, ray: Ray, [low, high]: readonly [number, number], caps: boolean): Met[] {
  const { class: verdict, hits } = exactHits(shape, ray);
  const n = fromNumber;
  const roots = hits.map(({ t, point: [, y] }): Met => {
    const inside = compare(y, n(low)) >= 0 && compare(y, n(high)) <= 0;
    return { t, fate: inside ? 'hit' : 'cut' };
  });
  const [, Ey] = ray.origin;
  const [, dy] = ray.direction;
  const ends = !caps || dy === 0 ? [] : [low, high];
  const discs = ends.flatMap((h): Met[] => {
    const t = div(sub(n(h), n(Ey)), n(dy));
    const side = exact.sign(fAt(shape, ray, t, h));
    const isRim = side === 0 && verdict !== 'contained';
    return side > 0 || isRim ? [] : [{ t, fate: 'cap' }];
  });
  return [...roots, ...discs].sort((a, b) => compare(a.t, b.t));
}

/** f at the point of the line at t, whose height is h: C of a ray from there. */
function fAt(shape: Shape, ray: Ray, t: Surd, h: number): Surd {
  const formula = definitionOf(shape).formula(shape);
  if (formula.family !== 'curved') throw new RangeError('only curved shapes have ends');
  const values = valuesOf(shape, ray, exact);
  const along = (axis: 0 | 2): Surd =>
    add(fromNumber(ray.origin[axis]), mul(t, fromNumber(ray.direction[axis])));
  const E = [along(0), fromNumber(h), along(2)] as const;
  const at = { scalars: values.scalars, vectors: { ...values.vectors, E } };
  return evaluate(formula.C, exact, at);
}

/** Heights that are those of roots, their neighbours, E's, the shape's own, and others. */
function heightsNear({ shape, ray }: Question, random: Random): readonly [number, number] {
  const ys = intersect(shape, ray).hits.map(({ point }) => point[1]);
  const { at, size } = definitionOf(shape).anchor(shape);
  const near = [...ys, ray.origin[1], at[1], at[1] + size, at[1] - size];
  const all = [...near.flatMap((y) => [y, nextUp(y), nextDown(y)]), -1, 0, 2].filter(
    (y) => Number.isFinite(y) && Math.abs(y) < 1e300,
  );
  const [a, b] = [pick(random, all as [number]), pick(random, all as [number])];
  if (a === b) return [a, a + 1 + Math.abs(a)];
  return a < b ? [a, b] : [b, a];
}

const CURVED = FAMILIES().filter(({ make }) => {
  const { shape } = make(seeded(1));
  return definitionOf(shape).formula(shape).family === 'curved';
});

const SEED = 43;
const PER_FAMILY = 40;

describe.each([true, false])('with caps: %s', (caps) => {
  test.each(CURVED.map(({ id }) => id))(
    `every fate is that of exact arithmetic: the family %s (seed ${SEED})`,
    (id) => {
      const random = seeded(SEED);
      const family = CURVED.find((one) => one.id === id);
      for (let i = 0; i < PER_FAMILY; i++) {
        const question = family?.make(random) ?? expect.fail(id);
        const { shape, ray } = question;
        if (definitionOf(shape).formula(shape).family !== 'curved') continue;
        const between = heightsNear(question, random);
        const solid = { ...shape, between, caps };
        const wanted = met(shape, ray, between, caps);
        const whole = { tMin: Number.NEGATIVE_INFINITY };
        const said = [
          intersect(solid, ray).hits,
          intersect(solid, ray, 'exact').hits,
          prepare(solid, whole).all(ray),
        ];
        const what = JSON.stringify({ solid, ray });
        for (const hits of said) {
          expect(
            hits.map(({ fate }) => fate),
            what,
          ).toEqual(wanted.map(({ fate }) => fate));
          hits.forEach(({ t, point, normal, fate }, k) => {
            expect(faithful(wanted[k]?.t as Surd, t), `${t} in ${what}`).toBe(true);
            if (fate !== 'cap') return;
            expect([point[1], Math.abs(normal[1])]).toEqual([
              normal[1] < 0 ? between[0] : between[1],
              1,
            ]);
          });
        }
        const first = wanted.find(({ fate, t }) => fate !== 'cut' && exact.sign(t) >= 0);
        expect(prepare(solid).first(ray)?.fate, what).toBe(first?.fate);
        expect(prepare(solid).any(ray), what).toBe(first !== undefined);
      }
    },
  );
});

const can = { kind: 'cylinder', center: [0, 0, 0], radius: 5, between: [-1, 2] } as const;
const closed = { ...can, caps: true } as const;
const fates = (solid: Shape & Ends, ray: Ray, method?: string): unknown[] =>
  intersect(solid, ray, method).hits.map(({ t, fate }) => [t, fate]);

describe('rims and edges belong to the shape', () => {
  test('a root on an edge is a hit, and stands for the disc that ends there', () => {
    const along = { origin: [-10, 2, 0], direction: [1, 0, 0] } as const;
    expect(fates(closed, along)).toEqual([
      [5, 'hit'],
      [15, 'hit'],
    ]);
    const slanted = { origin: [-10, 7, 0], direction: [1, -1, 0] } as const;
    expect(fates(closed, slanted)).toEqual([
      [5, 'hit'],
      [8, 'cap'],
      [15, 'cut'],
    ]);
  });

  test('a line along a generator goes through both rims, where discs are', () => {
    const generator = { origin: [5, 0, 0], direction: [0, 2, 0] } as const;
    expect(intersect(closed, generator).class).toBe('contained');
    expect(fates(closed, generator)).toEqual([
      [-0.5, 'cap'],
      [1, 'cap'],
    ]);
    expect(fates(can, generator)).toEqual([]);
  });

  test('an end at a vertex is a point, and the root there a hit', () => {
    const cone = {
      kind: 'cone',
      vertex: [0, 0, 0],
      slope: 1,
      between: [0, 1],
      caps: true,
    } as const;
    const through = { origin: [0, -1, 0], direction: [0, 1, 0] } as const;
    expect(fates(cone, through)).toEqual([
      [1, 'hit'],
      [2, 'cap'],
    ]);
  });
});

test('the class is that of the line and the whole surface', () => {
  const above = { origin: [-10, 9, 0], direction: [1, 0, 0] } as const;
  expect(intersect(closed, above).class).toBe('two');
  expect(fates(closed, above)).toEqual([
    [5, 'cut'],
    [15, 'cut'],
  ]);
  expect(prepare(closed).any(above)).toBe(false);
  expect(intersect(can, above).details).toEqual(
    intersect({ kind: 'cylinder', center: [0, 0, 0], radius: 5 }, above).details,
  );
});

test('a ray that starts on a solid does not meet it there again, on its caps neither', () => {
  const down = { origin: [1, 2, 0], direction: [0, -1, 0] } as const;
  expect(intersect(closed, down, 'certified', { from: closed })).toMatchObject({
    hits: [{ t: 3, fate: 'cap' }],
    dropped: { t: 0, fate: 'cap' },
  });
  expect(prepare(closed, { from: closed }).first(down)).toMatchObject({ t: 3, fate: 'cap' });
  // The nearer root is cut off: no ray starts there.
  const up = { origin: [5, 2, 0], direction: [-1, 1, 0] } as const;
  expect(prepare(can, { tMin: -Infinity, from: can }).all(up)).toMatchObject([
    { t: 10, fate: 'cut' },
  ]);
});

test('every method has fates, by its own numbers where it is not exact', () => {
  const ray = { origin: [-10, 7.25, 0.5], direction: [1, -0.875, 0] } as const;
  const wanted = intersect(closed, ray).hits.map(({ fate }) => fate);
  expect(wanted).toEqual(['cut', 'cap', 'cap', 'cut']);
  for (const { id } of METHODS) {
    if (intersect(closed, ray, id).class === 'undecided') continue;
    expect(intersect(closed, ray, id).hits.map(({ fate }) => fate)).toEqual(wanted);
  }
});

test('ends that are inherited, or undefined, are none', () => {
  const ray = { origin: [-10, 9, 0], direction: [1, 0, 0] } as const;
  const { between: _, ...bare } = can;
  const heir = Object.assign(Object.create({ between: [0, 1] }), bare);
  const whole = intersect(bare, ray).hits;
  expect(intersect(heir, ray).hits).toEqual(whole);
  expect(intersect({ ...bare, between: undefined, caps: undefined }, ray).hits).toEqual(whole);
});

describe('what is refused', () => {
  const plane = { kind: 'plane', normal: [0, 1, 0], point: [0, 0, 0] } as const;
  const ray = { origin: [0, 0, 0], direction: [1, 0, 0] } as const;

  test.each([
    [{ ...plane, between: [0, 1] }, "'between' means nothing for a plane, which has normal, point"],
    [{ ...plane, caps: true }, "'caps' means nothing for a plane, which has normal, point"],
    [{ ...can, between: [2, -1] }, 'between must go up, got (2, -1)'],
    [{ ...can, between: [1, 1] }, 'between must go up, got (1, 1)'],
    [{ ...can, between: [0] }, 'between must be two heights, got (0)'],
    [{ ...can, between: [0, Number.POSITIVE_INFINITY] }, 'between must be two finite heights'],
    [{ ...can, between: 3 }, 'between must be two heights, got 3'],
    [{ ...can, between: undefined, caps: true }, "'caps' needs 'between', which is missing"],
    [{ ...can, caps: 1 }, 'caps must be true or false, got 1'],
    [{ ...can, radius: -1 }, 'radius must be ≥ 0, got -1'],
    [{ ...can, heights: 1 }, "'heights' means nothing for a cylinder"],
  ])('%#', (solid, words) => {
    expect(() => intersect(solid as never, ray)).toThrow(words);
    expect(() => prepare(solid as never)).toThrow(words);
  });
});
