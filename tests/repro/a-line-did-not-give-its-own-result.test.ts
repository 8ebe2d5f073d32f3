import { expect, test } from 'vitest';
import { createDerive } from '../../src/state/derive.ts';
import { rangeNote, shownResult } from '../../src/state/exact-digits.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { derivationLatex } from '../../src/state/exports/latex.ts';
import { decode } from '../../src/state/url.ts';

const model = (query: string) => createDerive(() => exploreDetails)(decode(`#/explore?${query}`));

/* c = 1/3: line B stood there with 0.33, and 2 · 0.33² … is not −5.48889. */
test('two digits of c do not give B', () => {
  const latex = derivationLatex(model('shape=cone&c=1/3'));
  expect(latex).toContain('0.333333^{2}');
  expect(latex).not.toMatch(/0\.33\^/);
});

/* E = 10³⁰⁰: "A = ∞" beside a root that was right. */
test('what overflows says so beside a result that was found exactly', () => {
  const { derivation, found, exactly } = model('shape=cone&E=1e300,1,1&d=-1e300,0,0');
  expect(found.hits.map(({ t }) => t)).toEqual([1]);
  expect(rangeNote(derivation, found, exactly)).toBe(
    'A, B, C beyond 1.8 · 10³⁰⁸ as a double; solved exactly',
  );
  expect(shownResult('A', Infinity, found, exactly).text).toBe('10⁶⁰⁰');
});

test('a coefficient below the doubles is not printed as 0', () => {
  const { found, exactly } = model('shape=cylinder&E=1e-200,0,0&d=1e-200,0,0&C=0,0,0&r=1e-200');
  expect(shownResult('A', 0, found, exactly).text).toBe('10⁻⁴⁰⁰');
  expect(shownResult('C', 0, found, exactly).text).toBeNull();
});

/* D was printed as "∞² − 4·∞·undefined". */
test('what has no value is no number in a formula', () => {
  const query = 'shape=cone&E=1e308,1e308,1&d=1e308,1,1&method=textbook';
  expect(derivationLatex(model(query))).not.toMatch(/undefined|NaN/);
});

/* t₁ = 4 by the textbook's formula, and nothing beside it. */
test('another method’s root stands beside the exact one', () => {
  const { found, exactly } = model('shape=cylinder&E=1e8,1.5,0&d=-1,0.1,1e-9&method=textbook');
  const { details } = found;
  if (details.family !== 'curved') throw new Error('a flat shape');
  expect(shownResult('D', details.D, found, exactly).beside).toBe('exact: 8.96');
});
