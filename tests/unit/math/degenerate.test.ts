import { describe, expect, test } from 'vitest';
import { nextDown, nextUp } from '../../../src/math/float/ulp.ts';
import { intersect } from '../../../src/math/index.ts';
import type { Intersection } from '../../../src/math/intersection.ts';
import { integer, seeded, wide } from '../../../src/math/rng.ts';
import { SHAPES, type Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { many } from '../many.ts';
import {
  circle,
  cone,
  curvedDetails,
  cylinder,
  exactly,
  flatDetails,
  hyperboloid,
  METHOD_IDS,
  plane,
  planeHit,
  ray,
  roots,
  square,
} from './shorthand.ts';

const O: Vec3 = [0, 0, 0];
const signsOf = (found: Intersection) => {
  const { A, B, C, D } = curvedDetails(found).signs;
  return [A, B, C, D];
};

describe('A = 0', () => {
  describe('cylinder, parallel to the axis', () => {
    test.each([
      ['outside', 3, 'none', 1],
      ['inside', 1, 'none', -1],
      ['on the surface', 2, 'contained', 0],
    ] as const)('%s', (_, x, verdict, signC) => {
      const found = exactly(cylinder(O, 2), ray([x, 5, 0], [0, -3, 0]));
      expect(found.class).toBe(verdict);
      expect(found.hits).toEqual([]);
      expect(signsOf(found)).toEqual([0, 0, signC, 0]);
    });
  });

  describe('cone, parallel to a generator', () => {
    test('crosses once: the near nappe only', () => {
      // c = ½, d = (1, 2, 0), p = (3, 0, 3): A = 1 − ¼·4 = 0, B = 6, C = 18, t = −18/6.
      const found = exactly(cone(O, 0.5), ray([3, 0, 3], [1, 2, 0]));
      expect(found.class).toBe('one');
      expect(found.hits).toEqual([
        { t: -3, point: [0, -6, 3], normal: [0, 1.5, 3], singular: false },
      ]);
      expect(signsOf(found)).toEqual([0, 1, 1, 1]);
    });

    test('in the plane that touches it along that generator: no root', () => {
      expect(exactly(cone(O, 0.5), ray([0, 0, 3], [1, 2, 0])).class).toBe('none');
    });

    test('along the generator itself: contained, through the vertex too', () => {
      expect(exactly(cone(O, 0.5), ray([1, 2, 0], [1, 2, 0])).class).toBe('contained');
      expect(exactly(cone(O, 0.5), ray(O, [1, 2, 0])).class).toBe('contained');
    });

    test('one ulp away from parallel is no longer A = 0', () => {
      const r = ray([3, 0, 3], [1, nextUp(2), 0]);
      const found = exactly(cone(O, 0.5), r);
      expect(found.class).toBe('two');
      // One root stays near −3, the other goes to +10¹⁶: A is about −2⁻⁵¹, B about 6.
      expect(found.hits[0]?.t).toBeCloseTo(-3, 9);
      expect(found.hits[1]?.t).toBeGreaterThan(1e16);
    });
  });

  describe('hyperboloid, parallel to an asymptote', () => {
    test('one root', () => {
      // a = 1, r = 1, d = (1, 1, 0), p = (3, 1, 0): A = 0, B = 6 − 2 = 4, C = 9 − 1 − 1 = 7, t =
      // −7/4.
      const found = exactly(hyperboloid(O, 1, 1), ray([3, 1, 0], [1, 1, 0]));
      expect(found.hits).toEqual([
        { t: -1.75, point: [1.25, -0.75, 0], normal: [1.25, 0.75, 0], singular: false },
      ]);
      expect(found.class).toBe('one');
    });

    test('along an asymptote: no root, inside for ever', () => {
      const found = exactly(hyperboloid(O, 1, 1), ray([2, 2, 0], [1, 1, 0]));
      expect(found.class).toBe('none');
      expect(signsOf(found)).toEqual([0, 0, -1, 0]);
    });

    test('along a ruling of the other family', () => {
      expect(exactly(hyperboloid(O, 1, 1), ray([1, 5, -5], [0, 1, -1])).class).toBe('contained');
    });
  });
});

describe('D = 0: one hit, never two', () => {
  test('a tangent has a normal', () => {
    const found = exactly(cylinder(O, 2), ray([2, 3, 5], [0, 1, -2]));
    expect(found.class).toBe('tangent');
    expect(found.hits).toHaveLength(1);
    expect(signsOf(found)).toEqual([1, -1, 1, 0]);
  });

  test('one ulp farther out misses, one ulp farther in meets it twice', () => {
    const at = (x: number) => exactly(cylinder(O, 2), ray([x, 3, 5], [0, 1, -2]));
    expect(at(nextUp(2)).class).toBe('none');
    const inside = at(nextDown(2));
    expect(inside.class).toBe('two');
    expect(roots(inside)[0]).toBeLessThan(2.5);
    expect(roots(inside)[1]).toBeGreaterThan(2.5);
  });
});

describe('a singular normal is exactly zero', () => {
  test.each<[string, Shape, Vec3, Vec3]>([
    ['a cone’s vertex, from outside', cone([1, 2, 3], 0.5), [3, 2, 3], [-1, 0, 0]],
    ['a cone’s vertex, from inside', cone([1, 2, 3], 0.5), [1, 4, 3], [0, -1, 0]],
    ['a cylinder of radius 0', cylinder([1, 9, 3], 0), [3, 2, 5], [-1, 0, -1]],
    ['a hyperboloid’s centre with r = 0', hyperboloid([1, 2, 3], 1, 0), [3, 2, 3], [-1, 0, 0]],
    ['a < 0 and r = 0, only a point', hyperboloid([1, 2, 3], -1, 0), [3, 4, 5], [-1, -1, -1]],
    ['a = 0 and r = 0, only a line', hyperboloid([1, 9, 3], 0, 0), [3, 2, 3], [-1, 0, 0]],
    ['c = 0, only the axis', cone([1, 9, 3], 0), [3, 2, 3], [-1, 0, 0]],
  ])('%s', (_, shape, E, d) => {
    const found = exactly(shape, ray(E, d));
    expect(found.class).toBe('tangent');
    expect(found.hits).toEqual([{ t: 2, point: [1, 2, 3], normal: [0, 0, 0], singular: true }]);
  });

  test('a normal that only underflows is not singular', () => {
    // c² = 10⁻⁴⁰⁰ is below the doubles, the vertex is not where the hit is.
    const found = exactly(cone(O, 1e-200), ray([1e-200, 1, 0], [-1, 0, 0]));
    expect(found.class).toBe('two');
    expect(found.hits.map(({ singular }) => singular)).toEqual([false, false]);
  });

  test('the vertex missed by one ulp is no tangent', () => {
    expect(exactly(cone([1, 2, 3], 0.5), ray([3, nextUp(2), 3], [-1, 0, 0])).class).toBe('two');
    expect(exactly(cone([1, 2, 3], 0.5), ray([3, 2, nextUp(3)], [-1, 0, 0])).class).toBe('none');
  });
});

describe('parameters at their limits', () => {
  test('c = 0: the axis alone, which a ray meets, misses or runs along', () => {
    expect(exactly(cone(O, 0), ray([2, 1, 0], [-1, 0, 0])).class).toBe('tangent');
    expect(exactly(cone(O, 0), ray([2, 1, 1], [-1, 0, 0])).class).toBe('none');
    expect(exactly(cone(O, 0), ray([0, 1, 0], [0, 1, 0])).class).toBe('contained');
  });

  test('r = 0: a cylinder is its axis', () => {
    expect(exactly(cylinder(O, 0), ray([2, 1, 1], [-1, 0, 0])).class).toBe('none');
    expect(exactly(cylinder(O, 0), ray([0, 1, 0], [0, 7, 0])).class).toBe('contained');
  });

  test('a = 0: a hyperboloid is the cylinder, hit for hit', () => {
    const r = ray([5, 1, 2], [-1, 0.5, 0]);
    const own = exactly(hyperboloid([1, 7, 2], 0, 2), r);
    expect(own.hits).toEqual(exactly(cylinder([1, 7, 2], 2), r).hits);
    expect(own.hits).toHaveLength(2);
  });

  test('r = 0, a > 0: a hyperboloid is the cone with c² = a, hit for hit', () => {
    const r = ray([5, -1, 0], [1, 1, 0]);
    const own = exactly(hyperboloid(O, 4, 0), r);
    expect(own.hits).toEqual(exactly(cone(O, 2), r).hits);
    expect(own.hits).toHaveLength(2);
  });

  test('a < 0: an ellipsoid ends above and below', () => {
    // x² + z² + 4y² = 4: poles at y = ±1.
    const at = (y: number) => exactly(hyperboloid(O, -4, 2), ray([5, y, 0], [-1, 0, 0]));
    expect(at(0).hits.map(({ point }) => point)).toEqual([
      [2, 0, 0],
      [-2, 0, 0],
    ]);
    expect(at(1).class).toBe('tangent');
    expect(at(1).hits[0]).toMatchObject({ point: [0, 1, 0], normal: [0, 4, 0], singular: false });
    expect(at(nextUp(1)).class).toBe('none');
  });

  test('r = 0 of a circle and L = 0 of a square: only a point is left, and it is inside', () => {
    const there = ray([1, 2, 5], [0, 0, -1]);
    const beside = ray([1, nextUp(2), 5], [0, 0, -1]);
    expect(exactly(circle([0, 0, 1], [1, 2, 3], 0), there).class).toBe('one');
    expect(exactly(circle([0, 0, 1], [1, 2, 3], 0), beside).class).toBe('none');
    expect(exactly(square([1, 2, 3], 0, 'z'), there).class).toBe('one');
    expect(exactly(square([1, 2, 3], 0, 'z'), beside).class).toBe('none');
  });

  test('a radius of −0 is a radius of 0', () => {
    const r = ray([3, 2, 3], [-1, 0, 0]);
    expect(exactly(cylinder([1, 9, 3], -0), r)).toEqual(exactly(cylinder([1, 9, 3], 0), r));
  });
});

describe('both nappes of a cone', () => {
  test('a ray up through the lower and the upper one', () => {
    const found = exactly(cone(O, 1), ray([2, 0, 0], [0, 1, 0]));
    expect(found.hits.map(({ point }) => point)).toEqual([
      [2, -2, 0],
      [2, 2, 0],
    ]);
    expect(signsOf(found)).toEqual([-1, 0, 1, 1]);
  });

  test('the normal of each points away from the axis', () => {
    const found = exactly(cone(O, 1), ray([2, 0, 0], [0, 1, 0]));
    expect(found.hits.map(({ normal }) => normal)).toEqual([
      [2, 2, 0],
      [2, -2, 0],
    ]);
  });
});

describe('t < 0 is kept: the answer is about the whole line', () => {
  test('both behind', () => {
    expect(roots(exactly(cylinder(O, 1), ray([5, 0, 0], [1, 0, 0])))).toEqual([-6, -4]);
  });
  test('one behind', () => {
    expect(roots(exactly(cylinder(O, 1), ray([0.5, 0, 0], [1, 0, 0])))).toEqual([-1.5, 0.5]);
  });
  test('E on the surface: t is +0, not −0', () => {
    expect(roots(exactly(cylinder(O, 1), ray([1, 0, 0], [1, 0, 0])))).toEqual([-2, 0]);
    expect(roots(exactly(plane([0, 1, 0], O), ray([1, 0, 1], [0, 1, 0])))).toEqual([0]);
    expect(roots(exactly(plane([0, 1, 0], O), ray([1, 0, 1], [0, -1, 0])))).toEqual([0]);
  });
});

describe('parallel to a plane', () => {
  const figures: [string, Shape][] = [
    ['plane', plane([0, 0, 2], [1, 2, 3])],
    ['circle', circle([0, 0, 2], [1, 2, 3], 1)],
    ['square', square([1, 2, 3], 1, 'z')],
  ];

  test.each(figures)('%s: beside it there is no point', (_, shape) => {
    const found = exactly(shape, ray([1, 2, 4], [1, 1, 0]));
    expect(found.class).toBe('none');
    expect(flatDetails(found)).toMatchObject({
      plane: null,
      meetsFigure: null,
      signs: { offset: 1, rate: 0 },
    });
  });

  test.each(figures)('%s: in it there is no single point', (_, shape) => {
    const found = exactly(shape, ray([1, 2, 3], [1, 1, 0]));
    expect(found.class).toBe('contained');
    expect(found.hits).toEqual([]);
    expect(flatDetails(found)).toMatchObject({ plane: null, signs: { offset: 0, rate: 0 } });
  });

  test('a whole plane has no figure to cross or to pass beside', () => {
    const found = exactly(plane([0, 0, 2], [1, 2, 3]), ray([1, 2, 3], [1, 1, 0]));
    expect(flatDetails(found).meetsFigure).toBeNull();
  });

  test('a tilt of one ulp is a tilt', () => {
    const found = exactly(plane([0, 0, 2], [1, 2, 3]), ray([1, 2, 4], [1, 1, -Number.MIN_VALUE]));
    expect(found.class).toBe('one');
    expect(roots(found)).toEqual([Infinity]);
  });
});

describe('in the plane of a circle: does the line meet it?', () => {
  const disc = circle([0, 0, 5], [1, 1, 3], 2);
  const meets = (E: Vec3, d: Vec3) => flatDetails(exactly(disc, ray(E, d))).meetsFigure;
  test.each<[string, Vec3, Vec3, boolean]>([
    ['through the centre', [7, 1, 3], [-1, 0, 0], true],
    ['through it off the centre, E beyond', [-7, 2, 3], [-1, 0, 0], true],
    ['touching the rim', [7, 3, 3], [-1, 0, 0], true],
    ['one ulp beside the rim', [7, nextUp(3), 3], [-1, 0, 0], false],
    ['passing well beside', [7, 7, 3], [-1, 0, 0], false],
  ])('%s', (_, E, d, expected) => {
    expect(meets(E, d)).toBe(expected);
  });

  test('askew along 3-4-5, exactly touching and just beside', () => {
    // The line 3x + 4y = 3·1 + 4·1 + 2·5 touches: its distance from (1, 1) is 10/5. It passes (3,
    // 2) and (−1, 5).
    expect(meets([3, 2, 3], [-4, 3, 0])).toBe(true);
    expect(meets([3, nextUp(2), 3], [-4, 3, 0])).toBe(false);
    expect(meets([3, nextDown(2), 3], [-4, 3, 0])).toBe(true);
  });
});

describe('in the plane of a square: does the line meet it?', () => {
  const tile = square([1, 2, 3], 2, 'z');
  const meets = (E: Vec3, d: Vec3) => flatDetails(exactly(tile, ray(E, d))).meetsFigure;
  test.each<[string, Vec3, Vec3, boolean]>([
    ['across the middle', [9, 3, 3], [1, 0, 0], true],
    ['along an edge', [9, 4, 3], [1, 0, 0], true],
    ['one ulp beside that edge', [9, nextUp(4), 3], [1, 0, 0], false],
    ['along a diagonal', [0, 1, 3], [1, 1, 0], true],
    ['through one corner only', [0, 3, 3], [-1, 1, 0], true],
    ['through the corner opposite', [3, 4, 3], [-1, 1, 0], true],
    ['beside the corner', [3, nextUp(4), 3], [-1, 1, 0], false],
    ['beside the near corner', [0, nextDown(3), 3], [-1, 1, 0], false],
  ])('%s', (_, E, d, expected) => {
    expect(meets(E, d)).toBe(expected);
  });

  test('for the other two axes', () => {
    const inX = square([3, 1, 2], 2, 'x');
    const inY = square([2, 3, 1], 2, 'y');
    const say = (shape: Shape, E: Vec3, d: Vec3) => flatDetails(exactly(shape, ray(E, d)));
    expect(say(inX, [3, 0, 3], [0, -1, 1]).meetsFigure).toBe(true);
    expect(say(inX, [3, 0, nextDown(3)], [0, -1, 1]).meetsFigure).toBe(false);
    expect(say(inY, [3, 3, 0], [1, 0, -1]).meetsFigure).toBe(true);
    expect(say(inY, [nextDown(3), 3, 0], [1, 0, -1]).meetsFigure).toBe(false);
  });
});

describe('rim and edge are inside', () => {
  // Straight down onto (x, y, 3).
  const down = (x: number, y: number) => ray([x, y, 5], [0, 0, -1]);

  test('the rim of a circle, and one ulp beyond', () => {
    const disc = circle([0, 0, 1], [1, 1, 3], 5);
    for (const [x, y] of [
      [6, 1],
      [1, -4],
      [4, 5],
      [-2, 5],
    ] as const) {
      expect(exactly(disc, down(x, y)).class).toBe('one');
    }
    expect(exactly(disc, down(4, nextUp(5))).class).toBe('none');
    expect(exactly(disc, down(nextDown(-2), 5)).class).toBe('none');
    expect(exactly(disc, down(4, nextDown(5))).class).toBe('one');
  });

  test('edges and corners of a square, and one ulp beyond', () => {
    const tile = square([1, 2, 3], 2, 'z');
    for (const [x, y] of [
      [1, 3],
      [3, 3],
      [2, 2],
      [2, 4],
      [1, 2],
      [3, 2],
      [1, 4],
      [3, 4],
    ] as const) {
      expect(exactly(tile, down(x, y)).class).toBe('one');
    }
    const which = (x: number, y: number) => planeHit(exactly(tile, down(x, y))).holds;
    expect(which(2, 3)).toEqual([true, true, true, true]);
    expect(which(nextDown(1), 3)).toEqual([false, true, true, true]);
    expect(which(nextUp(3), 3)).toEqual([true, false, true, true]);
    expect(which(2, nextDown(2))).toEqual([true, true, false, true]);
    expect(which(2, nextUp(4))).toEqual([true, true, true, false]);
  });

  test('an edge P + L that is no double is decided as if it were', () => {
    // 1 + 2⁻⁶⁰ lies between two doubles: 1 is inside, the next double is not.
    const tile = square([1, 0, 0], 2 ** -60, 'z');
    expect(exactly(tile, ray([1, 0, 1], [0, 0, -1])).class).toBe('one');
    expect(exactly(tile, ray([nextUp(1), 0, 1], [0, 0, -1])).class).toBe('none');
  });
});

describe('outside, and by how much', () => {
  const down = (x: number, y: number) => ray([x, y, 5], [0, 0, -1]);

  test.each([
    [4, 5, 1, 4],
    [1, 1 - 7, 2, 5],
    [1 + 5, 1 + 12, 3, 10],
  ])('a circle: (%d, %d) from one of radius %d: %d', (x, y, r, far) => {
    expect(planeHit(exactly(circle([0, 0, 9], [1, 1, 3], r), down(x, y)))).toMatchObject({
      t: 2,
      point: [x, y, 3],
      inside: false,
      distance: far,
    });
  });

  test.each([
    ['left of it', -1, 3, 2],
    ['right of it', 7, 3, 4],
    ['below', 2, -6, 8],
    ['above', 2, 4.5, 0.5],
    ['off the corner, 3-4-5', 6, 8, 5],
    ['off the opposite corner, 5-12-13', -4, -10, 13],
    ['off a third corner, 3-4-5', -2, 8, 5],
  ])('a square: %s', (_, x, y, far) => {
    const found = exactly(square([1, 2, 3], 2, 'z'), down(x, y));
    expect(found.class).toBe('none');
    expect(planeHit(found)).toMatchObject({ t: 2, point: [x, y, 3], inside: false, distance: far });
  });

  test('inside the distance is 0', () => {
    expect(planeHit(exactly(square([1, 2, 3], 2, 'z'), down(2, 3))).distance).toBe(0);
    expect(planeHit(exactly(circle([0, 0, 9], [1, 1, 3], 2), down(2, 1))).distance).toBe(0);
  });

  test('a distance that is irrational is correctly rounded', () => {
    // (2, 1) from the centre with r = 1: √5 − 1.
    const found = exactly(circle([0, 0, 9], [0, 0, 3], 1), down(2, 1));
    expect(planeHit(found).distance).toBe(1.2360679774997898);
    // Off the corner by (1, 2): √5.
    const corner = exactly(square([1, 2, 3], 2, 'z'), down(4, 6));
    expect(planeHit(corner).distance).toBe(2.23606797749979);
  });

  test('a distance far smaller than the rounding of a coordinate is still told', () => {
    const found = exactly(circle([0, 0, 1], O, 1), ray([1, 1e-20, 1], [0, 0, -1]));
    // √(1 + 10⁻⁴⁰) − 1 = 5·10⁻⁴¹ and a little less; 1e-20 is not 10⁻²⁰.
    expect(planeHit(found).distance).toBeCloseTo(5e-41, 55);
    expect(planeHit(found).distance).toBeGreaterThan(0);
  });
});

describe('two roots that one double holds', () => {
  test('stay two, with a point each', () => {
    // From 10²⁰ away both roots round to 10²⁰; the points come from the exact roots.
    const found = exactly(cylinder(O, 0.25), ray([1e20, 0, 0], [-1, 0, 0]));
    expect(found.class).toBe('two');
    expect(found.hits).toEqual([
      { t: 1e20, point: [0.25, 0, 0], normal: [0.25, 0, 0], singular: false },
      { t: 1e20, point: [-0.25, 0, 0], normal: [-0.25, 0, 0], singular: false },
    ]);
  });
});

describe('beyond the doubles', () => {
  test('roots at infinity keep their points', () => {
    const found = exactly(cylinder(O, 1), ray([1e300, 2, 0], [-1e-300, 0, 0]));
    expect(found.class).toBe('two');
    expect(found.hits).toEqual([
      { t: Infinity, point: [1, 2, 0], normal: [1, 0, 0], singular: false },
      { t: Infinity, point: [-1, 2, 0], normal: [-1, 0, 0], singular: false },
    ]);
  });

  test('a root below the doubles keeps its sign', () => {
    const at = (x: number) => exactly(plane([1, 0, 0], O), ray([x, 0, 0], [-1e300, 0, 0]));
    expect(roots(at(1e-300))).toEqual([0]);
    expect(roots(at(-1e-300))).toEqual([-0]);
  });

  test('points at infinity', () => {
    const found = exactly(plane([0, 1, 0], O), ray([0, 1e300, 0], [1e10, -1e-10, 0]));
    expect(found.class).toBe('one');
    expect(found.hits[0]?.point).toEqual([Infinity, 0, 0]);
  });

  test('coefficients at infinity do not disturb the class', () => {
    const found = exactly(cylinder(O, 1e200), ray([2e200, 0, 0], [-1e200, 0, 0]));
    expect(found.class).toBe('two');
    expect(roots(found)).toEqual([1, 3]);
    expect(curvedDetails(found)).toMatchObject({ A: Infinity, B: -Infinity, C: Infinity });
  });

  test('and what a float method cannot decide it does not guess', () => {
    const r = ray([2e200, 0, 0], [-1e200, 0, 0]);
    for (const method of ['textbook', 'stable']) {
      const found = intersect(cylinder(O, 1e200), r, method);
      expect(found.class).toBe('undecided');
      expect(found.hits).toEqual([]);
      expect(curvedDetails(found).signs).toEqual({ A: null, B: null, C: null, D: null });
    }
  });
});

const SEED = 20240917;
const RAYS = many(300);

test(`no method ever answers NaN: ${RAYS} rays a shape, any doubles, seed ${SEED}`, () => {
  const random = seeded(SEED);
  // Half of the components are zero or of ordinary size, or hardly any two numbers would have to do
  // with each other.
  const x = (): number => [0, 1, wide(random, -3, 3), wide(random)][integer(random, 0, 3)] ?? 0;
  const v = (): Vec3 => [x(), x(), x()];
  const nonZero = (): Vec3 => {
    const w = v();
    return w.every((c) => c === 0) ? [1, 0, 0] : w;
  };
  const own = {
    vector: (param: { nonZero?: boolean }) => (param.nonZero ? nonZero() : v()),
    number: () => Math.abs(x()),
    axis: () => (['x', 'y', 'z'] as const)[integer(random, 0, 2)] ?? 'x',
  };
  for (const { kind, params } of SHAPES) {
    for (let i = 0; i < RAYS; i++) {
      const values = params.map((param) => [param.key, own[param.type](param as never)] as const);
      const shape = { kind, ...Object.fromEntries(values) } as unknown as Shape;
      const r = ray(v(), nonZero());
      for (const method of METHOD_IDS) {
        const { class: verdict, hits } = intersect(shape, r, method);
        const expected = { two: 2, tangent: 1, one: 1, none: 0, contained: 0, undecided: 0 };
        const numbers = hits.flatMap(({ t, point, normal }) => [t, ...point, ...normal]);
        const said = { shape, r, method, verdict };
        expect({ ...said, nan: numbers.some(Number.isNaN), n: hits.length }).toEqual({
          ...said,
          nan: false,
          n: expected[verdict],
        });
      }
    }
  }
});
