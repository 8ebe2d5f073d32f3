import { describe, expect, test } from 'vitest';
import type { DoubleDouble } from '../../../../src/math/arithmetic/double-double.ts';
import { doubleDouble } from '../../../../src/math/arithmetic/double-double.ts';
import * as dy from '../../../../src/math/exact/dyadic.ts';
import { scale } from '../../../../src/math/float/bits.ts';
import * as registers from '../../../../src/math/float/double-double.ts';
import { integer, type Random, seeded, wide } from '../../../../src/math/rng.ts';

const sumOf = ({ hi, lo }: DoubleDouble): dy.Dyadic => dy.add(dy.fromNumber(hi), dy.fromNumber(lo));

/** Any exponent of hi in the range, lo below half an ulp by 0 … 60 bits, at the tie, or 0. */
function draw(random: Random, low = -200, high = 200): DoubleDouble {
  const hi = wide(random, low, high);
  const half = Math.abs(scale(hi, -53)) / (1 + random());
  const lo = [0, 1, scale(1, -integer(random, 0, 60)), random(), -random()][integer(random, 0, 4)];
  const x = half * (lo ?? 0);
  const s = hi + x;
  return { hi: s, lo: x - (s - hi) };
}

/** A neighbour of −a: hi cancels, lo may. */
function opposite(random: Random, { hi, lo }: DoubleDouble): DoubleDouble {
  const k = 1 + (random() - 0.5) * scale(1, -integer(random, 1, 52));
  const s = -hi * k;
  const x = -lo * random();
  const t = s + x;
  return { hi: t, lo: x - (t - s) };
}

const COUNT = 10000;
/** In units of u² = 2^-106. */
const U2 = { m: 1n, e: -106 };
const times = (k: number, x: dy.Dyadic): dy.Dyadic =>
  dy.abs(dy.mul(dy.mul(dy.fromNumber(k), U2), x));

/** |hi + lo − true| ≤ bound·u²·|true|, and hi is the rounded sum. */
function within(got: DoubleDouble, truth: dy.Dyadic, bound: number): boolean {
  const off = dy.abs(dy.sub(sumOf(got), truth));
  return dy.compare(off, times(bound, truth)) <= 0 && got.hi + got.lo === got.hi;
}

describe('the bounds of Joldes, Muller, Popescu and of Lefèvre et al. hold', () => {
  test('add: 3u², cancelling or not (seed 11)', () => {
    const random = seeded(11);
    for (let i = 0; i < COUNT; i++) {
      const a = draw(random);
      const b = i % 2 ? opposite(random, a) : draw(random);
      const truth = dy.add(sumOf(a), sumOf(b));
      expect(within(doubleDouble().add(a, b), truth, 3.0001), `${i}`).toBe(true);
    }
  });

  test('sub is add of the negative (seed 12)', () => {
    const random = seeded(12);
    for (let i = 0; i < 2000; i++) {
      const a = draw(random);
      const b = draw(random);
      const zeros = ({ hi, lo }: DoubleDouble) => [hi + 0, lo + 0];
      expect(zeros(doubleDouble().sub(a, b))).toEqual(
        zeros(doubleDouble().add(a, doubleDouble().neg(b))),
      );
    }
  });

  test('mul: 5u²; sqr is mul, bit for bit (seed 13)', () => {
    const random = seeded(13);
    for (let i = 0; i < COUNT; i++) {
      const a = draw(random);
      const b = draw(random);
      const truth = dy.mul(sumOf(a), sumOf(b));
      expect(within(doubleDouble().mul(a, b), truth, 5), `${i}`).toBe(true);
      expect(doubleDouble().sqr(a)).toEqual(doubleDouble().mul(a, a));
    }
  });

  test('div: 9.8u², measured as q·b against a (seed 14)', () => {
    const random = seeded(14);
    for (let i = 0; i < COUNT; i++) {
      const a = draw(random);
      const b = draw(random);
      const q = doubleDouble().div(a, b);
      const off = dy.abs(dy.sub(dy.mul(sumOf(q), sumOf(b)), sumOf(a)));
      expect(dy.compare(off, times(9.8001, sumOf(a))), `${i}`).toBeLessThanOrEqual(0);
    }
  });

  test('sqrt: 25/8 u², measured as s² against a, which doubles it (seed 15)', () => {
    const random = seeded(15);
    for (let i = 0; i < COUNT; i++) {
      const x = draw(random);
      const a = x.hi < 0 ? doubleDouble().neg(x) : x;
      const off = dy.abs(dy.sub(dy.sqr(sumOf(doubleDouble().sqrt(a))), sumOf(a)));
      expect(dy.compare(off, times(6.2501, sumOf(a))), `${i}`).toBeLessThanOrEqual(0);
    }
  });
});

describe('exact where it can be', () => {
  const of = doubleDouble().of;
  test('1 + 2^-100 − 1 is 2^-100', () => {
    const sum = doubleDouble().add(of(1), of(2 ** -100));
    expect(doubleDouble().sub(sum, of(1))).toEqual({ hi: 2 ** -100, lo: 0 });
  });
  test('0.1² holds all 106 bits', () => {
    expect(dy.compare(sumOf(doubleDouble().sqr(of(0.1))), dy.sqr(dy.fromNumber(0.1)))).toBe(0);
  });
  test('roots of squares, and of 0', () => {
    expect(doubleDouble().sqrt(of(9))).toEqual({ hi: 3, lo: 0 });
    expect(doubleDouble().sqrt(of(0))).toEqual({ hi: 0, lo: 0 });
  });
});

describe('where the range ends', () => {
  const { of, mul, add, div, sqrt, sign, toNumber } = doubleDouble();
  test.each([
    ['a product that overflows', mul(of(1e200), of(1e200))],
    ['a sum that overflows', add(of(1.7e308), of(1.7e308))],
    ['a factor beyond the splitter', mul(of(2 ** 997), of(1.1))],
    ['a quotient by 0', div(of(1), of(0))],
    ['the root of a negative number', sqrt(of(-1))],
  ])('%s has no sign and no value', (_, x) => {
    expect(sign(x)).toBeNaN();
    expect(toNumber(x)).toBeNaN();
  });
});

test('the registers’ own sign and mulDouble', () => {
  const R = new Float64Array(6);
  registers.set(R, 0, 0.1);
  registers.sqr(R, 2, 0);
  registers.mulDouble(R, 4, 2, -8);
  const eight = doubleDouble().mul(
    doubleDouble().sqr(doubleDouble().of(0.1)),
    doubleDouble().of(-8),
  );
  expect([R[4], R[5]]).toEqual([eight.hi, eight.lo]);
  expect(registers.sign(R, 4)).toBe(-1);
});
