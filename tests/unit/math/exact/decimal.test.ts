import { expect, test } from 'vitest';
import { decimalDigits } from '../../../../src/math/exact/decimal.ts';
import * as surd from '../../../../src/math/exact/surd.ts';
import { fromNumber } from '../../../../src/math/exact/surd.ts';

const text = (x: surd.Surd, n: number): string => {
  const { negative, digits, exponent } = decimalDigits(x, n);
  return `${negative ? '-' : ''}${digits}e${exponent}`;
};

test.each([
  [0, 5, '0e0'],
  [1, 5, '10000e0'],
  [-0.1, 25, '-1000000000000000055511151e-1'],
  [99999.5, 5, '10000e5'],
  [Number.MIN_VALUE, 10, '4940656458e-324'],
  [-Number.MAX_VALUE, 6, '-179769e308'],
] as const)('%d in %d digits', (x, n, expected) => {
  expect(text(fromNumber(x), n)).toBe(expected);
});

test('irrational and beyond the doubles', () => {
  const two = surd.sqrt(fromNumber(2));
  expect(text(two, 40)).toBe('1414213562373095048801688724209698078570e0');
  expect(text(surd.neg(surd.sub(fromNumber(1.5), two)), 12)).toBe('-857864376269e-2');
  // 1.5857864…: the whole part of a difference is one less than that of its rounded root says.
  expect(text(surd.sub(fromNumber(3), two), 7)).toBe('1585786e0');
  const huge = surd.mul(fromNumber(1e300), surd.mul(fromNumber(1e300), two));
  expect(text(huge, 6)).toBe('141421e600');
  const tiny = surd.div(two, surd.mul(fromNumber(1e300), fromNumber(1e300)));
  expect(text(tiny, 6)).toBe('141421e-600');
});
