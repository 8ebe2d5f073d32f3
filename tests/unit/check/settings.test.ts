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
    const own = ['roots*3,normal*2', 'roots*3;shapes=cone,sphere;level=2;hints=off', '2;hints=off'];
    const sets = [...Object.keys(SETS), LATEST_SET, '1,sphere,paraboloid', ...own];
    const any = fc.constantFrom(...sets).chain((set) =>
      fc.record({
        part: fc.constantFrom(...PARTS.map(({ id }) => id)),
        set: fc.constant(set),
        seed: fc.integer({ min: -999_999_999, max: 999_999_999 }),
        who: fc.constantFrom('', '4711', 'Ada Lovelace', 'Åsa & Bo = 2'),
        question: fc.integer({ min: 0, max: plan(1, set).length - 1 }),
        cases: fc.constantFrom('all', ...SHAPES.map(({ kind }) => kind)),
        casesSeed: fc.integer({ min: 0, max: 999_999_999 }),
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
      shapes: null,
      level: null,
      hints: null,
      seed: null,
      who: null,
      question: null,
      cases: null,
      'cases-seed': null,
    });
  });

  test.each([...Object.keys(SETS), LATEST_SET, '1,sphere', 'roots*3,flat'])(
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

  test('what is chosen beside a set is judged by itself', () => {
    const given = { set: 'nappes*2', shapes: 'cone', level: '9', hints: 'off' };
    const { settings, problems } = readSettings(given);
    expect(settings).toEqual({ set: 'nappes*2', shapes: 'cone', hints: 'off' });
    expect(problems).toEqual([
      "opened without level: '9' is not usable (the level is 1, 2 or 3, not '9')",
    ]);
    expect(settingsOf(given).set).toBe('nappes*2;shapes=cone;hints=off');
    expect(readSettings({ ...given, level: '2', shapes: 'sphere' }).problems[0]).toContain(
      'nappes cannot be asked about sphere',
    );
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
    [{ set: 'roots*x' }, "'roots*x' does not say how often"],
    [{ set: 'rots*2' }, "there is no exercise 'rots'"],
    [{ set: 'roots,roots*2' }, 'roots comes twice'],
    [{ set: 'roots*40,normal*40' }, 'up to 60 questions, not 80'],
    [{ shapes: 'cone' }, 'set 1 has its own shapes'],
    [{ hints: 'no' }, "hints can be off, not 'no'"],
    [{ who: '   ' }, 'a name or number'],
    [{ seed: 'abc' }, "'abc' is not a whole number"],
    [{ seed: '1e99' }, "'1e99'"],
    [{ question: '0' }, "'0' is not a question from 1"],
    [{ question: '999' }, "'999'"],
    [{ set: '__proto__' }, "'__proto__' is not a set"],
    [{ part: '<img>' }, "'<img>' is not questions"],
    [{ 'cases-seed': '-1' }, "'-1' is not a whole number"],
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
