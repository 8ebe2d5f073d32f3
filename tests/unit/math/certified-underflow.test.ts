import { describe, expect, test } from 'vitest';
import { LEAST_EXACT_PRODUCT } from '../../../src/math/float/eft.ts';
import * as algebra from '../../../src/math/methods/certified/algebra.ts';
import * as byClass from '../../../src/math/methods/certified/class.ts';
import { DIRECT_ERROR, LEAST_A, momentError } from '../../../src/math/methods/certified/class.ts';
import * as places from '../../../src/math/methods/certified/hits.ts';
import { BOX, FAITHFUL } from '../../../src/math/methods/certified/numbers.ts';
import * as figure from '../../../src/math/methods/certified/planar.ts';
import { SMALLEST_PLANAR } from '../../../src/math/methods/certified/planar.ts';
import { SMALLEST as SMALLEST_DEPARTS } from '../../../src/tracer/departs.ts';
import { DOUBLES, known, type Off, running } from './running-error.ts';

/*
 * Absolute terms: what products that leave the doubles may cost where every number is as large as
 * the stage lets it be, so that what is lost is multiplied by the most. All sizes, so differences
 * are sums. Widening what a stage takes, or lessening its term, is seen here.
 */
/** Half of it is lost by a product, and the bound is rounded there too. */
const UNIT = Number.MIN_VALUE;
/** productError's 2^-1073, and the rounding of the product. */
const LOST = 2 ** -1072;
const of = (x: number, off = 0): Off => ({ x, off });
const losing = (lost: number) => running({ sum: 0, product: 0, lost });

/** The cost is covered, and half of the term would not do. */
function covers(term: number, cost: number): void {
  expect(cost / term).toBeLessThanOrEqual(1);
  expect(cost / term).toBeGreaterThan(0.5);
}

test('C from its exact terms', () => {
  const { LARGE } = algebra;
  const { add, mul, sqr } = losing(LOST / 2);
  const [p, low] = [of(1), of(1)];
  const squares = add(add(sqr(p), mul(p, low)), sqr(low));
  const [a, aLow] = [of(LARGE, LOST / 2), of(1)];
  const flared = add(mul(add(squares, squares), a), mul(add(squares, squares), aLow));
  const C = add(add(add(squares, squares), flared), of(1, LOST / 2));
  const ofFlare = LARGE * (LOST / 2);
  covers(algebra.SMALLEST_C, C.off + ofFlare);
});

test('of flat shapes: three products each, and a quotient within the range', () => {
  expect(SMALLEST_PLANAR).toBeGreaterThan(3 * LOST);
  covers(SMALLEST_PLANAR, FAITHFUL * BOX ** 2 * LEAST_EXACT_PRODUCT);
});

describe('in doubles', () => {
  const { add, mul, sqr } = losing(UNIT);

  test('classes by the direct form: D, and A where D is certain', () => {
    const { LARGEST, SMALLEST_DIRECT: SMALLEST } = byClass;
    const a = BOX ** 2;
    const round = 2 * UNIT;
    const lost = round + a * UNIT + UNIT;
    const [A, b, C] = [of(LARGEST, lost), of(LARGEST, lost), of(LARGEST, lost + UNIT)];
    expect(add(sqr(b), mul(A, C)).off).toBeLessThan(SMALLEST);
    // Of DIRECT_ERROR 4u are A's rounding, and there is room for as much again: Am is SMALLEST / 2
    // LARGEST at least, or D would not be certain.
    expect(DIRECT_ERROR).toBeGreaterThan(8 * 2 ** -53);
    covers(SMALLEST, (lost / (4 * 2 ** -53)) * 2 * LARGEST);
  });

  test('the moment (its term is larger, as the root by root stage needs)', () => {
    const y = of(BOX, mul(of(BOX), of(1)).off);
    const d = of(BOX);
    const minor = (u: Off, v: Off): Off => add(mul(u, v), mul(v, u));
    const m = [minor(y, d), minor(d, d), minor(d, y)] as const;
    const A = add(add(sqr(d), sqr(d)), sqr(y));
    const squares = add(add(sqr(m[0]), sqr(m[2])), sqr(m[1]));
    const D = add(mul(of(BOX ** 2, UNIT), A), squares);
    expect(D.off).toBeLessThan(momentError(0, 0, 0));
  });

  test('A where LEAST_A lets the later stages take it as known to 2^-30', () => {
    const doubles = running(DOUBLES);
    const y = known(1, 2 * 2 ** -53);
    const A = doubles.sub(known(0, 0), doubles.sqr(y));
    covers(2 ** -30, (A.off + 2 ** -53) / LEAST_A);
  });

  test('how far inside a square', () => {
    covers(
      figure.SMALLEST_FIGURE,
      add(mul(of(1), of(1)), add(mul(of(1), of(1)), mul(of(1), of(1)))).off,
    );
  });

  test('which way a ray departs', () => {
    covers(SMALLEST_DEPARTS, 3 * UNIT);
  });
});

test('points from a faithful root: F, its slope, and a step below the doubles', () => {
  const { add, mul, sqr } = losing(LOST);
  const { WIDE, SMALLEST_PLACE: SMALLEST } = places;
  const g = of(WIDE, LOST);
  const a = of(WIDE ** 2, LOST);
  const F = add(add(add(sqr(g), sqr(g)), mul(a, sqr(g))), of(WIDE ** 2, LOST));
  covers(SMALLEST, F.off);
  const d = of(2 ** 106);
  expect(2 * add(add(mul(g, d), mul(g, d)), mul(a, mul(g, d))).off).toBeLessThan(SMALLEST);
  const N = of(WIDE);
  expect(add(add(mul(N, g), mul(N, g)), mul(N, g)).off).toBeLessThan(SMALLEST);
  // A product that is split, and one that is rounded.
  covers(places.LOST_PLACE, 2 * UNIT + UNIT);
  // Half a unit for the quotient and for each of three terms of its bound, and of τ's unit the half
  // that 2η is: two and a half.
  covers(places.TINY, 3 * UNIT);
});

test('A, b, C and D/4 of one ray', () => {
  const { LARGE, SMALLEST_ALGEBRA: SMALLEST, SMALLEST_ALGEBRA_D: SMALLEST_D } = algebra;
  const { add, mul, sqr } = losing(LOST);
  // a·(y·y'), with a's lower half; then three products more.
  const flared = mul(of(LARGE, LOST), of(1, LOST));
  const lost = flared.off + 3 * LOST;
  covers(SMALLEST, lost);
  const size = of(LARGE, lost);
  covers(SMALLEST_D, add(sqr(size), mul(size, size)).off);
  expect(SMALLEST / FAITHFUL).toBeGreaterThan(LEAST_EXACT_PRODUCT);
  expect(SMALLEST_D / FAITHFUL).toBeGreaterThan(LEAST_EXACT_PRODUCT);
});
