import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  display,
  displayAll,
  displayParts,
  displayTriple,
  shortest,
} from '../../../src/text/format.ts';
import { plainPowers, subscript, superscript } from '../../../src/text/scripts.ts';
import { anyDouble, SEED } from './doubles.ts';

const MAX = Number.MAX_VALUE;

describe('display: meaning', () => {
  it.each([
    [9, '9'],
    [-5.6, '−5.6'],
    [0.72, '0.72'],
    [0.7200000000000001, '0.72'],
    [0.7199999999999999, '0.72'],
    [5.440000000000005, '5.44'],
    [0.1 + 0.2, '0.3'],
    [5.508600319703851, '5.50860'],
    [-0.10172006394077, '−0.101720'],
    [1.184655744236919, '1.18466'],
    [-1.7168, '−1.7168'],
    [1 / 3, '0.333333'],
    [100000, '100000'],
    [123456, '123456'],
    [0.0001, '0.0001'],
    [0.00025, '0.00025'],
    [1e7, '10⁷'],
    [-1e7, '−10⁷'],
    [1.2e7, '1.2 · 10⁷'],
    [-3.5e-9, '−3.5 · 10⁻⁹'],
    [1e300, '10³⁰⁰'],
  ])('%f is shown as %s', (x, text) => {
    expect(display(x)).toBe(text);
  });

  it('shows both zeros as 0, infinities as ∞, NaN as a word', () => {
    expect([0, -0, 1 / 0, -1 / 0, Number.NaN].map((x) => display(x))).toEqual([
      '0',
      '0',
      '∞',
      '−∞',
      'no value',
    ]);
  });
});

describe('display: at the edges of rounding', () => {
  it.each([
    [9.999999e5, '1.00000 · 10⁶'],
    [999999.4, '999999'],
    [999999.5, '1.00000 · 10⁶'],
    [999999, '999999'],
    [1e6, '10⁶'],
    [0.00009999999, '0.000100000'],
    [0.000099999949, '9.99999 · 10⁻⁵'],
    [0.99999999999, '1.00000'],
    [0.99999999999999989, '1'],
    [1 + 2 ** -52, '1'],
    [1.000000001, '1.00000'],
    [5e-324, '4.94066 · 10⁻³²⁴'],
    [2.2250738585072014e-308, '2.22507 · 10⁻³⁰⁸'],
    [MAX, '1.79769 · 10³⁰⁸'],
    [2 ** 53, '9.00720 · 10¹⁵'],
    [2 ** 53 - 1, '9.00720 · 10¹⁵'],
    [1048576, '1.04858 · 10⁶'],
  ])('%f is shown as %s', (x, text) => {
    expect(display(x)).toBe(text);
  });

  it('takes other numbers of digits without inventing zeros', () => {
    expect(display(123456, 3)).toBe('1.23 · 10⁵');
    expect(display(100000, 3)).toBe('100000');
    expect(display(999.9, 3)).toBe('1.00 · 10³');
    expect(display(1234567.89, 9)).toBe('1234567.89');
    expect(display(1 / 3, 15)).toBe('0.333333333333333');
    expect(display(0.1, 17)).toBe('0.1');
    expect(display(0.1 + 0.2, 17)).toBe('0.30000000000000004');
    expect(display(7.5, 1)).toBe('8');
  });
});

describe('display: every double', () => {
  const value = (text: string) =>
    Number(plainPowers(text).replaceAll('−', '-').replace(' · 10^', 'e').replace('10^', '1e'));

  it(`is right to half a unit of the sixth digit, and never 0 (seed ${SEED})`, () => {
    fc.assert(
      fc.property(anyDouble, (x) => {
        // MAX_VALUE and its neighbours round up to 1.79769e308 at most, so Number is finite here.
        const shown = value(display(x));
        expect(shown === 0).toBe(x === 0);
        expect(Math.abs(shown / 2 - x / 2)).toBeLessThanOrEqual(
          Math.max(Math.abs(x / 2) * 5.0001e-6, 5e-324),
        );
      }),
      { seed: SEED, numRuns: 4000 },
    );
  });

  it(`is monotone (seed ${SEED})`, () => {
    fc.assert(
      fc.property(anyDouble, fc.double({ min: 0.999, max: 1.001, noNaN: true }), (x, factor) => {
        const [low, high] = x < x * factor ? [x, x * factor] : [x * factor, x];
        if (Number.isFinite(low) && Number.isFinite(high))
          expect(value(display(low))).toBeLessThanOrEqual(value(display(high)));
      }),
      { seed: SEED, numRuns: 4000 },
    );
  });
});

describe('the other forms', () => {
  it('gives mantissa and exponent apart', () => {
    expect(displayParts(-1.2e7)).toEqual({ mantissa: '−1.2', exponent: 7 });
    expect(displayParts(1e-9)).toEqual({ mantissa: '1', exponent: -9 });
    expect(displayParts(0.5)).toEqual({ mantissa: '0.5', exponent: null });
  });

  it('writes all digits with a true minus, and code with a hyphen', () => {
    expect(displayAll(-0.7200000000000001)).toBe('−0.7200000000000001');
    expect(displayAll(-1.5e-300)).toBe('−1.5e−300');
    expect(displayAll(Number.NEGATIVE_INFINITY)).toBe('−∞');
    expect([-0, -1e21, Number.NEGATIVE_INFINITY].map(shortest)).toEqual([
      '-0',
      '-1e+21',
      '-Infinity',
    ]);
  });

  it('writes triples, superscripts and subscripts', () => {
    expect(displayTriple([3, -0.8, 1e7])).toBe('(3, −0.8, 10⁷)');
    expect(superscript(-307) + subscript(12)).toBe('⁻³⁰⁷₁₂');
  });

  it(`shortest gives the same bits back for every double (seed ${SEED})`, () => {
    fc.assert(
      fc.property(anyDouble, (x) => {
        expect(Number(shortest(x))).toBe(x);
      }),
      { seed: SEED, numRuns: 4000, examples: [[-0], [MAX], [5e-324], [Number.POSITIVE_INFINITY]] },
    );
  });
});
