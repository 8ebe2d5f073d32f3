import { describe, expect, test } from 'vitest';
import { intersect } from '../../../src/math/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { hitSentences, hitWords, verdictWords } from '../../../src/state/verdict-words.ts';
import { circle, cone, cylinder, plane, ray, square } from '../math/shorthand.ts';

/* Whether the sentences are true is asked in verdict-cells.test.ts. */

const O: Vec3 = [0, 0, 0];
const said = (shape: Shape, r: Ray, method = 'exact') => {
  const found = intersect(shape, r, method);
  const { relations, text } = verdictWords(found, shape, r);
  const symbols = relations.map(({ left, relation, right }) => `${left} ${relation} ${right}`);
  return { symbols: symbols.join(', '), text, hits: hitSentences(hitWords(found)) };
};

interface Case {
  readonly name: string;
  readonly shape: Shape;
  readonly ray: Ray;
  readonly symbols: string;
  readonly text: string;
  readonly hits: readonly string[];
}

const CASES: readonly Case[] = [
  {
    name: 'cylinder, from inside',
    shape: cylinder(O, 1),
    ray: ray([0.5, 0, 0], [-1, 0, 0]),
    symbols: 'D > 0',
    text: 'two points: E is inside, the ray leaves',
    hits: ['t₁ = −0.5, behind E', 't₂ = 1.5, first hit, leaves'],
  },
  {
    name: 'cylinder, tangent',
    shape: cylinder(O, 1),
    ray: ray([3, 0, 1], [-1, 0, 0]),
    symbols: 'D = 0',
    text: 'tangent: one double root, the ray touches',
    hits: ['t₁ = 3, first hit, double, touches'],
  },
  {
    name: 'cone, through the vertex',
    shape: cone(O, 1),
    ray: ray([3, 0, 0], [-1, 0, 0]),
    symbols: 'D = 0',
    text: 'through the vertex: one double root, no normal there',
    hits: ['t₁ = 3, first hit, double, no normal'],
  },
  {
    name: 'cone of slope 0',
    shape: cone(O, 0),
    ray: ray([3, 2, 0], [-1, 0, 0]),
    symbols: 'D = 0',
    text: 'through the axis: one double root, no normal there',
    hits: ['t₁ = 3, first hit, double, no normal'],
  },
  {
    name: 'plane, E in it',
    shape: plane([0, 1, 0], O),
    ray: ray([1, 0, 0], [1, 1, 0]),
    symbols: 'N.d ≠ 0',
    text: 'one point, at E itself',
    hits: ['t₁ = 0, E itself, in the plane'],
  },
  {
    name: 'circle, hardly outside: never 0',
    shape: circle([0, 1, 0], O, 1),
    ray: ray([1, 3, 1e-10], [0, -1, 0]),
    symbols: 'N.d ≠ 0',
    text: 'the plane is met 5 · 10⁻²¹ outside the circle: no point',
    hits: ['t₁ = 3, outside by 5 · 10⁻²¹'],
  },
  {
    name: 'circle, in its plane',
    shape: circle([0, 1, 0], O, 1),
    ray: ray([3, 0, 0], [-1, 0, 0]),
    symbols: 'N.d = 0, N.(E-P) = 0',
    text: 'the line lies in the plane and in the circle from t = 2 to t = 4',
    hits: [],
  },
  {
    name: 'square, off its corner',
    shape: square([1, 2, 3], 2, 'z'),
    ray: ray([6, 8, 5], [0, 0, -2]),
    symbols: 'N.d ≠ 0',
    text: 'the plane is met 5 outside the square: no point',
    hits: ['t₁ = 1, outside by 5'],
  },
];

describe('verdict and hits in words', () => {
  test.each(CASES)('$name', ({ shape, ray: r, symbols, text, hits }) => {
    expect(said(shape, r)).toEqual({ symbols, text, hits });
  });

  test('a method that cannot decide says why', () => {
    const overflow = said(cylinder(O, 1e200), ray([2e200, 0, 0], [-1e200, 0, 0]), 'textbook');
    expect(overflow).toEqual({
      symbols: '',
      text: 'cannot decide: a number overflowed',
      hits: [],
    });
    const flat = said(plane([1e200, 0, 0], O), ray([1e200, 0, 0], [1e200, 0, 0]), 'textbook');
    expect(flat.text).toBe('cannot decide: a number overflowed');
    const close = said(cylinder(O, 0.1), ray([3, 0, 0.1], [-0.7, 0, 0]), 'interval');
    expect(close.text).toBe('cannot decide: the sign of D is not certain');
  });

  test('a root that is rounded to 0 is not at E itself', () => {
    const hardly = (E: number) => ray([0, E, 0], [0, -1e300, 0]);
    expect(said(plane([0, 1, 0], O), hardly(5e-324)).hits).toEqual(['t₁ = 0, first hit']);
    expect(said(plane([0, 1, 0], O), hardly(-5e-324))).toMatchObject({
      text: 'one point, behind E',
      hits: ['t₁ = 0, behind E'],
    });
    const within = ray([1 - 2 ** -53, 0, 0], [1e308, 0, 0]);
    expect(said(cylinder(O, 1), within).text).toBe('two points: E is inside, the ray leaves');
    const wall = ray([-(2 ** -1000), 0, 0], [2 ** 1000, 0, 0]);
    expect(said(cylinder([2 ** -1000, 0, 0], 2 ** -1001), wall).text).toBe(
      'two points: the ray enters, then leaves',
    );
  });

  test('between two visits the second hit is the first one ahead', () => {
    const roles = hitWords(intersect(cone(O, 1), ray([1, 0, 0], [0, 1, 0]))).map(
      ({ role }) => role,
    );
    expect(roles).toEqual(['behind', 'first']);
    const both = hitWords(intersect(cylinder(O, 1), ray([3, 0, 0], [-1, 0, 0])));
    expect(both.map(({ index, role }) => [index, role])).toEqual([
      [1, 'first'],
      [2, 'other'],
    ]);
  });
});
