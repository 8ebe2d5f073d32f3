import Decimal from 'decimal.js';
import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { type TypedNumber, typed } from '../../../../src/math/arithmetic/typed.ts';

const SEED = 14142;
const Wide = Decimal.clone({ precision: 80 });

/** √(n/d), exactly and to 80 digits. */
const rooted = (n: number, d: number): readonly [TypedNumber, Decimal] => [
  typed.sqrt(typed.div(typed.of(n), typed.of(d))),
  new Wide(n).div(d).sqrt(),
];

const root = fc
  .tuple(fc.integer({ min: 1, max: 60 }), fc.integer({ min: 1, max: 12 }))
  .map(([n, d]) => rooted(n, d));

/** Every digit of a double: the library reads a number by its shortest text. */
const wide = (x: number): Decimal => new Wide(x.toPrecision(100));

/** Whether x is within the bounds, or is the exact number. */
function holds(x: TypedNumber, value: Decimal): boolean {
  if ('lo' in x) return value.gte(wide(x.lo)) && value.lte(wide(x.hi));
  const off = value.minus(wide(typed.toNumber(x))).abs();
  return off.lte(value.abs().times(2 ** -52));
}

describe('numbers that hold more roots than one', () => {
  test(`are held by their bounds, seed ${SEED}`, () => {
    fc.assert(
      fc.property(root, root, root, ([a, x], [b, y], [c, z]) => {
        expect(holds(typed.add(a, b), x.plus(y))).toBe(true);
        expect(holds(typed.mul(a, b), x.times(y))).toBe(true);
        expect(holds(typed.div(typed.sub(a, b), c), x.minus(y).div(z))).toBe(true);
        const sum = typed.sub(typed.add(a, b), c);
        const sign = typed.sign(sum);
        if (!Number.isNaN(sign)) {
          expect(sign).toBe(x.plus(y).minus(z).abs().lt('1e-60') ? 0 : x.plus(y).cmp(z));
        }
      }),
      { seed: SEED, numRuns: 500 },
    );
  });

  test.each([
    [3, 2],
    [2, 3],
    [2_000_001, 2_000_000],
    [10 ** 15 + 1, 10 ** 15],
    [10 ** 15, 10 ** 15 + 1],
  ])('√%d − √%d has its sign and its digits', (n, m) => {
    const [[a, x], [b, y]] = [rooted(n, 1), rooted(m, 1)];
    const difference = typed.sub(a, b);
    expect(typed.sign(difference)).toBe(n > m ? 1 : -1);
    const exact = x.minus(y);
    expect(exact.minus(typed.toNumber(difference)).div(exact).abs().lt(1e-14)).toBe(true);
  });

  test('are not told apart where their bounds hold both', () => {
    const [[a], [b]] = [rooted(2, 1), rooted(3, 1)];
    const nested = typed.sqrt(typed.add(typed.of(5), typed.mul(typed.of(2), rooted(6, 1)[0])));
    expect(typed.sign(typed.sub(typed.add(a, b), nested))).toBeNaN();
  });

  test('√8 and √2 are over one root', () => {
    const [[a], [b]] = [rooted(8, 1), rooted(2, 1)];
    expect(typed.sign(typed.sub(a, typed.mul(typed.of(2), b)))).toBe(0);
  });
});
