import { describe, expect, test } from 'vitest';
import { EXERCISES } from '../../../src/check/exercises/index.ts';
import { plan, question } from '../../../src/check/session.ts';
import { isSet, LATEST_SET, SETS, setOf } from '../../../src/check/sets.ts';
import { SHAPES } from '../../../src/math/index.ts';

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
      const asked = EXERCISES.find(({ id }) => id === exercise)?.kinds ?? [];
      const added = (['sphere', 'paraboloid'] as const).filter((kind) => asked.includes(kind));
      expect({ exercise, times, kinds }).toEqual({
        ...before,
        kinds: [...(before?.kinds ?? []), ...added],
      });
    }
    expect(setOf('1')).toEqual(SETS[1]);
  });

  test.each([
    '3',
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

test.each([...Object.keys(SETS), LATEST_SET, '1,sphere'])(
  'set %s: every slot of seeds 1 to 4 can be posed',
  (set) => {
    for (let seed = 1; seed <= 4; seed++) {
      plan(seed, set).forEach((slot, i) => {
        expect(question(seed, i, set).draft.shape.kind).toBe(slot.kind);
      });
    }
  },
);
