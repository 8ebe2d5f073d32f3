import { describe, expect, test } from 'vitest';
import * as dy from '../../../src/math/exact/dyadic.ts';
import { nextDown, nextUp } from '../../../src/math/float/ulp.ts';
import { FAITHFUL } from '../../../src/math/methods/certified/numbers.ts';

/*
 * What is off by FAITHFUL of itself and a little more (as the bound is worked out in doubles), is
 * still between the neighbours of the double it is rounded to.
 */

const n = dy.fromNumber;
const OFF = dy.mul(n(FAITHFUL), n(1 + 2 ** -49));

describe('hi + lo, off by FAITHFUL, where that is most against the gap to the next double', () => {
  test.each([
    ['just below a power of two, away from 0', 2 - 2 ** -52, 2 ** -53 * (1 - 2 ** -53)],
    ['a power of two, towards 0', 1, -(2 ** -54)],
    ['a power of two, away from 0', 1, 2 ** -53],
    ['in between', 1.5, 2 ** -53],
  ])('%s', (_, hi, lo) => {
    expect(hi + lo).toBe(hi);
    const sum = dy.add(n(hi), n(lo));
    const off = dy.mul(sum, OFF);
    const [least, most] = [dy.sub(sum, off), dy.add(sum, off)];
    expect(dy.compare(n(nextDown(hi)), least)).toBe(-1);
    expect(dy.compare(most, n(nextUp(hi)))).toBe(-1);
  });
});
