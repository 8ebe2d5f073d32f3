import { describe, expect, test } from 'vitest';
import { nextDown, nextUp, ulpDistance } from '../../../../src/math/float/ulp.ts';
import { seeded, wide } from '../../../../src/math/rng.ts';

const MIN = Number.MIN_VALUE;
const MAX = Number.MAX_VALUE;

describe('nextUp and nextDown', () => {
  test('by hand', () => {
    expect(nextUp(1)).toBe(1 + 2 ** -52);
    expect(nextDown(1)).toBe(1 - 2 ** -53);
    expect(nextUp(0)).toBe(MIN);
    expect(nextUp(-0)).toBe(MIN);
    expect(nextDown(0)).toBe(-MIN);
    expect(nextUp(-MIN)).toBe(-0);
    expect(nextDown(MIN)).toBe(0);
    expect(nextUp(2 ** -1022 - MIN)).toBe(2 ** -1022);
  });

  test('carry across the low word', () => {
    expect(nextUp(1 + 2 ** -20 - 2 ** -52)).toBe(1 + 2 ** -20);
    expect(nextDown(1 + 2 ** -20)).toBe(1 + 2 ** -20 - 2 ** -52);
  });

  test('at the ends', () => {
    expect(nextUp(MAX)).toBe(Infinity);
    expect(nextDown(Infinity)).toBe(MAX);
    expect(nextUp(-Infinity)).toBe(-MAX);
    expect(nextUp(Infinity)).toBe(Infinity);
    expect(nextDown(-Infinity)).toBe(-Infinity);
    expect(nextUp(Number.NaN)).toBeNaN();
  });
});

describe('ulpDistance', () => {
  test.each([
    [1, 1, 0],
    [0, -0, 0],
    [1, 1 + 2 ** -52, 1],
    [1, 1 - 2 ** -53, 1],
    [1, 2, 2 ** 52],
    [-MIN, MIN, 2],
    [-0, MIN, 1],
    [-3 * MIN, 4 * MIN, 7],
    [MAX, Infinity, 1],
    [-MAX, -Infinity, 1],
    [0, Infinity, 0x7ff * 2 ** 52],
    [-Infinity, Infinity, 0xffe * 2 ** 52],
    [Infinity, Infinity, 0],
    [1 + 2 ** -20, 1 + 2 ** -20 - 2 ** -52, 1],
  ])('from %d to %d: %d', (a, b, steps) => {
    expect(ulpDistance(a, b)).toBe(steps);
    expect(ulpDistance(b, a)).toBe(steps);
  });

  test('NaN has no place on the line', () => {
    expect(ulpDistance(Number.NaN, 1)).toBeNaN();
    expect(ulpDistance(1, Number.NaN)).toBeNaN();
  });

  test('nextUp is one step, two are two, 20000 doubles of every exponent (seed 2)', () => {
    const random = seeded(2);
    for (let i = 0; i < 20000; i++) {
      const x = wide(random);
      const [below, above] = [nextDown(x), nextUp(x)];
      const steps = ulpDistance(x, above) === 1 && ulpDistance(below, above) === 2;
      if (!(below < x && x < above && steps && nextDown(above) === x)) expect.fail(`${x}`);
    }
  });
});
