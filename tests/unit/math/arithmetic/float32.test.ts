import { expect, test } from 'vitest';
import { float32 } from '../../../../src/math/arithmetic/float32.ts';
import { seeded, wide } from '../../../../src/math/rng.ts';

const { fround } = Math;

test('every result is a float32 (seed 41)', () => {
  const random = seeded(41);
  for (let i = 0; i < 2000; i++) {
    const a = float32.of(wide(random, -30, 30));
    const b = float32.of(wide(random, -30, 30));
    const { add, sub, mul, div, neg, sqr, sqrt } = float32;
    const results = [
      a,
      b,
      add(a, b),
      sub(a, b),
      mul(a, b),
      div(a, b),
      neg(a),
      sqr(a),
      sqrt(sqr(a)),
    ];
    expect(results.map(fround)).toEqual(results);
  }
});

test('24 bits: 1 + 2^-24 is 1, and 16777217 is not there', () => {
  expect(float32.add(1, float32.of(2 ** -24))).toBe(1);
  expect(float32.of(16777217)).toBe(16777216);
});

test('its own overflow has no sign', () => {
  expect(float32.sign(float32.mul(1e20, 1e20))).toBeNaN();
  expect(float32.sign(float32.of(1e39))).toBeNaN();
  expect(float32.sign(-1)).toBe(-1);
});
