import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { plan } from '../../../src/check/session.ts';
import { SHAPES } from '../../../src/math/index.ts';
import { PARTS, readSettings, settingsFor, settingsOf } from '../../../src/pages/check/settings.ts';

const withoutNulls = (texts: Readonly<Record<string, string | null>>): Record<string, string> =>
  Object.fromEntries(
    Object.entries(texts).filter((pair): pair is [string, string] => pair[1] !== null),
  );

describe('the settings of the page Check', () => {
  test('come back from the link as they went in, 500 runs', () => {
    const any = fc.record({
      part: fc.constantFrom(...PARTS.map(({ id }) => id)),
      seed: fc.integer({ min: -999_999_999, max: 999_999_999 }),
      question: fc.integer({ min: 0, max: plan(1).length - 1 }),
      cases: fc.constantFrom('all', ...SHAPES.map(({ kind }) => kind)),
    });
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
      seed: null,
      question: null,
      cases: null,
    });
  });

  test('every session has as many questions: a link to one is good for every seed', () => {
    const counts = new Set(Array.from({ length: 200 }, (_, seed) => plan(seed - 100).length));
    expect([...counts]).toEqual([plan(1).length]);
  });

  test.each([
    [{ seed: 'abc' }, "'abc' is not a whole number"],
    [{ seed: '1e99' }, "'1e99'"],
    [{ question: '0' }, "'0' is not a question from 1"],
    [{ question: '999' }, "'999'"],
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
