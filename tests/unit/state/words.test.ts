import { describe, expect, test } from 'vitest';
import { intersect } from '../../../src/math/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { hitSentence, hitWords, verdictWords } from '../../../src/state/words.ts';
import { circle, cone, cylinder, hyperboloid, plane, ray, square } from '../math/shorthand.ts';

const O: Vec3 = [0, 0, 0];
const said = (shape: Shape, r: Ray, method = 'exact') => {
  const found = intersect(shape, r, method);
  const { relations, text } = verdictWords(found, shape, r);
  const symbols = relations.map(({ left, relation, right }) => `${left} ${relation} ${right}`);
  return { symbols: symbols.join(', '), text, hits: hitWords(found).map(hitSentence) };
};

interface Case {
  readonly name: string;
  readonly shape: Shape;
  readonly ray: Ray;
  readonly symbols: string;
  readonly text: string;
  readonly hits: readonly string[];
}

const CURVED: readonly Case[] = [
  {
    name: 'cylinder, ahead',
    shape: cylinder(O, 1),
    ray: ray([3, 0, 0], [-1, 0, 0]),
    symbols: 'D > 0',
    text: 'two points: the ray enters, then leaves',
    hits: ['t₁ = 2, first hit, enters', 't₂ = 4, leaves'],
  },
  {
    name: 'cylinder, from inside',
    shape: cylinder(O, 1),
    ray: ray([0.5, 0, 0], [-1, 0, 0]),
    symbols: 'D > 0',
    text: 'two points: E is inside, the ray leaves',
    hits: ['t₁ = −0.5, behind E', 't₂ = 1.5, first hit, leaves'],
  },
  {
    name: 'cylinder, behind',
    shape: cylinder(O, 1),
    ray: ray([3, 0, 0], [1, 0, 0]),
    symbols: 'D > 0',
    text: 'two points, both behind E: the ray itself misses',
    hits: ['t₁ = −4, behind E', 't₂ = −2, behind E'],
  },
  {
    name: 'cylinder, E on it, inwards',
    shape: cylinder(O, 1),
    ray: ray([1, 0, 0], [-1, 0, 0]),
    symbols: 'D > 0',
    text: 'two points: the ray enters at E itself, then leaves',
    hits: ['t₁ = 0, E itself, enters', 't₂ = 2, leaves'],
  },
  {
    name: 'cylinder, E on it, outwards',
    shape: cylinder(O, 1),
    ray: ray([1, 0, 0], [1, 0, 0]),
    symbols: 'D > 0',
    text: 'two points: one behind E, one at E itself, where the ray leaves',
    hits: ['t₁ = −2, behind E', 't₂ = 0, E itself, leaves'],
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
    name: 'cylinder, tangent behind',
    shape: cylinder(O, 1),
    ray: ray([3, 0, 1], [1, 0, 0]),
    symbols: 'D = 0',
    text: 'tangent: one double root, behind E',
    hits: ['t₁ = −3, behind E'],
  },
  {
    name: 'cylinder, missed',
    shape: cylinder(O, 1),
    ray: ray([3, 0, 2], [-1, 0, 0]),
    symbols: 'D < 0',
    text: 'no point: the ray misses',
    hits: [],
  },
  {
    name: 'cylinder, parallel, outside',
    shape: cylinder(O, 1),
    ray: ray([3, 0, 2], [0, 1, 0]),
    symbols: 'A = 0, B = 0',
    text: 'parallel to the axis, outside for ever: no root',
    hits: [],
  },
  {
    name: 'cylinder, parallel, inside',
    shape: cylinder(O, 1),
    ray: ray([0.5, 0, 0], [0, 1, 0]),
    symbols: 'A = 0, B = 0',
    text: 'parallel to the axis, inside for ever: no root',
    hits: [],
  },
  {
    name: 'cylinder, contained',
    shape: cylinder(O, 1),
    ray: ray([1, 0, 0], [0, 1, 0]),
    symbols: 'A = 0, B = 0, C = 0',
    text: 'the whole line lies in the surface: every t is a root',
    hits: [],
  },
  {
    name: 'cylinder of radius 0',
    shape: cylinder(O, 0),
    ray: ray([3, 0, 0], [-1, 0, 0]),
    symbols: 'D = 0',
    text: 'through the axis: one double root, no normal there',
    hits: ['t₁ = 3, first hit, double, no normal'],
  },
  {
    name: 'cone, from one nappe into the other',
    shape: cone(O, 1),
    ray: ray([1, -5, 0], [0, 1, 0]),
    symbols: 'D > 0',
    text: 'two points: the ray leaves, then enters again',
    hits: ['t₁ = 4, first hit, leaves', 't₂ = 6, enters'],
  },
  {
    name: 'cone, between the nappes',
    shape: cone(O, 1),
    ray: ray([1, 0, 0], [0, 1, 0]),
    symbols: 'D > 0',
    text: 'two points: one behind E, one where the ray enters',
    hits: ['t₁ = −1, behind E', 't₂ = 1, first hit, enters'],
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
    name: 'cone, through the vertex, behind',
    shape: cone(O, 1),
    ray: ray([3, 0, 0], [1, 0, 0]),
    symbols: 'D = 0',
    text: 'through the vertex, behind E: one double root, no normal there',
    hits: ['t₁ = −3, behind E'],
  },
  {
    name: 'cone, parallel to a generator, entering',
    shape: cone(O, 1),
    ray: ray([3, 1, 0], [-1, -1, 0]),
    symbols: 'A = 0',
    text: 'parallel to a generator: one point, where the ray enters',
    hits: ['t₁ = 2, first hit, enters'],
  },
  {
    name: 'cone, parallel to a generator, behind',
    shape: cone(O, 1),
    ray: ray([3, 1, 0], [1, 1, 0]),
    symbols: 'A = 0',
    text: 'parallel to a generator: one point, behind E: the ray stays outside for ever',
    hits: ['t₁ = −2, behind E'],
  },
  {
    name: 'cone, in the plane that touches it',
    shape: cone(O, 1),
    ray: ray([2, 2, 3], [1, 1, 0]),
    symbols: 'A = 0, B = 0',
    text: 'parallel to a generator, outside for ever: no root',
    hits: [],
  },
  {
    name: 'hyperboloid, along an asymptote',
    shape: hyperboloid(O, 1, 1),
    ray: ray([2, 2, 0], [1, 1, 0]),
    symbols: 'A = 0, B = 0',
    text: 'parallel to a generator, inside for ever: no root',
    hits: [],
  },
  {
    name: 'hyperboloid of radius 0, through its centre',
    shape: hyperboloid(O, 1, 0),
    ray: ray([3, 0, 0], [-1, 0, 0]),
    symbols: 'D = 0',
    text: 'through the vertex: one double root, no normal there',
    hits: ['t₁ = 3, first hit, double, no normal'],
  },
];

const FLAT: readonly Case[] = [
  {
    name: 'plane',
    shape: plane([0, 1, 0], O),
    ray: ray([0, 3, 0], [1, -1, 0]),
    symbols: 'N.d ≠ 0',
    text: 'one point',
    hits: ['t₁ = 3, first hit'],
  },
  {
    name: 'plane behind',
    shape: plane([0, 1, 0], O),
    ray: ray([0, 3, 0], [1, 1, 0]),
    symbols: 'N.d ≠ 0',
    text: 'one point, behind E',
    hits: ['t₁ = −3, behind E'],
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
    name: 'plane, parallel',
    shape: plane([0, 1, 0], O),
    ray: ray([0, 3, 0], [1, 0, 0]),
    symbols: 'N.d = 0',
    text: 'parallel to the plane, beside it: no point',
    hits: [],
  },
  {
    name: 'plane, in it',
    shape: plane([0, 1, 0], O),
    ray: ray([0, 0, 0], [1, 0, 0]),
    symbols: 'N.d = 0, N.(E-P) = 0',
    text: 'the line lies in the plane: no single point',
    hits: [],
  },
  {
    name: 'circle, inside',
    shape: circle([0, 1, 0], O, 1),
    ray: ray([0.5, 3, 0], [0, -1, 0]),
    symbols: 'N.d ≠ 0',
    text: 'one point, inside the circle',
    hits: ['t₁ = 3, first hit'],
  },
  {
    name: 'circle, outside',
    shape: circle([0, 1, 0], O, 1),
    ray: ray([1.125, 3, 0], [0, -1, 0]),
    symbols: 'N.d ≠ 0',
    text: 'the plane is met 0.125 outside the circle: no point',
    hits: ['t₁ = 3, outside by 0.125'],
  },
  {
    name: 'circle, outside and behind',
    shape: circle([0, 1, 0], O, 1),
    ray: ray([1.125, 3, 0], [0, 1, 0]),
    symbols: 'N.d ≠ 0',
    text: 'the plane is met 0.125 outside the circle, behind E: no point',
    hits: ['t₁ = −3, outside by 0.125'],
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
    name: 'circle, in its plane, crossing',
    shape: circle([0, 1, 0], O, 1),
    ray: ray([3, 0, 0], [1, 0, 0]),
    symbols: 'N.d = 0, N.(E-P) = 0',
    text: 'the line lies in the plane and in the circle from t = −4 to t = −2, all of it behind E',
    hits: [],
  },
  {
    name: 'circle, in its plane, beside',
    shape: circle([0, 1, 0], O, 1),
    ray: ray([3, 0, 2], [1, 0, 0]),
    symbols: 'N.d = 0, N.(E-P) = 0',
    text: 'the line lies in the plane and passes beside the circle: no point of it',
    hits: [],
  },
  {
    name: 'square, inside',
    shape: square([1, 2, 3], 2, 'z'),
    ray: ray([2, 3, 5], [0, 0, -2]),
    symbols: 'N.d ≠ 0',
    text: 'one point, inside the square',
    hits: ['t₁ = 1, first hit'],
  },
  {
    name: 'square, off its corner',
    shape: square([1, 2, 3], 2, 'z'),
    ray: ray([6, 8, 5], [0, 0, -2]),
    symbols: 'N.d ≠ 0',
    text: 'the plane is met 5 outside the square: no point',
    hits: ['t₁ = 1, outside by 5'],
  },
  {
    name: 'square, parallel',
    shape: square([1, 2, 3], 2, 'z'),
    ray: ray([6, 8, 5], [1, 0, 0]),
    symbols: 'N.d = 0',
    text: 'parallel to the plane, beside it: no point',
    hits: [],
  },
  {
    name: 'square, in its plane, beside',
    shape: square([1, 2, 3], 2, 'z'),
    ray: ray([6, 8, 3], [1, 0, 0]),
    symbols: 'N.d = 0, N.(E-P) = 0',
    text: 'the line lies in the plane and passes beside the square: no point of it',
    hits: [],
  },
];

describe('verdict and hits in words', () => {
  test.each([...CURVED, ...FLAT])('$name', ({ shape, ray: r, symbols, text, hits }) => {
    expect(said(shape, r)).toEqual({ symbols, text, hits });
  });

  test('a method that cannot decide says so', () => {
    const overflow = said(cylinder(O, 1e200), ray([2e200, 0, 0], [-1e200, 0, 0]), 'textbook');
    expect(overflow).toEqual({
      symbols: '',
      text: 'cannot decide: a number overflowed',
      hits: [],
    });
    const flat = said(plane([1e200, 0, 0], O), ray([1e200, 0, 0], [1e200, 0, 0]), 'textbook');
    expect(flat.text).toBe('cannot decide: a number overflowed');
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
