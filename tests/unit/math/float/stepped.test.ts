import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { stepped } from '../../../../src/math/float/stepped.ts';
import { nextDown, nextUp, ulpDistance } from '../../../../src/math/float/ulp.ts';

const finite = fc.double({ noNaN: true, noDefaultInfinity: true });
const count = fc.integer({ min: -(2 ** 50), max: 2 ** 50 });

describe('steps from double to double', () => {
  test('one step is the next double, in either direction', () => {
    fc.assert(
      fc.property(finite, (x) => {
        if (Math.abs(x) === Number.MAX_VALUE) return;
        // Which zero it is does not count.
        expect(ulpDistance(stepped(x, 1), nextUp(x))).toBe(0);
        expect(ulpDistance(stepped(x, -1), nextDown(x))).toBe(0);
      }),
    );
  });

  test('lead where they were counted, and back', () => {
    fc.assert(
      fc.property(finite, count, (x, n) => {
        const to = stepped(x, n);
        if (Math.abs(to) === Number.MAX_VALUE) return;
        expect(ulpDistance(x, to)).toBe(Math.abs(n));
        expect(Math.sign(to - x)).toBe(Math.sign(n));
        expect(stepped(to, -n) - x).toBe(0);
      }),
    );
  });

  test.each([
    [1, 3, 1 + 3 * 2 ** -52],
    [1, -3, 1 - 3 * 2 ** -53],
    [0, 1, 5e-324],
    [5e-324, -2, -5e-324],
    [-5e-324, 1, 0],
    [Number.MAX_VALUE, 5, Number.MAX_VALUE],
    [-1, -(2 ** 53 - 1), -4 + 2 ** -51],
  ])('%d, %d steps on: %d', (x, n, to) => expect(stepped(x, n)).toBe(to));

  test('none keeps the zero as it is', () => expect(stepped(-0, 0)).toBe(-0));

  test.each([
    [Number.NaN, 1],
    [Number.POSITIVE_INFINITY, 1],
    [1, 0.5],
    [1, 2 ** 53],
  ])('refuses %d and %d', (x, n) => expect(() => stepped(x, n)).toThrow(RangeError));
});
