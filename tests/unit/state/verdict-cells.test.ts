import { describe, expect, test } from 'vitest';
import { FAMILIES } from '../../../src/math/families.ts';
import { intersect, METHODS } from '../../../src/math/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { seeded } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Comparison } from '../../../src/state/verdict-parts.ts';
import * as table from '../../../src/state/verdict-table.ts';
import { hitWords, verdictWords } from '../../../src/state/verdict-words.ts';
import {
  at,
  type Course,
  courseOf,
  DRAWS,
  dot,
  drawRay,
  figurePlace,
  flatOf,
  less,
  quadricOf,
} from './ray-oracle.ts';

/*
 * Every sentence of the table, on rays of small numbers, against facts that are found without
 * src/math. A sentence is cut into phrases; each phrase has a fact, and nothing of a sentence may
 * be left over.
 */

type Fact<T> = (course: T, match: RegExpMatchArray, shape: Shape, ray: Ray) => boolean;
type Facts<T> = readonly (readonly [RegExp, Fact<T>])[];

const same = (a: readonly unknown[], b: readonly unknown[]): boolean => a.join() === b.join();
const roots = (c: Course): number => c.behind.length + c.ahead.length + (c.atE ? 1 : 0);
const isDouble = (c: Course): boolean => c.A !== 0 && c.D === 0;
const doubleAt = (c: Course): number => -c.B / (2 * c.A);

function gradientAt(shape: Shape, ray: Ray, t: number): number[] {
  const q = quadricOf(shape);
  if (!q) return [];
  const [x, y, z] = less(at(ray, t), q.C);
  return [x, -q.a * y - (q.k ?? 0) / 2, z];
}

const singular = (c: Course, shape: Shape, ray: Ray): boolean =>
  gradientAt(shape, ray, doubleAt(c)).every((g) => g === 0);

const CURVED: Facts<Course> = [
  [/^two points/, (c) => c.A !== 0 && c.D > 0 && roots(c) === 2],
  [/both behind E/, (c) => c.behind.length === 2],
  [/one behind E/, (c) => c.behind.length === 1],
  [/the ray enters, then leaves/, (c) => same(c.ahead, ['enters', 'leaves'])],
  [/the ray leaves, then enters again/, (c) => same(c.ahead, ['leaves', 'enters'])],
  [
    /the ray enters at E itself, then leaves/,
    (c) => c.atE === 'enters' && same(c.ahead, ['leaves']),
  ],
  [
    /the ray leaves at E itself, then enters again/,
    (c) => c.atE === 'leaves' && same(c.ahead, ['enters']),
  ],
  [/(one at )?E itself, where the ray (enters|leaves)/, (c, [, , how]) => c.atE === how],
  [/E is inside, the ray leaves/, (c) => c.C < 0 && same(c.ahead, ['leaves'])],
  [/one(?: point,)? where the ray enters/, (c) => same(c.ahead, ['enters'])],
  [/one point, behind E/, (c) => c.A === 0 && roots(c) === 1 && c.behind.length === 1],
  [/one point/, (c) => c.A === 0 && roots(c) === 1],
  [/the ray( itself)? misses/, (c) => c.atE === null && c.ahead.length === 0 && c.C > 0],
  [
    /(the ray stays )?(in|out)side for ever/,
    (c, [, , side]) =>
      c.ahead.length === 0 &&
      [c.signs.after, c.signs.end].every((s) => s === (side === 'in' ? -1 : 1)),
  ],
  [/tangent from inside/, (c, _, s, r) => isDouble(c) && c.A < 0 && !singular(c, s, r)],
  [/tangent/, (c, _, s, r) => isDouble(c) && c.A > 0 && !singular(c, s, r)],
  [/one double root/, isDouble],
  [/the ray touches and stays inside/, (c) => doubleAt(c) > 0 && c.signs.end < 0],
  [/and the ray stays inside/, (c) => c.signs.after < 0 && c.signs.end < 0],
  [/the ray touches/, (c) => doubleAt(c) >= 0],
  [/at E itself, then/, (c) => isDouble(c) && c.atE === 'touches'],
  [/at E itself/, (c) => isDouble(c) && c.atE === 'touches'],
  [/behind E/, (c) => isDouble(c) && doubleAt(c) < 0],
  [/inside before and after it/, (c) => c.signs.before < 0 && c.signs.end < 0 && doubleAt(c) > 0],
  [/no normal there/, (c, _, s, r) => singular(c, s, r)],
  [
    /through the (vertex|axis|centre)/,
    (c, [, place], shape, ray) => {
      const q = quadricOf(shape);
      const [x, y, z] = less(at(ray, doubleAt(c)), q?.C ?? [0, 0, 0]);
      if (place === 'axis') return x === 0 && z === 0 && q?.a === 0 && q.rho === 0;
      return x === 0 && y === 0 && z === 0 && (q?.a ?? 0) > 0 === (place === 'vertex');
    },
  ],
  [
    /parallel to a generator/,
    (_, __, shape, { direction: [x, y, z] }) => {
      const a = quadricOf(shape)?.a ?? 0;
      return a > 0 && y !== 0 && x * x + z * z === a * y * y;
    },
  ],
  [/parallel to the axis/, (_, __, ___, { direction: [x, , z] }) => x === 0 && z === 0],
  [/no (root|point)/, (c) => roots(c) === 0 && !(c.A === 0 && c.B === 0 && c.C === 0)],
  [
    /the whole line lies in the surface|the line is the axis itself/,
    (_, [words], shape, ray) => {
      const q = quadricOf(shape);
      if (!q) return false;
      const course = [-2, -1, 0, 1, 2].every(
        (t) => courseOf(q, ray).C === 0 && fAt(shape, ray, t) === 0,
      );
      return course && words.includes('axis') === (q.a === 0 && q.rho === 0);
    },
  ],
  [/every t is a root/, (c) => c.A === 0 && c.B === 0 && c.C === 0],
];

function fAt(shape: Shape, ray: Ray, t: number): number {
  const q = quadricOf(shape);
  return q ? courseOf(q, { ...ray, origin: at(ray, t) }).C : Number.NaN;
}

interface Flat {
  readonly offset: number;
  readonly rate: number;
}

const meets = (c: Flat, ray: Ray) => at(ray, -c.offset / c.rate);
const lies = (c: Flat): boolean => c.offset === 0 && c.rate === 0;
const number = (text: string | undefined): number =>
  Number((text ?? '').replace('−', '-').replace(/ · 10.*$/, ''));
const close = (a: number, b: number): boolean => Math.abs(a - b) <= 1e-5 * Math.max(1, Math.abs(b));
const isIn = (shape: Shape, x: readonly [number, number, number]): boolean =>
  figurePlace(shape, x).off <= 3e-5;

const FLAT: Facts<Flat> = [
  [/^one point/, (c, _, s, r) => c.rate !== 0 && figurePlace(s, meets(c, r)).off === 0],
  [/inside the (circle|square)/, (c, _, s, r) => figurePlace(s, meets(c, r)).limits === 0],
  [
    /on the rim, which belongs to the circle/,
    (c, _, s, r) => s.kind === 'circle' && figurePlace(s, meets(c, r)).limits === 1,
  ],
  [
    /on an edge, which belongs to the square/,
    (c, _, s, r) => s.kind === 'square' && figurePlace(s, meets(c, r)).limits === 1,
  ],
  [
    /at a corner, which belongs to the square/,
    (c, _, s, r) => figurePlace(s, meets(c, r)).limits === 2,
  ],
  [
    /the centre, all that is left of the circle/,
    (_, __, s) => s.kind === 'circle' && s.radius === 0,
  ],
  [/the corner, all that is left of the square/, (_, __, s) => s.kind === 'square' && s.side === 0],
  [
    /the plane is met ([\d.]+) outside the (circle|square)/,
    (c, [, far], s, r) => c.rate !== 0 && close(number(far), figurePlace(s, meets(c, r)).off),
  ],
  [/no point$/, (c, _, s, r) => !lies(c) && (c.rate === 0 || figurePlace(s, meets(c, r)).off > 0)],
  [/parallel to the plane, beside it/, (c) => c.rate === 0 && c.offset !== 0],
  [/the line lies in the plane/, lies],
  [/no single point/, (c, _, s) => lies(c) && s.kind === 'plane'],
  [
    /and in the (?:circle|square) from t = (\S+) to t = ([^\s,]+)/,
    (_, [, a, b], s, r) => {
      const [from, to] = [number(a), number(b)];
      const inside = [from, (from + to) / 2, to].every((t) => isIn(s, at(r, t)));
      return from < to && inside && [from - 1e-3, to + 1e-3].every((t) => !isIn(s, at(r, t)));
    },
  ],
  [
    /and touches the (?:circle|square) at t = ([^\s,]+)/,
    (_, [, a], s, r) =>
      isIn(s, at(r, number(a))) && [-0.1, 0.1].every((by) => !isIn(s, at(r, number(a) + by))),
  ],
  [
    /and passes beside the (circle|square): no point of it/,
    (_, __, s, r) => GRID.every((t) => !isIn(s, at(r, t))),
  ],
  [/starting at E itself/, (_, __, s, r) => isIn(s, r.origin) && !isIn(s, at(r, -1e-3))],
  [/ending at E itself/, (_, __, s, r) => isIn(s, r.origin) && !isIn(s, at(r, 1e-3))],
  [/at E itself/, (c, _, s, r) => (lies(c) ? isIn(s, r.origin) : c.offset === 0)],
  [/E in between/, (_, __, s, r) => [-1e-3, 0, 1e-3].every((t) => isIn(s, at(r, t)))],
  [
    /(all of it )?behind E/,
    (c, _, s, r) => (lies(c) ? AHEAD.every((t) => !isIn(s, at(r, t))) : -c.offset / c.rate < 0),
  ],
];

const GRID = Array.from({ length: 1601 }, (_, i) => (i - 800) / 64);
const AHEAD = GRID.filter((t) => t >= 0);

/** Each phrase that was said and is not so; and what no fact covers. */
function wrong<T>(text: string, facts: Facts<T>, course: T, shape: Shape, ray: Ray): string[] {
  let left = text;
  const faults: string[] = [];
  for (const [pattern, holds] of facts) {
    const match = left.match(pattern);
    if (!match) continue;
    left = left.replace(match[0], '');
    if (!holds(course, match, shape, ray)) faults.push(`not so: ${match[0]}`);
  }
  const rest = left.replace(/[\s,:;]/g, '');
  return rest === '' ? faults : [...faults, `nothing holds this: ${left}`];
}

/** All that is wrong with what is said of one ray. */
function faultsOf(shape: Shape, ray: Ray, method: string, said: Set<string>): string[] {
  const found = intersect(shape, ray, method);
  const { relations, text } = verdictWords(found, shape, ray);
  said.add(text.replace(/−?[\d.]+/g, '#'));
  const q = quadricOf(shape);
  if (q) {
    const course = courseOf(q, ray);
    return [
      ...wrong(text, CURVED, course, shape, ray),
      ...wrongRelations(relations, { ...course }),
      ...wrongHits(found, course),
    ];
  }
  const { N, P } = flatOf(shape) ?? { N: [0, 0, 0], P: [0, 0, 0] };
  const course = { offset: dot(N, less(ray.origin, P)), rate: dot(N, ray.direction) };
  // Where the plane is met must be a double.
  if (shape.kind !== 'plane' && ![0, 1, 2, 4].includes(Math.abs(course.rate))) return [];
  const values = { 'N.d': course.rate, 'N.(E-P)': course.offset };
  return [...wrong(text, FLAT, course, shape, ray), ...wrongRelations(relations, values)];
}

/** The relations in symbols, all of them with 0. */
function wrongRelations(relations: readonly Comparison[], values: object): string[] {
  const holds: Record<string, (x: number) => boolean> = {
    '=': (x) => x === 0,
    '≠': (x) => x !== 0,
    '<': (x) => x < 0,
    '>': (x) => x > 0,
  };
  return relations
    .filter(
      ({ left, relation }) =>
        !holds[relation]?.((values as Record<string, number>)[left] ?? Number.NaN),
    )
    .map(({ left, relation }) => `not so: ${left} ${relation} 0`);
}

/** Behind E, at E or ahead of it, and whether the ray enters or leaves there. */
function wrongHits(found: ReturnType<typeof intersect>, c: Course): string[] {
  if (isDouble(c)) return [];
  const expected = [
    ...c.behind.map(() => 'behind E'),
    ...(c.atE && found.hits.length > 0 ? [`E itself, ${c.atE}`] : []),
    ...c.ahead.map((how, i) => (i === 0 && c.atE === null ? `first hit, ${how}` : how)),
  ];
  const got = hitWords(found).map(({ text }) => text);
  return same(got, expected) ? [] : [`hits: ${got.join('; ')} and not ${expected.join('; ')}`];
}

const N = 2500;
const said = new Set<string>();

describe.each(Object.keys(DRAWS))('%s', (kind) => {
  test(`whatever is said of ${N} rays is so (seed 5)`, () => {
    const random = seeded(5);
    const faults: string[] = [];
    for (let i = 0; i < N; i++) {
      const shape = DRAWS[kind]?.(random);
      if (!shape) continue;
      const ray = drawRay(random, shape);
      const here = faultsOf(shape, ray, i % 4 === 0 ? 'exact' : 'certified', said);
      faults.push(...here.map((fault) => `${JSON.stringify({ shape, ray })}: ${fault}`));
    }
    expect(faults.slice(0, 5)).toEqual([]);
  });
});

test('every cell of the table was reached', () => {
  const places = ['the vertex', 'the axis', 'the centre'];
  const cells = [
    ...Object.values(table.TWO).flatMap(Object.values),
    ...Object.values(table.TOUCHES).flatMap(Object.values),
    ...places.flatMap((place) => Object.values(table.SINGULAR['+'](place))),
    ...Object.values(table.SINGULAR['-']('the vertex')),
    ...Object.values(table.ONE).flatMap(Object.values),
    ...Object.values(table.NONE),
    ...Object.values(table.CONSTANT),
    ...Object.values(table.WHERE).map((where) => `one point${where}`),
    ...Object.values(table.STRETCH).map((stretch) => `from t = # to t = #${stretch}`),
    'at a corner',
    'on an edge',
    'on the rim',
    'all that is left of the circle',
    'all that is left of the square',
  ];
  const all = [...said];
  expect(cells.filter((cell) => !all.some((text) => text.includes(cell)))).toEqual([]);
});

test('of every family of hard rays certified says what exact arithmetic says (seed 7)', () => {
  const random = seeded(7);
  const saidBy = (shape: Shape, ray: Ray, method: string): string => {
    const found = intersect(shape, ray, method);
    const { relations, text } = verdictWords(found, shape, ray);
    const hits = hitWords(found).map((hit) => hit.text);
    // Faithful numbers may differ in their last digit.
    return JSON.stringify([relations, text, hits]).replace(/−?[\d.]+( · 10[⁻⁰-⁹¹²³]+)?/g, '#');
  };
  const faults: string[] = [];
  for (const family of FAMILIES()) {
    for (let i = 0; i < 20; i++) {
      const { shape, ray } = family.make(random);
      const [certified, exact] = ['certified', 'exact'].map((m) => saidBy(shape, ray, m));
      if (certified !== exact)
        faults.push(`${JSON.stringify({ shape, ray })}: ${certified} ${exact}`);
      for (const { id } of METHODS) {
        const words = saidBy(shape, ray, id);
        if (/undefined|NaN/.test(words))
          faults.push(`${id} ${JSON.stringify({ shape, ray })}: ${words}`);
      }
    }
  }
  expect(faults.slice(0, 5)).toEqual([]);
});
