import { describe, expect, test } from 'vitest';
import * as algebra from '../../../src/math/methods/certified/algebra.ts';
import { seeded } from '../../../src/math/rng.ts';
import { climb, DOUBLES, known, type Off, running } from './running-error.ts';

/*
 * As certified-derived.test.ts, for the one ray that is answered with points and normals: upper halves are exact with what they lost, so only sizes count. A
 * lower half is u of its upper one at most, and the products of two lower halves are left out.
 */
const SEED = 62;
const U = 2 ** -53;
const UU = U * U;
const { abs } = Math;
const { add, mul } = running(DOUBLES);
const total = (...xs: readonly Off[]): Off => xs.reduce(add);
/** What a rounded x lost. */
const low = (x: number): Off => known(U * abs(x));

/** The greatest share of a bound is below 1 and above 3/4, for `length` sizes that are 1 together. */
function tight(length: number, bound: number, off: (...at: readonly number[]) => number): void {
  const worst = climb(seeded(SEED), length, (at) => {
    const all = at.reduce((sum, x) => sum + abs(x), 0);
    return off(...at.map((x) => abs(x) / all));
  });
  expect(worst / bound).toBeLessThan(1);
  expect(worst / bound).toBeGreaterThan(0.75);
}

describe(`lower halves, and what adding them up may cost (seed ${SEED})`, () => {
  /** a·(y·y') of size y, where the lower half of y·y' is `inner`. */
  const flared = (y: number, inner: Off): Off =>
    add(low(y), add(mul(known(1), inner), mul(known(U), known(y))));

  test('A, of Am', () => {
    tight(3, algebra.ERROR_A, (x = 0, y = 0, z = 0) => {
      const A = total(low(x + z), low(x + y + z), add(low(x), low(z)), flared(y, low(y)));
      return A.off + UU * y;
    });
  });

  test('b, of bm', () => {
    /** x·p: its own lower half, and x times p's. */
    const product = (x: number): Off => add(low(x), mul(known(1), low(x)));
    tight(3, algebra.ERROR_B, (x = 0, y = 0, z = 0) => {
      const round = add(product(x), product(z));
      const b = total(low(x + z), low(x + y + z), round, flared(y, product(y)));
      return b.off + 3 * UU * y;
    });
  });

  test('C, of Cm', () => {
    const square = (x: number): Off => add(low(x), mul(known(1), low(2 * x)));
    tight(4, algebra.ERROR_C, (x = 0, y = 0, z = 0, rho = 0) => {
      const sums = total(low(x + z), low(x + y + z), low(x + y + z + rho), low(rho));
      const C = total(sums, add(square(x), square(z)), flared(y, square(y)));
      return C.off + UU * (x + z) + 4 * UU * y;
    });
  });

  test('D/4, of AmCm: the most where b² and |AC| are both of that size', () => {
    const { ERROR_A, ERROR_B, ERROR_C, ERROR_D } = algebra;
    const squared = add(low(1), mul(known(2), low(1)));
    const product = add(low(1), add(mul(known(1), low(1)), low(1)));
    const own = total(low(2), squared, product).off + 2 * UU;
    const share = (own + 2 * ERROR_B + ERROR_A + ERROR_C) / ERROR_D;
    expect(share).toBeLessThan(1);
    expect(share).toBeGreaterThan(0.75);
  });
});
