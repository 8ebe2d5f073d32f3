import { describe, expect, test } from 'vitest';
import { decompose, exponentOf, powerOfTwo, scale } from '../../../../src/math/float/bits.ts';
import { seeded, wide } from '../../../../src/math/rng.ts';

const MIN = Number.MIN_VALUE;
const MAX = Number.MAX_VALUE;

describe('decompose', () => {
  test.each([
    [1, 1n, 0],
    [-6, -3n, 1],
    [0.1, 0xccccccccccccdn, -55],
    [2 ** 32, 1n, 32],
    [MIN, 1n, -1074],
    [-MIN * 2 ** 40, -1n, -1034],
    [2 ** -1022, 1n, -1022],
    [2 ** -1022 - MIN, (1n << 52n) - 1n, -1074],
    [MAX, (1n << 53n) - 1n, 971],
    [0, 0n, 0],
    [-0, 0n, 0],
  ])('%d', (x, m, e) => {
    expect(decompose(x)).toEqual({ m, e });
  });

  test('rejects what is not finite', () => {
    for (const x of [Number.NaN, Infinity, -Infinity])
      expect(() => decompose(x)).toThrow(String(x));
  });

  test('m·2^e is x again, 20000 doubles of every exponent (seed 1)', () => {
    const random = seeded(1);
    for (let i = 0; i < 20000; i++) {
      const x = wide(random);
      const { m, e } = decompose(x);
      expect(Object.is(scale(Number(m), e), x + 0)).toBe(true);
    }
  });
});

test('powerOfTwo doubles at every step and ends at 1, MIN_VALUE and the top', () => {
  expect(powerOfTwo(-1074)).toBe(MIN);
  expect(powerOfTwo(0)).toBe(1);
  for (let k = -1074; k < 1023; k++) expect(powerOfTwo(k + 1)).toBe(2 * powerOfTwo(k));
});

test('exponentOf is floor(log2 |x|), on both sides of every power of two', () => {
  for (let k = -1074; k <= 1023; k++) {
    expect(exponentOf(-powerOfTwo(k))).toBe(k);
    if (k > -1022) expect(exponentOf(powerOfTwo(k) * (1 - 2 ** -53))).toBe(k - 1);
  }
  expect(exponentOf(3 * MIN)).toBe(-1073);
  expect(exponentOf(2 ** -1022 - MIN)).toBe(-1023);
  expect(exponentOf(0)).toBe(-Infinity);
  expect(exponentOf(-Infinity)).toBe(Infinity);
  expect(exponentOf(Number.NaN)).toBeNaN();
});

test('scale rounds once, over the whole range and far beyond', () => {
  expect(scale(MIN, 2097)).toBe(2 ** 1023);
  expect(scale(MIN, 2098)).toBe(Infinity);
  expect(scale(2 ** 1023, -2097)).toBe(MIN);
  // 1.5 steps tie to 2; by way of 2^-1022 and 2^-1044 a first rounding would have made 1 of it.
  expect(scale(1.5 * 2 ** 1000, -2074)).toBe(2 * MIN);
  expect(scale((1 + 2 ** -52) * 2 ** 1000, -2075)).toBe(MIN);
  expect(Object.is(scale(-(2 ** 1000), -2075), -0)).toBe(true);
  expect(scale(1, 1e9)).toBe(Infinity);
  expect(scale(-1, -1e9)).toBe(-0);
  expect(scale(0, 5000)).toBe(0);
});
