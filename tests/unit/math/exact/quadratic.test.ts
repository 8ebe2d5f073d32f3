import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { fromNumber } from '../../../../src/math/exact/dyadic.ts';
import * as surd from '../../../../src/math/exact/surd.ts';
import { nextDown, nextUp } from '../../../../src/math/float/ulp.ts';
import { seeded, wide } from '../../../../src/math/rng.ts';
import { roundedRoots, solveExact } from './solve-exact.ts';

const solve = (A: number, B: number, C: number) =>
  solveExact(fromNumber(A), fromNumber(B), fromNumber(C));
const roots = (A: number, B: number, C: number) => roundedRoots(solve(A, B, C));

describe('meaning', () => {
  test.each([
    [1, -3, 2, 'two', 2, 1, [1, 2]],
    [-1, 3, -2, 'two', 2, 1, [1, 2]],
    [1, -2, 1, 'tangent', 2, 0, [1]],
    [-4, -4, -1, 'tangent', 2, 0, [-0.5]],
    [1, 0, 1, 'none', 2, -1, []],
    [0, 2, -3, 'one', 1, 1, [1.5]],
    [0, 2, 0, 'one', 1, 1, [0]],
    [0, 0, 5, 'none', 0, 0, []],
    [0, 0, 0, 'contained', 0, 0, []],
    [2, 0, 0, 'tangent', 2, 0, [0]],
    [2, -3, 0, 'two', 2, 1, [0, 1.5]],
    [2, 3, 0, 'two', 2, 1, [-1.5, 0]],
  ] as const)('%d t² + %d t + %d: %s', (A, B, C, name, degree, sign, want) => {
    const solution = solve(A, B, C);
    expect(solution).toMatchObject({ class: name, degree, discriminantSign: sign });
    const got = roundedRoots(solution);
    expect(got.length).toBe(want.length);
    for (const [i, t] of got.entries()) expect(Object.is(t, want[i])).toBe(true);
  });
});

describe('one step beside a tangent', () => {
  test('C decides between two, tangent and none', () => {
    expect(solve(1, -2, nextDown(1)).class).toBe('two');
    expect(solve(1, -2, nextUp(1)).class).toBe('none');
    expect(solve(1, nextDown(-2), 1).class).toBe('two');
    expect(solve(nextUp(1), -2, 1).class).toBe('none');
  });

  test('two roots that round to one double stay two', () => {
    // D = 2^-156: the roots differ by 2^-78 / 2^78.
    const [A, B] = [2 ** 78, -(2 ** 79)];
    const solution = solveExact(fromNumber(A), fromNumber(B), { m: (1n << 234n) - 1n, e: -156 });
    expect(solution.class).toBe('two');
    expect(roundedRoots(solution)).toEqual([1, 1]);
    const [first, second] = solution.roots;
    expect(first && second && surd.compare(first, second)).toBe(-1);
  });
});

test('roots beyond and below the doubles keep their place and sign', () => {
  expect(roots(1e-300, 1e300, 0)).toEqual([-Infinity, 0]);
  expect(roots(-1e-300, 1e300, 0)).toEqual([0, Infinity]);
  expect(roots(5e-324, 1.7e308, 5e-324)).toEqual([-Infinity, -0]);
  expect(roots(0, 1e200, 1e-200)).toEqual([-0]);
  expect(roots(0, -1e200, 1e-200)).toEqual([0]);
});

test('roots ascend and are zeros exactly, 3000 triples of every exponent (seed 12)', () => {
  const random = seeded(12);
  let two = 0;
  for (let i = 0; i < 3000; i++) {
    const [A, B, C] = [wide(random), wide(random), wide(random)];
    const { class: name, roots } = solve(A, B, C);
    const f = (t: surd.Surd) => surd.add(surd.mul(surd.add(surd.mul(n(A), t), n(B)), t), n(C));
    const [first, second] = roots;
    for (const t of roots) expect(surd.isZero(f(t))).toBe(true);
    if (first && second) {
      two++;
      expect(surd.compare(first, second)).toBe(-1);
    }
    expect(name).toBe(first ? 'two' : 'none');
  }
  expect(two).toBeGreaterThan(2000);
});

const n = surd.fromNumber;

interface Case {
  source: string;
  A: number;
  B: number;
  C: number;
  class: string;
  roots: (number | string)[];
}
const url = new URL('../../../vectors/quadratics.json', import.meta.url);
const cases: Case[] = JSON.parse(readFileSync(url, 'utf8'));

describe(`${cases.length} published triples, bit for bit`, () => {
  test('the file is whole', () => expect(cases.length).toBe(117));
  test.each(cases)('$A, $B, $C: $class ($source)', (c) => {
    const solution = solve(c.A, c.B, c.C);
    expect(solution.class).toBe(c.class);
    const got = roundedRoots(solution);
    expect(got.length).toBe(c.roots.length);
    for (const [i, t] of got.entries()) expect(Object.is(t, Number(c.roots[i]))).toBe(true);
  });
});
