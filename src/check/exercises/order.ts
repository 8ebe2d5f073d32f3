import { DISCRIMINANT, num, ROOTS } from '../../math/formula.ts';
import type { Shape, Vec3 } from '../../math/index.ts';
import { integer, pick, type Random } from '../../math/rng.ts';
import { AXES, definitionOf, type ShapeKind } from '../../math/shapes.ts';
import { display, displayTriple } from '../../text/format.ts';
import { type Course, type CurvedCourse, courseOf } from '../course.ts';
import { type Answers, choiceField, type Input, numberField } from '../types.ts';
import { roughWork, work } from '../work.ts';
import type { Draft, Exercise, Told } from './define.ts';
import {
  drawInput,
  drawShape,
  drawUntil,
  hasUnitLength,
  kindsOf,
  numberOf,
  shuffled,
  withTwoCleanRoots,
} from './draw.ts';

/** Shapes for the second surface: those that there were when the exercise began. */
const OTHERS: readonly ShapeKind[] = ['cylinder', 'cone', 'hyperboloid', 'sphere', 'paraboloid'];

/** A hit of the first surface is an a, one of the second a b: 'abba' is in through both and out. */
type Order = string;

/** All orders of so many a's and b's. */
function orders(a: number, b: number): Order[] {
  if (a === 0 || b === 0) return [`${'a'.repeat(a)}${'b'.repeat(b)}`];
  return [
    ...orders(a - 1, b).map((rest) => `a${rest}`),
    ...orders(a, b - 1).map((rest) => `b${rest}`),
  ];
}

interface Met {
  readonly t: number;
  readonly of: 'a' | 'b';
}

/** The four roots as the student has them; null if one does not exist. */
function hitsOf(draft: Draft, course: Course, own: Answers): readonly Met[] | null {
  // The roots of the first surface are given.
  const found = work(courseOf(draft.shape), draft, own);
  const ts = [numberOf(found, 't1'), numberOf(found, 't2')];
  const other = otherRoots(draft, course);
  const ss = ['s1', 's2'].map((id, i) => {
    const typed = own[id];
    return typeof typed === 'number' && Number.isFinite(typed) ? typed : (other?.[i] ?? Number.NaN);
  });
  if ([...ts, ...ss].some(Number.isNaN)) return null;
  return [...ts.map((t): Met => ({ t, of: 'a' })), ...ss.map((t): Met => ({ t, of: 'b' }))];
}

/** The second surface by the same, perhaps mistaken, formulas for D and the roots. */
function otherRoots({ other, ray }: Draft, course: Course): readonly [number, number] | null {
  if (!other) return null;
  const plain = courseOf(other);
  if (plain.family === 'flat' || course.family === 'flat') return null;
  const { D, roots, double, linear, rules } = course;
  const found = work({ ...plain, D, roots, double, linear, rules }, { shape: other, ray });
  const pair = [numberOf(found, 't1'), numberOf(found, 't2')] as const;
  return pair.some(Number.isNaN) ? null : pair;
}

function orderOf(hits: readonly Met[], { rules, meetings }: Course): Order {
  const seen = hits
    .filter(({ t }) => t >= 0 || rules.behind === 'accepted')
    .sort((x, y) => x.t - y.t);
  const [first] = seen;
  const sorted =
    meetings === 'by surface'
      ? [...seen.filter(({ of }) => of === first?.of), ...seen.filter(({ of }) => of !== first?.of)]
      : seen;
  return sorted.map(({ of }) => of).join('');
}

/** How the two pairs of roots lie. */
function placeOf(all: readonly Met[]): (typeof PLACES)[number] {
  const ahead = all.filter(({ t }) => t > 0);
  if (ahead.length < all.length) return 'partly behind E';
  const order = [...all]
    .sort((x, y) => x.t - y.t)
    .map(({ of }) => of)
    .join('');
  if (/^(aabb|bbaa)$/.test(order)) return 'apart';
  return /^(abab|baba)$/.test(order) ? 'overlapping' : 'one within the other';
}

const PLACES = ['apart', 'overlapping', 'one within the other', 'partly behind E'] as const;

const titlesOf = ({ shape, other }: Draft): Readonly<Record<string, string>> => ({
  a: definitionOf(shape).title,
  b: other ? definitionOf(other).title : '',
});

const words = (order: Order, draft: Draft): string =>
  order === '' ? 'neither is met' : [...order].map((of) => titlesOf(draft)[of]).join(', ');

/** Numbers of the second shape, and its A, B and C. */
function told({ other, ray }: Draft): Told[] {
  if (!other) return [];
  const { title, params } = definitionOf(other);
  const numbers = other as unknown as Readonly<Record<string, unknown>>;
  const own = params.map(({ key, symbol }) => {
    const value = numbers[key];
    const said = Array.isArray(value) ? displayTriple([value[0], value[1], value[2]]) : '';
    return `${symbol} = ${typeof value === 'number' ? display(value) : said}`;
  });
  const found = roughWork(courseOf(other), { shape: other, ray });
  const abc = ['A', 'B', 'C'].map((id) => `${id} = ${display(numberOf(found, id))}`);
  return [
    { name: `the ${title}`, says: own.join(', ') },
    { name: `for the ${title}`, says: abc.join(', ') },
  ];
}

const EVERYWHERE = ['lost-minus', 'over-a'];

/** How far the second surface is moved along the ray, in lengths of d. */
const STEPS = Array.from({ length: 25 }, (_, i) => i - 12);

const drawRay = (random: Random, direction: Vec3): Input['ray'] => ({
  origin: [integer(random, -3, 3), integer(random, -3, 3), integer(random, -3, 3)],
  direction,
});

/** The shape with its points elsewhere. */
function movedBy(shape: Shape, by: readonly number[]): Shape {
  const numbers = shape as unknown as Readonly<Record<string, unknown>>;
  const points = definitionOf(shape).params.flatMap(({ key, type }) => {
    const point = numbers[key];
    return type === 'vector' && Array.isArray(point)
      ? [[key, point.map((x: number, i) => x + (by[i] ?? 0))] as const]
      : [];
  });
  return { ...shape, ...Object.fromEntries(points) } as Shape;
}

const hitsIn = (draft: Draft): readonly Met[] => hitsOf(draft, courseOf(draft.shape), {}) ?? [];

const of =
  (surface: 'a' | 'b') =>
  (t: number): Met => ({ t, of: surface });

const rootsOf = (input: Input): readonly number[] => {
  const found = roughWork(courseOf(input.shape), input);
  return [numberOf(found, 't1'), numberOf(found, 't2')];
};

/** Two roots count as one below this distance: other clean ones are at least 1/100 apart. */
const APART = 1e-6;

const isFit = (all: readonly Met[]): boolean =>
  all.some(({ t }) => t > 0) &&
  all.every(
    ({ t }, i) =>
      Math.abs(t) > APART && all.slice(0, i).every((other) => Math.abs(other.t - t) > APART),
  );

/** Largest coordinate of the second surface's point. */
const FARTHEST = 20;

const isNear = ({ other }: Draft): boolean =>
  (other ? definitionOf(other).anchor(other).at : []).every((x) => Math.abs(x) <= FARTHEST);

export const order: Exercise = {
  id: 'order',
  topic: 'the order of hits of two shapes',
  paper: true,
  kinds: kindsOf('curved'),
  spread: {
    classes: PLACES,
    of: (draft) => placeOf(hitsIn(draft)),
  },
  draw(random, kind, level, wanted) {
    const input = drawUntil(
      () => drawInput(random, kind, level),
      (drawn) => !hasUnitLength(drawn.ray.direction) && withTwoCleanRoots(drawn) !== null,
    );
    if (!input) return null;
    const [next, ...more] = OTHERS.filter((one) => !Object.is(one, kind)) as [
      ShapeKind,
      ...ShapeKind[],
    ];
    const second = pick(random, [next, ...more]);
    const { direction } = input.ray;
    const found = drawUntil(
      (): Input => ({ shape: drawShape(random, second, 1), ray: drawRay(random, direction) }),
      (drawn) => withTwoCleanRoots(drawn) !== null,
    );
    if (!found) return null;
    // Moved onto the ray, and along it by k lengths of d, the second surface has its roots k later.
    const [ts, ss] = [rootsOf(input), rootsOf(found)];
    const place = wanted ?? pick(random, PLACES);
    const fits = (k: number): boolean => {
      const all = [...ts.map(of('a')), ...ss.map((s) => of('b')(s + k))];
      return isFit(all) && placeOf(all) === place;
    };
    const k = shuffled(random, STEPS).find(fits);
    if (k === undefined) return null;
    const by = AXES.map(
      (_, i) => (input.ray.origin[i] ?? 0) - (found.ray.origin[i] ?? 0) + k * (direction[i] ?? 0),
    );
    const draft: Draft = { ...input, other: movedBy(found.shape, by), watch: [] };
    if (!isNear(draft)) return null;
    const own: Readonly<Record<string, readonly string[]>> = {
      overlapping: ['by-surface'],
      'one within the other': ['by-surface'],
      'partly behind E': ['behind'],
    };
    return { ...draft, watch: [...EVERYWHERE, ...(own[place] ?? [])] };
  },
  ask(draft) {
    const { a, b } = titlesOf(draft);
    return (
      `The roots of the ${a} are given. Find those of the ${b}, s₁ < s₂, and say in which order ` +
      `the ray, from E on, goes through the two surfaces.`
    );
  },
  given: ['t1', 't2'],
  told,
  extend: (course) => ({ ...course, meetings: 'by t' }),
  fields(draft) {
    const hits = hitsIn(draft);
    const seen = (surface: 'a' | 'b'): number =>
      hits.filter((one) => one.of === surface && one.t > 0).length;
    const all = [...new Set([...orders(seen('a'), seen('b')), ...orders(2, 2)])];
    return [
      numberField('s1', 's₁'),
      numberField('s2', 's₂'),
      choiceField(
        'order',
        'in turn it meets',
        all.map((id) => ({ id, title: words(id, draft) })),
      ),
    ];
  },
  answers(course, draft, own = {}) {
    const hits = hitsOf(draft, course, own);
    const other = otherRoots(draft, course);
    if (!hits || !other) return {};
    return { s1: other[0], s2: other[1], order: orderOf(hits, course) };
  },
  argue(draft) {
    const { b } = titlesOf(draft);
    const hits = hitsIn(draft);
    const { other, ray } = draft;
    const found = other ? work(courseOf(other), { shape: other, ray }) : {};
    const [A, B, D] = ['A', 'B', 'D'].map((id) => display(numberOf(found, id)));
    const sorted = [...hits].sort((x, y) => x.t - y.t);
    const all = sorted.map(({ t, of }) => `${display(t)} (${titlesOf(draft)[of]})`).join(' < ');
    const back = sorted.filter(({ t }) => t < 0).map(({ t }) => display(t));
    const so = words(orderOf(hits, courseOf(draft.shape)), draft);
    return {
      rule: 's = (−B ± √D)/2A with D = B² − 4AC; then all t ≥ 0 in one order.',
      put: `For the ${b} D = ${D}, 2A = 2 · (${A}) and −B = −(${B}): which four t are there?`,
      decision: [
        `For the ${b} D = ${D}.`,
        `${all}.`,
        back.length > 0
          ? `${back.join(' and ')} ${back.length > 1 ? 'are' : 'is'} behind E. From E on: ${so}.`
          : `All are in front of E: ${so}.`,
      ],
    };
  },
  stack(course, draft) {
    const own = draft.other ? (courseOf(draft.other) as CurvedCourse) : null;
    const found = own && draft.other ? work(own, { shape: draft.other, ray: draft.ray }) : {};
    const right = course.family === 'curved' ? course : null;
    return {
      scalars: {},
      trees: [
        ...(['A', 'B', 'C'] as const).map((id) => [id, num(numberOf(found, id))] as const),
        ['D', right?.D ?? DISCRIMINANT],
      ],
      pair: { letters: ['s1', 's2'], tree: right?.roots ?? ROOTS },
    };
  },
  clue: 'A ray goes through whatever comes next: only the t decide, whosever they are.',
  lines: [],
};
