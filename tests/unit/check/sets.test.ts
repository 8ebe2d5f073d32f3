import { describe, expect, test } from 'vitest';
import { pose } from '../../../src/check/compose.ts';
import type { Level } from '../../../src/check/exercises/define.ts';
import { EARLIER, EXERCISES, findExercise } from '../../../src/check/exercises/index.ts';
import { plan, question, studentSeed } from '../../../src/check/session.ts';
import {
  isSet,
  LATEST_SET,
  partsOf,
  SETS,
  setId,
  setOf,
  setProblem,
} from '../../../src/check/sets.ts';
import { SHAPES } from '../../../src/math/index.ts';
import { many } from '../many.ts';

/** What seeds of the first set posed when it was published: exercise and shape, in order. */
const PUBLISHED: Readonly<Record<string, string>> = {
  '0':
    'flat:circle flat:square flat:plane coefficients:cone discriminant:hyperboloid ' +
    'roots:cylinder first:cone point:hyperboloid parallel:plane nappes:cone ' +
    'normal:hyperboloid shadow:cylinder linear:cone crossing:hyperboloid tangent:cylinder ' +
    'digits:cone',
  '1':
    'flat:square flat:plane flat:circle coefficients:hyperboloid discriminant:cylinder ' +
    'roots:cone first:hyperboloid point:cylinder parallel:circle nappes:cone ' +
    'normal:cylinder shadow:cone linear:hyperboloid crossing:cylinder tangent:cone ' +
    'digits:hyperboloid',
  '2':
    'flat:plane flat:circle flat:square coefficients:cylinder discriminant:cone ' +
    'roots:hyperboloid first:cylinder point:cone parallel:square nappes:cone normal:cone ' +
    'shadow:hyperboloid linear:cylinder crossing:cone tangent:hyperboloid digits:cylinder',
  '3':
    'flat:plane flat:circle flat:square coefficients:cylinder discriminant:cone ' +
    'roots:hyperboloid first:cylinder point:cone parallel:square nappes:cone normal:cone ' +
    'shadow:hyperboloid linear:cylinder crossing:cone tangent:hyperboloid digits:cylinder',
  '7':
    'flat:circle flat:square flat:plane coefficients:cone discriminant:hyperboloid ' +
    'roots:cylinder first:cone point:hyperboloid parallel:plane nappes:cone ' +
    'normal:hyperboloid shadow:cylinder linear:cone crossing:hyperboloid tangent:cylinder ' +
    'digits:cone',
  '41':
    'flat:plane flat:circle flat:square coefficients:cylinder discriminant:cone ' +
    'roots:hyperboloid first:cylinder point:cone parallel:square nappes:cone normal:cone ' +
    'shadow:hyperboloid linear:cylinder crossing:cone tangent:hyperboloid digits:cylinder',
  '55':
    'flat:square flat:plane flat:circle coefficients:hyperboloid discriminant:cylinder ' +
    'roots:cone first:hyperboloid point:cylinder parallel:circle nappes:cone ' +
    'normal:cylinder shadow:cone linear:hyperboloid crossing:cylinder tangent:cone ' +
    'digits:hyperboloid',
  '123':
    'flat:plane flat:circle flat:square coefficients:cylinder discriminant:cone ' +
    'roots:hyperboloid first:cylinder point:cone parallel:square nappes:cone normal:cone ' +
    'shadow:hyperboloid linear:cylinder crossing:cone tangent:hyperboloid digits:cylinder',
  '999999999':
    'flat:plane flat:circle flat:square coefficients:cylinder discriminant:cone ' +
    'roots:hyperboloid first:cylinder point:cone parallel:square nappes:cone normal:cone ' +
    'shadow:hyperboloid linear:cylinder crossing:cone tangent:hyperboloid digits:cylinder',
  '-5':
    'flat:square flat:plane flat:circle coefficients:hyperboloid discriminant:cylinder ' +
    'roots:cone first:hyperboloid point:cylinder parallel:circle nappes:cone ' +
    'normal:cylinder shadow:cone linear:hyperboloid crossing:cylinder tangent:cone ' +
    'digits:hyperboloid',
};

describe('the first set', () => {
  test.each(Object.entries(PUBLISHED))('seed %s poses what it always posed', (seed, expected) => {
    const said = plan(Number(seed)).map(({ exercise, kind }) => `${exercise}:${kind}`);
    expect(said.join(' ')).toBe(expected);
  });
});

test('the latest set has every exercise and asks about every shape', () => {
  const { shapes, turns } = setOf(LATEST_SET);
  expect(turns.map(({ exercise }) => exercise).sort()).toEqual(
    EXERCISES.map(({ id }) => id).sort(),
  );
  expect([...shapes].sort()).toEqual(SHAPES.map(({ kind }) => kind).sort());
  const asked = new Set(turns.flatMap(({ kinds }) => kinds));
  expect([...asked].sort()).toEqual(SHAPES.map(({ kind }) => kind).sort());
});

describe('what a set’s id adds', () => {
  test('comes in turn where it can be asked about, and at the end', () => {
    const plain = setOf('1');
    const { shapes, turns } = setOf('1,sphere,paraboloid');
    expect(shapes).toEqual([...plain.shapes, 'sphere', 'paraboloid']);
    for (const [i, { exercise, times, kinds }] of turns.entries()) {
      const before = plain.turns[i];
      const asked = findExercise(exercise)?.kinds ?? [];
      const added = (['sphere', 'paraboloid'] as const).filter((kind) => asked.includes(kind));
      expect({ exercise, times, kinds }).toEqual({
        ...before,
        kinds: [...(before?.kinds ?? []), ...added],
      });
    }
    expect(setOf('1')).toEqual(SETS[1]);
  });

  test.each([
    '99',
    '1,cone',
    '1,sphere,sphere',
    '1,',
    '1,torus',
    ',sphere',
    '2,__proto__',
    '1,roots',
  ])('%s is no set', (id) => {
    expect(isSet(id)).toBe(false);
    expect(() => setOf(id)).toThrow(RangeError);
  });
});

test.each([...new Set([...Object.keys(SETS), LATEST_SET, '1,sphere'])])(
  'set %s: every slot of seeds 1 to 4 can be posed',
  (set) => {
    for (let seed = 1; seed <= 4; seed++) {
      plan(seed, set).forEach((slot, i) => {
        expect(question(seed, i, set).draft.shape.kind).toBe(slot.kind);
      });
    }
  },
);

const OWN = 'roots*3,normal*2;shapes=cone,sphere;level=2;hints=off';

describe('a set that is made of exercises', () => {
  test('has what its text says, for every seed', () => {
    expect(setOf(OWN)).toMatchObject({ shapes: ['cone', 'sphere'], level: 2, withoutHints: true });
    for (let seed = 1; seed <= 50; seed++) {
      const slots = plan(seed, OWN);
      expect(
        slots
          .map(({ exercise }) => exercise)
          .sort()
          .join(' '),
      ).toBe('normal normal roots roots roots');
      expect(new Set(slots.map(({ level }) => level))).toEqual(new Set([2]));
      const kinds = slots.filter(({ exercise }) => exercise === 'normal').map(({ kind }) => kind);
      expect(kinds.sort()).toEqual(['cone', 'sphere']);
    }
  });

  test('poses what it posed when the first links were handed out', () => {
    const said = plan(41, OWN).map(({ exercise, kind }, i) => {
      const { ray } = question(41, i, OWN).draft;
      return `${exercise}:${kind} ${[...ray.origin, ...ray.direction].join(',')}`;
    });
    expect(said).toMatchInlineSnapshot(`
      [
        "normal:cone -6,4,-3,-2,1,-1",
        "normal:sphere 0,0,3,0,3,-1",
        "roots:cone 1,4,2,2,-2,-3",
        "roots:cone 1,-4,-5,2,1,-3",
        "roots:sphere -4,0,3,1,0,-1",
      ]
    `);
  });

  test('its text comes back from its parts', () => {
    const { base, chosen } = partsOf(OWN);
    expect(setId(base, chosen)).toBe(OWN);
  });

  test.each([
    ['nappes;shapes=sphere', 'nappes cannot be asked about sphere'],
    ['roots*0', 'how often'],
    ['roots;seed=4', "a set has no 'seed'"],
    ['', "there is no exercise ''"],
    ['roots*1*2', 'how often'],
  ])('%s is refused in words', (id, words) => {
    expect(setProblem(id)).toContain(words);
  });
});

describe('the balance of 1,000 seeded sets', () => {
  const SEEDS = 1000;
  const ids = [...Object.keys(SETS), OWN].filter((id) => setOf(id).spread);

  test.each(ids)('%s: no class of answers is wanted too often, and no order is usual', (id) => {
    const wanted = new Map<string, Map<string, number>>();
    const firsts = new Map<string, number>();
    for (let seed = 0; seed < SEEDS; seed++) {
      const slots = plan(seed * 7 + 1, id);
      const [first] = slots;
      firsts.set(first?.exercise ?? '', (firsts.get(first?.exercise ?? '') ?? 0) + 1);
      for (const {
        exercise,
        kind,
        wanted: [one],
      } of slots) {
        if (one === undefined) continue;
        const key = `${exercise} ${kind}`;
        const counts = wanted.get(key) ?? new Map<string, number>();
        counts.set(one, (counts.get(one) ?? 0) + 1);
        wanted.set(key, counts);
      }
    }
    for (const [key, counts] of wanted) {
      const total = [...counts.values()].reduce((a, b) => a + b);
      const most = Math.max(...counts.values()) / total;
      if (counts.size >= 3) expect(most, key).toBeLessThanOrEqual(0.45);
      if (counts.size === 2) expect(most, key).toBeLessThanOrEqual(0.6);
    }
    const share = setOf(id).turns.map(({ times }) => times);
    const usual = Math.max(...share) / share.reduce((a, b) => a + b);
    expect(Math.max(...firsts.values()) / SEEDS).toBeLessThan(usual + 0.06);
  });

  const spread = EXERCISES.filter((one) => one.spread).map((one) => [one.id, one] as const);

  test.each(spread)('%s: each class that is wanted is posed, of every shape', (_, one) => {
    const { classes = [], without = {}, of } = one.spread ?? {};
    const missed: string[] = [];
    for (const kind of one.kinds) {
      for (const wanted of classes.filter((each) => !without[kind]?.includes(each))) {
        for (let seed = 1; seed <= many(12); seed++) {
          const { draft, truth } = pose(one, kind, seed, ((seed % 3) + 1) as Level, [wanted]);
          const is = of?.(draft, truth);
          if (is !== wanted) missed.push(`${kind}, seed ${seed}: ${is} for ${wanted}`);
        }
      }
    }
    expect(missed).toEqual([]);
  });
});

/** Words that say of the ray what may be true of its line alone. */
const RAY_MEETS = /(?<!line of )the ray (first )?(meets|does|comes)/;

describe('the line and the ray', () => {
  const all = [...EXERCISES, ...EARLIER];

  test.each(all.map((one) => [one.id, one] as const))('%s: a ray meets where t ≥ 0', (_, one) => {
    for (let seed = 1; seed <= 24; seed++) {
      const kind = one.kinds[seed % one.kinds.length];
      if (!kind) throw new RangeError('no shapes');
      const { draft, fields, truth } = pose(one, kind, seed, 2);
      const words = one.ask(draft);
      const ts = fields.flatMap(({ id }) => (/^t\d?$/.test(id) ? [truth[id]] : []));
      const behind = ts.some((t) => typeof t === 'number' && t < 0);
      const why = `${one.id}, seed ${seed}: t < 0 is on the line of the ray, not on the ray`;
      if (behind) expect(words, why).not.toMatch(RAY_MEETS);
    }
  });
});

describe('own numbers for each student', () => {
  test('come from a name or number and the seed, and from nothing else', () => {
    expect(studentSeed(41, '')).toBe(41);
    expect(studentSeed(41, ' Ada  LOVELACE ')).toBe(studentSeed(41, 'ada lovelace'));
    expect(studentSeed(41, 'A\u030asa')).toBe(studentSeed(41, '\u00e5sa'));
    expect(studentSeed(41, 'ada')).not.toBe(studentSeed(42, 'ada'));
    expect(studentSeed(41, '4711')).toMatchInlineSnapshot(`538011059`);
  });

  test('are another for each of 10,000', () => {
    const seeds = Array.from({ length: 10_000 }, (_, i) => studentSeed(41, String(i)));
    expect(new Set(seeds).size).toBeGreaterThan(9_998);
    expect(seeds.every((seed) => seed >= 0 && seed < 1e9)).toBe(true);
  });
});
