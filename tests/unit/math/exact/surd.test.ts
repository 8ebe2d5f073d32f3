import { describe, expect, test } from 'vitest';
import { exact } from '../../../../src/math/arithmetic/exact.ts';
import * as dy from '../../../../src/math/exact/dyadic.ts';
import * as surd from '../../../../src/math/exact/surd.ts';

const n = surd.fromNumber;
const d = dy.fromNumber;
const sqrt2 = surd.sqrt(n(2));
const equal = (a: surd.Surd, b: surd.Surd) => expect(surd.compare(a, b)).toBe(0);
/** (u + v√D)/w */
const of = (u: number, v: number, w: number, D: number) => surd.surd(d(u), d(v), d(w), d(D));

describe('field', () => {
  test('√2 squared is 2, and 1/(1 + √2) is √2 − 1', () => {
    equal(surd.sqr(sqrt2), n(2));
    equal(surd.div(n(1), surd.add(n(1), sqrt2)), surd.sub(sqrt2, n(1)));
  });

  test('the golden ratio solves x² = x + 1', () => {
    const phi = of(1, 1, 2, 5);
    equal(surd.sqr(phi), surd.add(phi, n(1)));
    equal(surd.div(n(1), phi), surd.sub(phi, n(1)));
    expect(surd.toNumber(phi)).toBe(1.618033988749895);
  });

  test('different denominators', () => {
    const third = surd.div(n(1), n(3));
    const seventh = surd.div(sqrt2, n(7));
    const sum = surd.add(third, seventh);
    equal(surd.sub(sum, third), seventh);
    equal(surd.div(surd.mul(sum, seventh), sum), seventh);
    equal(surd.mul(surd.neg(third), n(-3)), n(1));
  });

  test('1/49 times 49 is 1 here, and is not in doubles', () => {
    expect((1 / 49) * 49).not.toBe(1);
    equal(surd.mul(surd.div(n(1), n(49)), n(49)), n(1));
  });

  test('√(9/4) = 3/2, √(2/9) = √2/3 up to sign, √0 = 0', () => {
    equal(surd.sqrt(surd.div(n(9), n(4))), n(1.5));
    equal(surd.sqr(surd.sqrt(surd.div(n(-2), n(-9)))), surd.div(n(2), n(9)));
    expect(surd.sign(surd.sqrt(surd.div(n(-2), n(-9))))).toBe(1);
    expect(surd.isZero(surd.sqrt(n(0)))).toBe(true);
  });
});

describe('sign', () => {
  test.each([
    [3, -2, 1, 2, 1],
    [2, -1.5, 1, 2, -1],
    [-3, 2, 1, 2, -1],
    [-3, 2, -1, 2, 1],
    [0, -1, 1, 7, -1],
    [0, 0, -1, 7, 0],
    [3, -1, 1, 9, 0],
    [-3, 1, -5, 9, 0],
    [5, -9, 1, 0, 1],
    [-2, -1, 1, 3, -1],
  ])('(%d + %d√D)/%d, D = %d: %d', (u, v, w, D, want) => {
    const s = of(u, v, w, D);
    expect(surd.sign(s)).toBe(want);
    expect(surd.isZero(s)).toBe(want === 0);
  });

  test('Pell: 1393 − 985√2 = 1/(1393 + 985√2)·(−1), and neighbours of 99/70', () => {
    expect(surd.sign(of(1393, -985, 1, 2))).toBe(-1);
    expect(surd.sign(of(577, -408, 1, 2))).toBe(1);
    expect(surd.compare(sqrt2, surd.div(n(99), n(70)))).toBe(-1);
    expect(surd.compare(sqrt2, surd.div(n(239), n(169)))).toBe(1);
  });
});

describe('perfect squares under the root', () => {
  test('5 − √9 divides, though its conjugate or norm may vanish', () => {
    equal(surd.div(n(4), of(5, -1, 1, 9)), n(2));
    equal(surd.div(n(12), of(3, 1, 1, 9)), n(2));
    expect(surd.toNumber(surd.div(n(12), of(3, 1, 1, 9)))).toBe(2);
    expect(() => surd.div(n(1), of(3, -1, 1, 9))).toThrow('division by an exact zero');
  });

  test('they combine with any other root, and have a root of their own', () => {
    equal(surd.sub(surd.add(of(0, 1, 1, 9), sqrt2), sqrt2), n(3));
    equal(surd.sub(surd.add(sqrt2, of(0, 1, 1, 0.25)), sqrt2), n(0.5));
    equal(surd.sqrt(of(1, 1, 1, 9)), n(2));
  });
});

describe('what does not combine', () => {
  test('is refused by name', () => {
    expect(() => surd.add(sqrt2, surd.sqrt(n(3)))).toThrow('√2 and √3');
    expect(() => surd.mul(sqrt2, surd.sqrt(n(3)))).toThrow(RangeError);
    expect(() => surd.sqrt(surd.add(n(1), sqrt2))).toThrow('irrational');
    expect(() => surd.sqrt(n(-1))).toThrow('negative');
    expect(() => surd.div(n(1), n(0))).toThrow('zero');
    expect(() => of(1, 1, 0, 2)).toThrow('denominator');
    expect(() => of(1, 1, 1, -2)).toThrow('D ≥ 0, got -2');
    expect(() => n(Infinity)).toThrow('Infinity');
  });

  test('value-equal roots are the same root, whatever their form', () => {
    equal(surd.sub(sqrt2, { ...sqrt2, D: { m: 8n, e: -2 } }), n(0));
  });
});

test('the arithmetic evaluates (−b + √(b² − c))·½ and back', () => {
  const { of, add, sub, mul, div, neg, sqr, sqrt, sign, toNumber } = exact;
  const [b, c] = [of(-7), of(0.1)];
  const t = div(add(neg(b), sqrt(sub(sqr(b), c))), of(2));
  const residual = sub(mul(t, add(t, b)), div(neg(c), of(4)));
  expect(sign(residual)).toBe(0);
  expect(Object.is(toNumber(residual), 0)).toBe(true);
});
