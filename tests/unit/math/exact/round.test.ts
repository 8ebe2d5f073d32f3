import { describe, expect, test } from 'vitest';
import type { Dyadic } from '../../../../src/math/exact/dyadic.ts';
import * as dy from '../../../../src/math/exact/dyadic.ts';
import { bracket, isFaithful } from '../../../../src/math/exact/faithful.ts';
import * as surd from '../../../../src/math/exact/surd.ts';
import { nextDown, nextUp } from '../../../../src/math/float/ulp.ts';

const MIN = Number.MIN_VALUE;
const MAX = Number.MAX_VALUE;
const d = dy.fromNumber;
const of = (u: Dyadic, v: Dyadic, w: Dyadic, D: Dyadic) => surd.surd(u, v, w, D);
const power = (e: number): Dyadic => ({ m: 1n, e });
const same = (got: number, want: number) =>
  expect(Object.is(got, want), `${got} ${want}`).toBe(true);

test('known constants: √2, 1/3, 0.1 from 1/10, the silver ratio', () => {
  same(surd.toNumber(surd.sqrt(surd.fromNumber(2))), Math.SQRT2);
  same(surd.toNumber(surd.ratio(d(1), d(3))), 1 / 3);
  same(surd.toNumber(surd.ratio(d(-1), d(10))), -0.1);
  same(surd.toNumber(of(d(1), d(-1), d(1), d(2))), -0.41421356237309503);
  same(surd.toNumber(of(d(1), d(1), d(-1), d(2))), -2.414213562373095);
});

describe('exact ties through a root that is rational', () => {
  // x/9 with x = 9(1 + k·2^-53) from 9 + k·2^-53·√81: never a reduced form.
  const tie = (k: number) => of(d(9), d(k * 2 ** -53), d(9), d(81));
  const beside = (k: number, hair: number) => ({ ...tie(k), u: dy.add(d(9), power(hair)) });

  test.each([
    [1, 1],
    [3, 1 + 2 ** -51],
    [5, 1 + 2 ** -51],
    [-0.5, 1],
    [-1.5, 1 - 2 ** -52],
  ])('1 + %d/2 ulp', (k, want) => {
    same(surd.toNumber(tie(k)), want);
    same(surd.toNumber(surd.neg(tie(k))), -want);
  });

  test.each([60, 66, 100, 1000, 5000])('a hair of 2^-%d decides', (bits) => {
    same(surd.toNumber(beside(1, -bits)), 1 + 2 ** -52);
    same(surd.toNumber(surd.neg(beside(1, -bits))), -1 - 2 ** -52);
    const below = { ...tie(1), u: dy.sub(d(9), power(-bits)) };
    same(surd.toNumber(below), 1);
  });
});

describe('irrational, within 2^-k of a midpoint on either side', () => {
  test.each([55, 58, 62, 63, 64, 65, 70, 128, 700, 4000])('k = %d', (k) => {
    for (const x of [1, nextUp(1), 1.75, 3 * MIN, nextDown(2 ** -1022), MAX / 3, -5]) {
      const step = dy.sub(d(nextUp(x)), d(x));
      const middle = dy.add(d(x), dy.shift(step, -1));
      const hair = dy.shift(step, -k);
      for (const w of [1, -7, 3 * 2 ** 900]) {
        const u = dy.mul(middle, d(w));
        const up = of(u, dy.mul(hair, d(w)), d(w), d(2));
        const down = of(u, dy.neg(dy.mul(hair, d(w))), d(w), d(2));
        same(surd.toNumber(up), nextUp(x));
        same(surd.toNumber(down), x);
      }
    }
  });
});

describe('the ends of the doubles', () => {
  // √2·2^e scaled by v, and u = 0
  const root2 = (e: number) => of(dy.ZERO, power(e), d(1), d(2));
  test('below: 0.7, 0.35 of the smallest, and far less', () => {
    same(surd.toNumber(root2(-1075)), MIN);
    same(surd.toNumber(root2(-1076)), 0);
    same(surd.toNumber(surd.neg(root2(-1076))), -0);
    same(surd.toNumber(surd.neg(root2(-9000))), -0);
    same(surd.toNumber(surd.ratio(power(-9000), d(-3))), -0);
    same(surd.toNumber(of(d(3), d(-1), d(1), d(9))), 0);
  });

  test('half the smallest subnormal ties to 0, one and a half to 2', () => {
    const halves = (k: number) => of(d(0), d(k * MIN), d(6), d(9));
    same(surd.toNumber(halves(1)), 0);
    same(surd.toNumber(halves(-1)), -0);
    same(surd.toNumber(halves(3)), 2 * MIN);
    const above = { m: (1n << 59n) + 1n, e: -1134 };
    same(surd.toNumber(surd.ratio(dy.mul(above, d(3)), d(3))), MIN);
  });

  test('above: the threshold ties to Infinity, a hair less is MAX_VALUE', () => {
    const threshold = { m: (1n << 54n) - 1n, e: 970 };
    const hair = (v: number) => of(threshold, d(v), d(1), d(2));
    same(surd.toNumber(surd.ratio(dy.mul(threshold, d(3)), d(3))), Infinity);
    same(surd.toNumber(hair(-MIN)), MAX);
    same(surd.toNumber(hair(MIN)), Infinity);
    same(surd.toNumber(surd.neg(hair(MIN))), -Infinity);
    same(surd.toNumber(root2(1024)), Infinity);
    same(surd.toNumber(root2(9000)), Infinity);
  });
});

test('a quotient next to a midpoint, and at it', () => {
  const half = dy.mul(d(3), dy.add(d(1), power(-53)));
  for (const bits of [62, 64, 100, 900]) {
    same(surd.toNumber(surd.ratio(dy.add(half, power(-bits)), d(3))), 1 + 2 ** -52);
    same(surd.toNumber(surd.ratio(dy.sub(half, power(-bits)), d(-3))), -1);
  }
  same(surd.toNumber(surd.ratio(half, d(3))), 1);
});

describe('√D is a whole number longer than the bits that are kept of it', () => {
  // u + v√D is the midpoint and a hair, but the cut root puts the sum on the other side.
  const root = { m: (1n << 199n) + 1n, e: -199 };
  const D = dy.sqr(root);
  test.each([
    [0, 0, MIN],
    [MIN, 2 * MIN, 2 * MIN],
    [1, 1, nextUp(1)],
    [nextUp(1), 1 + 2 ** -51, 1 + 2 ** -51],
    [MAX, Infinity, Infinity],
  ])('above %d: a tie gives %d, a hair more %d', (x, tie, above) => {
    const step = x === MAX ? power(971) : dy.sub(d(nextUp(x)), d(x));
    const middle = dy.add(d(x), dy.shift(step, -1));
    for (const v of [dy.shift(step, -3), dy.shift(dy.neg(step), -3)]) {
      const u = dy.sub(middle, dy.mul(v, root));
      const hair = dy.shift(step, -900);
      for (const w of [d(1), d(-3)]) {
        const scaled = (u: Dyadic) => of(dy.mul(u, w), dy.mul(v, w), w, D);
        same(surd.toNumber(scaled(u)), tie);
        same(surd.toNumber(scaled(dy.add(u, hair))), above);
        same(surd.toNumber(scaled(dy.sub(u, hair))), x);
      }
    }
  });
});

describe('bracket', () => {
  test('by hand', () => {
    const sqrt2 = surd.sqrt(surd.fromNumber(2));
    expect(bracket(sqrt2)).toEqual([nextDown(Math.SQRT2), Math.SQRT2]);
    expect(bracket(surd.neg(sqrt2))).toEqual([-Math.SQRT2, -nextDown(Math.SQRT2)]);
    expect(bracket(of(d(1), d(1), d(1), d(9)))).toEqual([4, 4]);
    expect(bracket(of(d(0), power(-2000), d(1), d(2)))).toEqual([0, MIN]);
    expect(bracket(of(d(0), dy.neg(power(-2000)), d(1), d(2)))).toEqual([-MIN, -0]);
    expect(bracket(of(d(0), power(2000), d(1), d(2)))).toEqual([MAX, Infinity]);
    expect(isFaithful(sqrt2, nextDown(Math.SQRT2))).toBe(true);
    expect(isFaithful(sqrt2, nextUp(Math.SQRT2))).toBe(false);
    expect(isFaithful(sqrt2, nextDown(nextDown(Math.SQRT2)))).toBe(false);
  });
});
