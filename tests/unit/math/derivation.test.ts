import { describe, expect, test } from 'vitest';
import { float64 } from '../../../src/math/arithmetic/float64.ts';
import { derivation } from '../../../src/math/derivation.ts';
import { evaluate } from '../../../src/math/formula/evaluate.ts';
import { intersect } from '../../../src/math/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { unitVector } from '../../../src/math/unit.ts';
import { circle, cone, cylinder, plane, ray, roots, square } from './shorthand.ts';

const explain = (shape: Shape, r: Ray, method = 'textbook') => {
  const found = intersect(shape, r, method);
  return { found, ...derivation(shape, r, found) };
};

describe('the named steps', () => {
  test('of a curved shape: A, B, C, D, t, with the kernel’s own numbers', () => {
    const { steps, found, numbers } = explain(cone([0, 0, 0], 0.5), ray([4, 4, 0], [-1, 0, 0]));
    expect(steps.map(({ id, value }) => [id, value])).toEqual([
      ['A', 1],
      ['B', -8],
      ['C', 12],
      ['D', 16],
      ['t', null],
    ]);
    const [t] = steps.slice(-1);
    const both = [-1, 1] as const;
    expect(both.map((branch) => t && evaluate(t.expr, float64, numbers, branch))).toEqual(
      roots(found),
    );
    for (const { expr, value } of steps.slice(0, 4)) {
      expect(evaluate(expr, float64, numbers)).toBe(value);
    }
  });

  test('no t where there is no root', () => {
    const { steps } = explain(cylinder([0, 0, 0], 1), ray([5, 0, 5], [1, 0, 0]));
    expect(steps.map(({ id }) => id)).toEqual(['A', 'B', 'C', 'D']);
  });

  test('the formula for t is the one that was used: a line’s, a double root’s', () => {
    const tOf = (shape: Shape, r: Ray) => explain(shape, r).steps.at(-1)?.expr;
    const line = tOf(cone([0, 0, 0], 1), ray([3, 1, 0], [1, 1, 0]));
    expect(line).toMatchObject({ op: 'quotient', under: { id: 'B' } });
    const touching = tOf(cylinder([0, 0, 0], 2), ray([2, 3, 5], [0, 1, -2]));
    expect(touching).toMatchObject({ over: { op: 'negative' }, under: { op: 'product' } });
    const two = tOf(cylinder([0, 0, 0], 2), ray([1, 3, 5], [0, 1, -2]));
    expect(two).toMatchObject({ over: { op: 'plus-minus' } });
  });

  test('of a flat one: N·(E−P), N·d, t, and the conditions with both sides', () => {
    const down = ray([4, 3, 5], [0, 0, -1]);
    const { steps, conditions, f, numbers } = explain(square([1, 2, 3], 2, 'z'), down);
    expect(steps.map(({ id, value }) => [id, value])).toEqual([
      ['N.(E-P)', 2],
      ['N.d', -1],
      ['t', null],
    ]);
    expect(conditions.map(({ left, right, holds }) => [left, right, holds])).toEqual([
      [1, 4, true],
      [4, 3, false],
      [2, 3, true],
      [3, 4, true],
    ]);
    const at = (t: number) =>
      evaluate(f, float64, { ...numbers, scalars: { ...numbers.scalars, t } });
    expect([at(0), at(2)]).toEqual([2, 0]);
  });

  test('|X − C| against r', () => {
    const { conditions } = explain(circle([0, 0, 2], [1, 1, 5], 4.5), ray([0, 0, 1], [2, 2.5, 2]));
    expect(conditions).toHaveLength(1);
    expect(conditions[0]).toMatchObject({ left: 5, right: 4.5, holds: false });
  });

  test('parallel: no t, no conditions', () => {
    const { steps, conditions } = explain(square([1, 2, 3], 2, 'z'), ray([0, 0, 4], [1, 0, 0]));
    expect(steps.map(({ id }) => id)).toEqual(['N.(E-P)', 'N.d']);
    expect(conditions).toEqual([]);
    expect(explain(plane([0, 1, 0], [0, 0, 0]), ray([0, 1, 0], [0, -1, 0])).conditions).toEqual([]);
  });

  test('an intersection of another family is a mistake in the program', () => {
    const r = ray([0, 1, 0], [0, -1, 0]);
    const flat = intersect(plane([0, 1, 0], [0, 0, 0]), r);
    expect(() => derivation(cone([0, 0, 0], 1), r, flat)).toThrow(RangeError);
  });
});

describe('unitVector', () => {
  test.each([
    [
      [3, 4, 0],
      [0.6, 0.8, 0],
    ],
    [
      [0, -7, 0],
      [0, -1, 0],
    ],
    [
      [1, 2, -2],
      [1 / 3, 2 / 3, -2 / 3],
    ],
    [
      [3e300, 4e300, 0],
      [0.6, 0.8, 0],
    ],
    [
      [5e-324, 0, 0],
      [1, 0, 0],
    ],
    [
      [1, 1, 0],
      [Math.SQRT1_2, Math.SQRT1_2, 0],
    ],
  ] as const)('%j', (d, unit) => {
    expect(unitVector(d)).toEqual(unit);
  });
});
