import { describe, expect, test } from 'vitest';
import type { Interval } from '../../../../src/math/arithmetic/interval.ts';
import { interval } from '../../../../src/math/arithmetic/interval.ts';
import * as surd from '../../../../src/math/exact/surd.ts';
import { integer, type Random, seeded, wide } from '../../../../src/math/rng.ts';

const middle = (lo: number, hi: number): number => interval().toNumber({ lo, hi });

/** Narrow, wide, across 0, a point, or with an infinite end. */
function draw(random: Random): Interval {
  const a = wide(random, -40, 40);
  const b = [a, a * (1 + random()), wide(random, -40, 40), -a, Infinity, -Infinity, 0];
  const other = b[integer(random, 0, b.length - 1)] as number;
  return { lo: Math.min(a, other), hi: Math.max(a, other) };
}

/** A double of the interval: an end, or something between. */
function member(random: Random, { lo, hi }: Interval): number {
  const finite = (x: number): number => Math.max(-1e300, Math.min(1e300, x));
  const [a, b] = [finite(lo), finite(hi)];
  const k = random();
  return k < 0.3 ? a : k < 0.6 ? b : Math.max(a, Math.min(b, a + (b - a) * random()));
}

function holds({ lo, hi }: Interval, x: surd.Surd): boolean {
  const below = lo === -Infinity || surd.compare(surd.fromNumber(lo), x) <= 0;
  return below && (hi === Infinity || surd.compare(x, surd.fromNumber(hi)) <= 0);
}

const BINARY = {
  add: [interval().add, surd.add],
  sub: [interval().sub, surd.sub],
  mul: [interval().mul, surd.mul],
  div: [interval().div, surd.div],
} as const;

describe('every result of members is a member of the result', () => {
  test.each(Object.entries(BINARY))('%s (seed 31)', (_, [f, exactly]) => {
    const random = seeded(31);
    for (let i = 0; i < 5000; i++) {
      const a = draw(random);
      const b = draw(random);
      const x = member(random, a);
      const y = member(random, b);
      if (exactly === surd.div && y === 0) continue;
      const truth = exactly(surd.fromNumber(x), surd.fromNumber(y));
      expect(holds(f(a, b), truth), `${JSON.stringify([a, b])} at ${x}, ${y}`).toBe(true);
    }
  });

  test('neg, sqr and sqrt (seed 32)', () => {
    const random = seeded(32);
    for (let i = 0; i < 3000; i++) {
      const a = draw(random);
      const x = member(random, a);
      expect(holds(interval().neg(a), surd.fromNumber(-x))).toBe(true);
      expect(holds(interval().sqr(a), surd.sqr(surd.fromNumber(x)))).toBe(true);
      if (x >= 0) expect(holds(interval().sqrt(a), surd.sqrt(surd.fromNumber(x)))).toBe(true);
    }
  });
});

describe('and no wider than need be', () => {
  const span = (lo: number, hi: number): Interval => ({ lo, hi });
  test('a square is never negative, unlike a product', () => {
    expect(interval().sqr(span(-2, 3))).toEqual(span(0, 9));
    expect(interval().sqr(span(-3, -2))).toEqual(span(4, 9));
    expect(interval().mul(span(-2, 3), span(-2, 3))).toEqual(span(-6, 9));
  });
  test('signs of products and quotients', () => {
    expect(interval().mul(span(-2, 3), span(-5, 7))).toEqual(span(-15, 21));
    expect(interval().div(span(1, 2), span(-4, -0.5))).toEqual(span(-4, -0.25));
    expect(interval().div(span(1, 2), span(-1, 1))).toEqual(span(-Infinity, Infinity));
  });
  test('the sign is known, or it is not', () => {
    expect(interval().sign(span(1, 2))).toBe(1);
    expect(interval().sign(span(-2, -1))).toBe(-1);
    expect(interval().sign(span(0, 0))).toBe(0);
    expect(interval().sign(span(-0, 0))).toBe(0);
    expect(interval().sign(span(0, 1))).toBeNaN();
    expect(interval().sign(span(-1, 0))).toBeNaN();
    expect(interval().sign(span(-1, 1))).toBeNaN();
  });
  test('its number is the middle', () => {
    expect(middle(1, 2)).toBe(1.5);
    expect(middle(-0, -0)).toBe(0);
    expect(middle(Number.MAX_VALUE, Number.MAX_VALUE)).toBe(Number.MAX_VALUE);
    expect(middle(1e308, Number.MAX_VALUE)).toBeLessThan(Infinity);
    expect(middle(-Infinity, Infinity)).toBeNaN();
  });
});
