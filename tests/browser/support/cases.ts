import type { IntersectionClass, Ray, Shape, Vec3 } from '../../../src/math/index.ts';
import {
  circle,
  cone,
  cylinder,
  hyperboloid,
  paraboloid,
  plane,
  sphere,
  square,
} from '../../unit/math/shorthand.ts';

/** What a case is about, the answer that the course gives, and the question. */
interface Case {
  readonly title: string;
  readonly class: IntersectionClass;
  readonly shape: Shape;
  readonly ray: Ray;
}

type Row = readonly [title: string, verdict: IntersectionClass, shape: Shape, E: Vec3, d: Vec3];

const O: Vec3 = [0, 0, 0];
const LEFT: Vec3 = [-1, 0, 0];
const UP: Vec3 = [0, 1, 0];
const SLANTED: Vec3 = [1, 1, 0];

const ROWS: readonly Row[] = [
  ['in front of E', 'one', plane([1, 1, 0.5], [0, 1, 0]), [3, 1, 1], [-0.8, -0.2, -0.3]],
  ['behind E', 'one', plane([1, 1, 0.5], [0, 1, 0]), [3, 1, 1], [0.8, 0.2, 0.3]],
  ['E in the plane', 'one', plane(UP, O), [1, 0, 2], [1, 2, 3]],
  ['parallel beside it', 'none', plane(UP, O), [0, 1, 0], [1, 0, 2]],
  ['within the plane', 'contained', plane([1, 1, 0.5], O), O, [1, -1, 0]],
  [
    'a root beyond the doubles',
    'one',
    plane([1, 0, 0], [1e308, 0, 0]),
    [-1e308, 0, 0],
    [1e-10, 0, 0],
  ],
  ['a root below the doubles', 'one', plane([1, 0, 0], O), [5e-324, 0, 0], [1e10, 1, 0]],
  ['a huge normal', 'one', plane([1e300, 1e300, 0], [1, 2, 3]), [4, 5, 6], [1, 2, 3]],
  [
    'everything tiny',
    'one',
    plane([1e-160, 2e-160, 0], O),
    [1e-160, 1e-160, 0],
    [-1e-160, 1e-161, 0],
  ],

  ['enters and leaves', 'two', cylinder([0, 1, 0], 1), [3, 1, 0.5], LEFT],
  ['E inside', 'two', cylinder([0, 1, 0], 1), [0.5, 0, 0], [-1, 0.25, 0]],
  ['both behind E', 'two', cylinder([0, 1, 0], 1), [3, 1, 0], [1, 0, 0]],
  ['touches', 'tangent', cylinder(O, 1), [3, 0, 1], LEFT],
  ['touches behind E', 'tangent', cylinder(O, 1), [3, 0, 1], [1, 0, 0]],
  ['misses', 'none', cylinder(O, 1), [3, 0, 1.5], LEFT],
  ['parallel to the axis, outside', 'none', cylinder(O, 1), [3, 0, 0], UP],
  ['parallel to the axis, inside', 'none', cylinder(O, 1), [0.5, 0, 0], UP],
  ['on a generator', 'contained', cylinder(O, 1), [1, 0, 0], UP],
  ['radius 0, through the axis', 'tangent', cylinder(O, 0), [1, 0, 0], LEFT],
  ['radius 0, beside the axis', 'none', cylinder(O, 0), [1, 0, 1], LEFT],
  [
    'a thousand radii away, one third',
    'two',
    cylinder([1 / 3, 0, 0], 1 / 3),
    [1000, 0, 0.1],
    [-0.7, 0.1, 0],
  ],
  ['E at 10¹⁵⁰', 'two', cylinder(O, 1e140), [1e150, 0, 0], LEFT],

  ['enters and leaves', 'two', cone([0, 3, 0], 0.5), [3, 1, 1], [-0.8, -0.2, -0.3]],
  ['both nappes', 'two', cone(O, 0.5), [1, 3, 0], [-0.3, -1, 0.1]],
  ['E inside', 'two', cone(O, 1), [0, 2, 0], [1, 0, 0.5]],
  ['parallel to a generator', 'one', cone(O, 1), [-2, 0, 0], SLANTED],
  ['parallel to a generator, behind E', 'one', cone(O, 1), [2, 0, 0], SLANTED],
  ['parallel to a generator, no root', 'none', cone(O, 1), [0, 0, 1], SLANTED],
  ['on a generator', 'contained', cone(O, 1), [1, 1, 0], SLANTED],
  ['through the vertex', 'tangent', cone(O, 0.5), [2, 1, 0], [-2, -1, 0]],
  ['touches', 'tangent', cone(O, 1), [1, 1, 3], [0, 0, -1]],
  ['misses', 'none', cone(O, 0.5), [4, 1, 2], LEFT],
  ['slope 0, through the axis', 'tangent', cone(O, 0), [2, 1, 0], LEFT],
  ['slope below 0', 'two', cone(O, -0.5), [4, 1, 0], LEFT],
  ['roots that print alike', 'two', cone(O, 1e-8), [1, 1, 0], LEFT],
  ['the world at 10⁻¹⁶⁰', 'two', cone(O, 0.5), [4e-160, 1e-160, 0], [-1e-160, 0, 0]],
  ['the world at 10¹⁵⁰', 'two', cone(O, 0.5), [4e150, 1e150, 0], [-1e150, 0, 0]],
  ['a hand-written link', 'tangent', cone(O, 0.5), [4, 1, 0.5], LEFT],

  ['enters and leaves', 'two', hyperboloid([0, 1, 0], 0.4, 1), [3, 1, 1], [-0.8, -0.2, -0.3]],
  ['leaves, then enters', 'two', hyperboloid(O, 1, 1), [0.5, -3, 0], [0.5, 1, 0]],
  ['a < 0: a sphere', 'two', hyperboloid(O, -1, 1), [3, 0.25, 0], LEFT],
  ['a < 0: touches', 'tangent', hyperboloid(O, -1, 1), [3, 1, 0], LEFT],
  ['a < 0: misses', 'none', hyperboloid(O, -1, 1), [3, 2, 0], LEFT],
  ['a = 0: a cylinder', 'two', hyperboloid(O, 0, 1), [3, 0.25, 0.5], LEFT],
  ['a = 0, along the axis', 'none', hyperboloid(O, 0, 1), [3, 0, 0], UP],
  ['r = 0: through the centre', 'tangent', hyperboloid(O, 0.25, 0), [2, 1, 0], [-2, -1, 0]],
  ['r = 0, a < 0: only the centre', 'tangent', hyperboloid(O, -1, 0), [2, 1, 0], [-2, -1, 0]],
  ['r = 0, a = 0: only the axis', 'none', hyperboloid(O, 0, 0), [2, 1, 1], LEFT],
  ['parallel to the asymptote', 'one', hyperboloid(O, 1, 1), [-2, 0, 0], SLANTED],
  ['on a line of the surface', 'contained', hyperboloid(O, 1, 1), [1, 0, 0], [0, 1, 1]],

  ['inside', 'one', circle([1, 0, 0], O, 2), [3, 1, 1], LEFT],
  ['inside, behind E', 'one', circle([1, 0, 0], O, 2), [-3, 1, 1], LEFT],
  ['on the rim', 'one', circle([1, 0, 0], O, 5), [3, 3, 4], LEFT],
  ['outside', 'none', circle([1, 0, 0], O, 1), [3, 1, 1], LEFT],
  ['outside, behind E', 'none', circle([1, 0, 0], O, 1), [-3, 1, 1], LEFT],
  ['radius 0, met', 'one', circle([1, 0, 0], O, 0), [3, 0, 0], LEFT],
  ['parallel', 'none', circle([1, 0, 0], O, 2), [1, 0, 0], UP],
  ['in its plane, across', 'contained', circle([1, 0, 0], O, 2), [0, -5, 0], UP],
  ['in its plane, beside', 'contained', circle([1, 0, 0], O, 2), [0, -5, 3], UP],

  ['x: inside', 'one', square([0, 0, -1], 2, 'x'), [3, 1, 0.25], LEFT],
  ['y: a corner', 'one', square([0, 0, 0], 2, 'y'), [2, 4, 2], [0, -1, 0]],
  ['z: an edge', 'one', square([0, 0, 0], 2, 'z'), [1, 2, 5], [0, 0, -1]],
  ['y: inside, behind E', 'one', square([0, 0, 0], 2, 'y'), [0.3, -1, 0.4], [0.1, -1, 0]],
  ['z: outside', 'none', square([0, 0, 0], 2, 'z'), [3, 4, 5], [0, 0, -1]],
  ['x: parallel', 'none', square([0, 0, 0], 2, 'x'), [1, 0, 0], UP],
  ['x: in its plane, across', 'contained', square([0, 0, 0], 2, 'x'), [0, -1, 1], UP],
  ['x: in its plane, beside', 'contained', square([0, 0, 0], 2, 'x'), [0, -1, 3], UP],
  ['side 0, met', 'one', square([0, 1, 1], 0, 'x'), [3, 1, 1], LEFT],

  ['enters and leaves', 'two', sphere([0, 1, 0], 1.5), [3, 1, 1], [-0.8, -0.2, -0.3]],
  ['E inside', 'two', sphere(O, 2), [0.5, 0.25, 0], SLANTED],
  ['touches', 'tangent', sphere(O, 1), [3, 1, 0], LEFT],
  ['misses', 'none', sphere(O, 1), [3, 1, 1], LEFT],
  ['radius 0, through the centre', 'tangent', sphere(O, 0), [2, 1, 0], [-2, -1, 0]],
  ['radius 0, beside the centre', 'none', sphere(O, 0), [2, 1, 1], LEFT],
  ['the world at 10⁻¹⁶⁰', 'two', sphere(O, 1e-160), [4e-160, 5e-161, 0], [-1e-160, 0, 0]],
  ['the world at 10¹⁵⁰', 'two', sphere(O, 1e140), [1e150, 0, 0], LEFT],

  ['enters and leaves', 'two', paraboloid(O, 2), [3, 1, 1], [-0.8, -0.2, -0.3]],
  ['E inside', 'two', paraboloid([0, -1, 0], 2), [0.25, 2, 0], [1, 0.5, 0.25]],
  ['width below 0', 'two', paraboloid(O, -2), [3, -2, 0.5], LEFT],
  ['touches', 'tangent', paraboloid(O, 2), [3, 2, 2], LEFT],
  ['touches at the vertex', 'tangent', paraboloid(O, 2), [2, 0, 0], LEFT],
  ['misses', 'none', paraboloid(O, 2), [3, -1, 0], LEFT],
  ['parallel to the axis', 'one', paraboloid(O, 2), [1, 5, 0], [0, -1, 0]],
  ['parallel to the axis, behind E', 'one', paraboloid(O, 2), [1, 5, 0], UP],
  ['width 0, through the axis', 'tangent', paraboloid(O, 0), [2, 1, 0], LEFT],
  ['width 0, along the axis', 'contained', paraboloid(O, 0), [0, 1, 0], UP],
  ['width 0, beside the axis', 'none', paraboloid(O, 0), [2, 1, 1], LEFT],
];

export const CASES: readonly Case[] = ROWS.map(([title, verdict, shape, E, d]) => ({
  title,
  class: verdict,
  shape,
  ray: { origin: E, direction: d },
}));
