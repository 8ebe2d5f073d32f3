import { describe, expect, test } from 'vitest';
import {
  digitCount,
  MOST_DIGITS,
  markDigits,
  PLACES,
  rightDigits,
  rightDigitsOfDouble,
} from '../../../src/lab/digits.ts';
import { referenceOf } from '../../../src/lab/reference.ts';
import { decimalDigits } from '../../../src/math/exact/decimal.ts';
import { fromNumber, toNumber } from '../../../src/math/exact/surd.ts';
import { nextUp } from '../../../src/math/float/ulp.ts';
import { rayCases, readAll } from '../math/read-vectors.ts';

const exact = fromNumber;

describe('right digits', () => {
  test.each([
    [9.9999999, 10, 8],
    [10.0000001, 10, 8],
    [1.5, 1.25, 0],
    [-3, 3, 0],
    [-3.0003, -3, 4],
    [1e-310, 1.0001e-310, 4],
    [0, 5e-324, 0],
    [1e-300, 0, 0],
    [Number.POSITIVE_INFINITY, 1, 0],
    [Number.NaN, 1, 0],
  ])('%d for %d: %d', (x, truth, count) => {
    expect(digitCount(rightDigits(x, exact(truth)))).toBe(count);
    expect(digitCount(rightDigitsOfDouble(x, truth))).toBe(count);
  });

  test('the nearest double has all that a double can have, even where that is little', () => {
    expect(rightDigits(0, exact(0))).toBe(MOST_DIGITS);
    expect(rightDigits(5e-324, exact(5e-324))).toBe(MOST_DIGITS);
    expect(digitCount(MOST_DIGITS)).toBe(PLACES);
    expect([7.85, 7.96, 0.9, -1].map(digitCount)).toEqual([7, 8, 0, 0]);
    expect(rightDigits(nextUp(1), exact(1))).toBeCloseTo(15.65, 2);
  });

  test('one step off the nearest double is 15 digits, wherever', () => {
    for (const x of [1, 1.2, 1.5, 1.9, 1.999999, 1e-300, 7e200]) {
      expect(digitCount(rightDigits(nextUp(x), exact(x)))).toBe(15);
      expect(digitCount(rightDigitsOfDouble(nextUp(x), x))).toBe(15);
    }
  });
});

describe('marking', () => {
  const text = (x: number, count: number): string => {
    const { right, wrong, exponent } = markDigits(x, count);
    return `${right}|${wrong}${exponent === null ? '' : `e${exponent}`}`;
  };

  test.each([
    [158.50334193847857, 8, '158.50334|19384786'],
    [158.50334193847857, 3, '158|.5033419384786'],
    [158.50334193847857, 0, '|158.5033419384786'],
    [-9.999999999999998, 16, '−9.999999999999998|'],
    [0.00123, 3, '0.00123|0000000000000'],
    [-0.00123, 0, '|−0.001230000000000000'],
    [1, 16, '1.000000000000000|'],
    [0, 16, '0.000000000000000|'],
    [123456, 6, '123456|.0000000000'],
    [-1.5e-310, 2, '−1.5|00000000000020e-310'],
    [1.5e300, 1, '1|.500000000000000e300'],
    [Number.POSITIVE_INFINITY, 16, '∞|'],
    [Number.NEGATIVE_INFINITY, 0, '|−∞'],
  ])('%d with %i right digits is %s', (x, count, marked) => {
    expect(text(x, count)).toBe(marked);
  });

  test('as many digits are marked as the count says, and all places are written', () => {
    for (const x of [158.50334193847857, -0.0999, 9.999999999999998, 2 ** 70, -1e-5, 1e-4]) {
      for (let count = 0; count <= PLACES; count++) {
        const { right, wrong } = markDigits(x, count);
        const significant = (right + wrong).replace(/[^0-9]/g, '').replace(/^0+/, '');
        expect(significant).toHaveLength(PLACES);
        expect(right.replace(/[^0-9]/g, '').replace(/^0+/, '')).toHaveLength(count);
      }
    }
  });
});

describe(`the exact roots of ${rayCases.length} cases`, () => {
  test('have the 40 digits that were computed outside', () => {
    let roots = 0;
    for (const { shape, ray, expect: expected } of rayCases) {
      const { found, hits } = referenceOf(shape, ray);
      expect(found.class).toBe(expected.class);
      expect(hits.map(({ t }) => toNumber(t))).toEqual(readAll(expected.roots));
      const written = hits.map(({ t }) => {
        const { negative, digits, exponent } = decimalDigits(t, 41);
        return { negative, digits, exponent };
      });
      expected.roots40.forEach((text, i) => {
        roots += 1;
        const [mantissa = '', exponent = ''] = text.split('e');
        const own = written[i];
        if (/^-?0(\.0*)?$/.test(mantissa)) {
          expect(own?.digits).toBe('0');
          return;
        }
        expect(own?.negative).toBe(mantissa.startsWith('-'));
        expect(own?.exponent).toBe(Number(exponent));
        expect(own?.digits).toBe(mantissa.replace(/[-.]/g, ''));
      });
    }
    expect(roots).toBeGreaterThan(1000);
  });
});
