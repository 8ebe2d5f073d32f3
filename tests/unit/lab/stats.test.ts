import { expect, test } from 'vitest';
import { quantile, quartiles } from '../../../src/lab/stats.ts';

test('quartiles do not care for the order, nor for one wild value', () => {
  expect(quartiles([5, 1, 3, 2, 4])).toEqual({ low: 2, median: 3, high: 4 });
  expect(quartiles([5, 1, 3, 2, 4e9])).toEqual({ low: 2, median: 3, high: 5 });
  expect(quartiles([1, 2])).toEqual({ low: 1.25, median: 1.5, high: 1.75 });
});

test('quantiles between infinite neighbours stay infinite', () => {
  expect(quantile([1, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY], 0.75)).toBe(
    Number.POSITIVE_INFINITY,
  );
  expect(quantile([], 0.5)).toBeNaN();
});
