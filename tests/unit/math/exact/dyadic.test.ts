import { Decimal } from 'decimal.js';
import { describe, expect, test } from 'vitest';
import type { Dyadic } from '../../../../src/math/exact/dyadic.ts';
import * as dy from '../../../../src/math/exact/dyadic.ts';
import { nextUp } from '../../../../src/math/float/ulp.ts';
import { integer, pick, seeded, wide } from '../../../../src/math/rng.ts';

const MIN = Number.MIN_VALUE;
const MAX = Number.MAX_VALUE;
const d = dy.fromNumber;
const same = (got: number, want: number) =>
  expect(Object.is(got, want), `${got} ${want}`).toBe(true);

describe('arithmetic', () => {
  test('0.1 + 0.2 exceeds 0.3 by 2^-55 as stored, not by the 2^-54 of doubles', () => {
    const sum = dy.add(d(0.1), d(0.2));
    expect(dy.compare(sum, d(0.3))).toBe(1);
    same(dy.toNumber(dy.sub(sum, d(0.3))), 2 ** -55);
  });

  test('products keep what a double drops', () => {
    const x = d(1 + 2 ** -52);
    same(dy.toNumber(dy.sub(dy.sqr(x), d(1 + 2 ** -51))), 2 ** -104);
    expect(dy.compare(dy.mul(x, x), dy.sqr(x))).toBe(0);
  });

  test('far exponents add and cancel exactly', () => {
    const sum = dy.add(d(MAX), d(MIN));
    same(dy.toNumber(dy.sub(sum, d(MAX))), MIN);
    same(dy.toNumber(dy.sub(d(MIN), dy.sub(sum, d(MAX)))), 0);
    same(dy.toNumber(dy.sub(d(0), d(3))), -3);
    same(dy.toNumber(dy.shift(d(-3), -1)), -1.5);
  });

  test('order and sign', () => {
    const ascending = [-MAX, -1, -MIN, 0, MIN, 1, nextUp(1), MAX];
    for (const [i, a] of ascending.entries()) {
      for (const [j, b] of ascending.entries()) {
        expect(dy.compare(d(a), d(b))).toBe(Math.sign(i - j));
      }
      expect(dy.sign(d(a))).toBe(Math.sign(a));
    }
    expect(dy.compare({ m: 4n, e: 0 }, { m: 1n, e: 2 })).toBe(0);
    expect(() => d(Number.NaN)).toThrow(RangeError);
  });
});

describe('toNumber', () => {
  test('ties go to the even neighbour, a hair beside them to the nearer', () => {
    const half = { m: 1n, e: -53 };
    const hair = { m: 1n, e: -3000 };
    for (const [x, tie] of [
      [1, 1],
      [nextUp(1), 1 + 2 ** -51],
    ] as const) {
      const middle = dy.add(d(x), half);
      same(dy.toNumber(middle), tie);
      same(dy.toNumber(dy.neg(middle)), -tie);
      same(dy.toNumber(dy.add(middle, hair)), nextUp(x));
      same(dy.toNumber(dy.sub(middle, hair)), x);
    }
  });

  test('subnormals are rounded once', () => {
    const steps = (m: bigint, e: number) => dy.toNumber({ m, e: e - 1074 });
    same(steps((1n << 59n) + 1n, -60), MIN);
    same(steps(1n, -1), 0);
    same(steps(-1n, -1), -0);
    same(steps(3n, -1), 2 * MIN);
    same(steps(5n, -1), 2 * MIN);
    same(steps(-7n, -1), -4 * MIN);
    same(steps(1n, -2), 0);
    same(steps(3n, -2), MIN);
    same(steps(1n, -3000), 0);
    same(steps(-1n, -3000), -0);
    // Just below the normals; and a tie that a first rounding to 53 bits would invent.
    same(steps((1n << 53n) - 1n, -1), 2 ** -1022);
    same(steps((1n << 80n) + (1n << 79n) - 1n, -80), MIN);
  });

  test('the overflow threshold is MAX_VALUE and half a step', () => {
    const threshold = { m: (1n << 54n) - 1n, e: 970 };
    same(dy.toNumber(threshold), Infinity);
    same(dy.toNumber(dy.neg(threshold)), -Infinity);
    same(dy.toNumber(dy.sub(threshold, d(MIN))), MAX);
    same(dy.toNumber(dy.sqr(d(MAX))), Infinity);
    same(dy.toNumber({ m: -1n, e: 99999 }), -Infinity);
    same(dy.toNumber({ m: 0n, e: 99999 }), 0);
  });

  test('1024 ones round up, where Number() alone overflows', () => {
    same(dy.toNumber({ m: (1n << 1024n) - 1n, e: -100 }), 2 ** 924);
    same(dy.toNumber({ m: 1n - (1n << 1024n), e: 0 }), -Infinity);
  });

  test('of a double is that double, 20000 of every exponent (seed 6)', () => {
    const random = seeded(6);
    for (let i = 0; i < 20000; i++) {
      const x = wide(random);
      const long = { m: d(x).m << 1500n, e: d(x).e - 1500 };
      if (dy.toNumber(d(x)) !== x || dy.toNumber(long) !== x) expect.fail(`${x}`);
    }
  });

  test('agrees with decimal.js, 2000 numbers of 1 to 1100 bits near ties (seed 7)', () => {
    const random = seeded(7);
    for (let i = 0; i < 2000; i++) {
      const a = nearTie(random);
      const want = Number(decimal(a).toString());
      if (!Object.is(dy.toNumber(a), want)) expect.fail(`${a.m}·2^${a.e}: want ${want}`);
    }
  });
});

const Digits = Decimal.clone({ precision: 3000, toExpNeg: -9e15, toExpPos: 9e15 });
/** Exactly: 2^-k = 5^k/10^k. */
const decimal = ({ m, e }: Dyadic) =>
  new Digits(e < 0 ? `${m * 5n ** BigInt(-e)}e${e}` : `${m << BigInt(e)}`);

/** A double, half a step of some size, and often something far smaller. */
function nearTie(random: () => number): Dyadic {
  const x = wide(random, pick(random, [-1100, -1074, -1060, 0]), pick(random, [-1000, 1023]));
  const half = { m: 1n, e: d(x).e - integer(random, 1, 60) };
  const hair = { m: BigInt(integer(random, -1, 1)), e: half.e - integer(random, 1, 1000) };
  return dy.add(dy.add(d(x), half), hair);
}
