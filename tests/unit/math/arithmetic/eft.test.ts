import { describe, expect, test } from 'vitest';
import * as dy from '../../../../src/math/exact/dyadic.ts';
import { powerOfTwo } from '../../../../src/math/float/bits.ts';
import {
  fastSumError,
  LEAST_EXACT_PRODUCT,
  productError,
  squareError,
  sumError,
} from '../../../../src/math/float/eft.ts';
import { seeded, wide } from '../../../../src/math/rng.ts';

const { fromNumber, add, mul, compare } = dy;

/** x = s + e exactly. */
const splits = (x: dy.Dyadic, s: number, e: number): boolean =>
  compare(x, add(fromNumber(s), fromNumber(e))) === 0;

const COUNT = 10000;

describe('sumError', () => {
  test('a + b = s + e exactly, at any two exponents (seed 1)', () => {
    const random = seeded(1);
    for (let i = 0; i < COUNT; i++) {
      const a = wide(random, -1074, 1022);
      // Half of them near a, where most bits cancel.
      const b = i % 2 ? wide(random, -1074, 1022) : -a * (1 + random() * 2 ** -(i % 60));
      const s = a + b;
      expect(splits(add(fromNumber(a), fromNumber(b)), s, sumError(a, b, s)), `${a} + ${b}`).toBe(
        true,
      );
    }
  });

  test('an overflow is a NaN', () => {
    expect(sumError(1.5e308, 1.5e308, Infinity)).toBeNaN();
  });
});

test('fastSumError is the same where |a| ≥ |b| (seed 2)', () => {
  const random = seeded(2);
  for (let i = 0; i < COUNT; i++) {
    const x = wide(random, -60, 60);
    const y = wide(random, -60, 60);
    const [a, b] = Math.abs(x) >= Math.abs(y) ? [x, y] : [y, x];
    const s = a + b;
    expect(fastSumError(a, b, s) + 0).toBe(sumError(a, b, s) + 0);
  }
});

describe('productError', () => {
  test('a·b = p + e exactly: |p| from 2^-968 to 2^1020, factors under 2^996 (seed 3)', () => {
    const random = seeded(3);
    let asked = 0;
    for (let i = 0; i < COUNT; i++) {
      const a = wide(random, -1074, 995);
      const b = wide(random, -1074, 995);
      const p = a * b;
      if (Math.abs(p) < LEAST_EXACT_PRODUCT || Math.abs(p) > powerOfTwo(1020)) continue;
      asked += 1;
      const exactly = mul(fromNumber(a), fromNumber(b));
      expect(splits(exactly, p, productError(a, b, p)), `${a} · ${b}`).toBe(true);
    }
    expect(asked).toBeGreaterThan(COUNT / 4);
  });

  test('at the lower end of the range, product after product (seed 4)', () => {
    const random = seeded(4);
    for (let i = 0; i < COUNT; i++) {
      const a = wide(random, -500, -400);
      const b = LEAST_EXACT_PRODUCT / a;
      const p = a * b;
      if (Math.abs(p) < LEAST_EXACT_PRODUCT) continue;
      expect(splits(mul(fromNumber(a), fromNumber(b)), p, productError(a, b, p))).toBe(true);
    }
  });

  test('below the range it is off by at most 2^-1073 (seed 5)', () => {
    const random = seeded(5);
    const most = { m: 1n, e: -1073 };
    let lost = 0;
    for (let i = 0; i < COUNT; i++) {
      const a = wide(random, -600, -400);
      const b = wide(random, -600, -400);
      const p = a * b;
      const got = add(fromNumber(p), fromNumber(productError(a, b, p)));
      const off = dy.sub(mul(fromNumber(a), fromNumber(b)), got);
      expect(compare(dy.abs(off), most)).toBeLessThanOrEqual(0);
      if (off.m !== 0n) lost += 1;
    }
    expect(lost).toBeGreaterThan(COUNT / 4);
  });

  test('above the range it is NaN, never a wrong number', () => {
    expect(productError(2 ** 997, 3, 3 * 2 ** 997)).toBeNaN();
    expect(productError(1e200, 1e200, Infinity)).toBeNaN();
  });

  test('squareError is productError of a and a (seed 6)', () => {
    const random = seeded(6);
    for (let i = 0; i < COUNT; i++) {
      const a = wide(random, -484, 509);
      const p = a * a;
      expect(squareError(a, p)).toBe(productError(a, a, p));
    }
  });
});
