import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { plan } from '../../../src/check/session.ts';
import { FIRST_SET, LATEST_SET, SETS } from '../../../src/check/sets.ts';
import { SHAPES } from '../../../src/math/index.ts';
import { kindsFor } from '../../../src/pages/check/program-run.ts';
import { PARTS, readSettings, settingsFor, settingsOf } from '../../../src/pages/check/settings.ts';

const withoutNulls = (texts: Readonly<Record<string, string | null>>): Record<string, string> =>
  Object.fromEntries(
    Object.entries(texts).filter((pair): pair is [string, string] => pair[1] !== null),
  );

describe('the settings of the page Check', () => {
  test('come back from the link as they went in, 500 runs', () => {
    const sets = [...Object.keys(SETS), LATEST_SET, '1,sphere,paraboloid'];
    const any = fc.constantFrom(...sets).chain((set) =>
      fc.record({
        part: fc.constantFrom(...PARTS.map(({ id }) => id)),
        set: fc.constant(set),
        seed: fc.integer({ min: -999_999_999, max: 999_999_999 }),
        question: fc.integer({ min: 0, max: plan(1, set).length - 1 }),
        cases: fc.constantFrom('all', ...SHAPES.map(({ kind }) => kind)),
      }),
    );
    fc.assert(
      fc.property(any, (wanted) => {
        const texts = withoutNulls(settingsFor(wanted));
        expect(readSettings(texts)).toEqual({ settings: texts, problems: [] });
        expect(settingsOf(texts)).toEqual(wanted);
      }),
      { numRuns: 500, seed: 7 },
    );
  });

  test('defaults are left out', () => {
    expect(settingsFor(settingsOf({}))).toEqual({
      part: null,
      set: null,
      seed: null,
      question: null,
      cases: null,
    });
  });

  test.each([...Object.keys(SETS), LATEST_SET, '1,sphere'])(
    'every session of set %s has as many questions: a link to one is good for every seed',
    (set) => {
      const lengths = Array.from({ length: 200 }, (_, seed) => plan(seed - 100, set).length);
      expect([...new Set(lengths)]).toEqual([plan(1, set).length]);
    },
  );

  test('a link without a set, and one with a set that there is not, open the first', () => {
    expect(settingsOf({ seed: '41' }).set).toBe(FIRST_SET);
    const { settings, problems } = readSettings({ set: '77', seed: '41' });
    expect(settings).toEqual({ seed: '41' });
    expect(problems).toEqual([
      `opened without set: '77' is not a set of questions ` +
        `(${Object.keys(SETS).join(', ')}), so set 1 is opened`,
    ]);
  });

  test('how many questions there are depends on the set', () => {
    const last = String(plan(1, LATEST_SET).length);
    expect(readSettings({ set: LATEST_SET, question: last }).problems).toEqual([]);
    expect(readSettings({ question: last }).problems).toHaveLength(1);
  });

  test('all cases are those of the set’s shapes', () => {
    expect(kindsFor('all', FIRST_SET)).toEqual(SETS[FIRST_SET]?.shapes);
    expect(kindsFor('all', LATEST_SET)).toEqual(SHAPES.map(({ kind }) => kind));
    expect(kindsFor('sphere', FIRST_SET)).toEqual(['sphere']);
  });

  test.each([
    [{ seed: 'abc' }, "'abc' is not a whole number"],
    [{ seed: '1e99' }, "'1e99'"],
    [{ question: '0' }, "'0' is not a question from 1"],
    [{ question: '999' }, "'999'"],
    [{ set: '__proto__' }, "'__proto__' is not a set"],
    [{ part: '<img>' }, "'<img>' is not questions"],
    [{ cases: 'torus' }, "'torus' is not a shape"],
    [{ constructor: '1' }, "'constructor' means nothing"],
    [{ toString: 'x' }, "'toString' means nothing"],
  ])('%j is said and left out', (given, words) => {
    const { settings, problems } = readSettings(given as unknown as Record<string, string>);
    expect(settings).toEqual({});
    expect(problems.join()).toContain(words);
    expect(settingsOf(given as unknown as Record<string, string>)).toEqual(settingsOf({}));
  });
});
