import type { Ray } from '../../../src/math/ray.ts';
import { integer, pick, type Random } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import {
  circle,
  cone,
  cylinder,
  hyperboloid,
  paraboloid,
  plane,
  ray,
  sphere,
  square,
} from '../math/shorthand.ts';

/*
 * Facts of a ray and a shape in small whole numbers and halves, where doubles do not round; nothing
 * here asks src/math.
 */

/** (x−Cx)² + (z−Cz)² = a(y−Cy)² + k(y−Cy) + ρ */
interface Quadric {
  readonly C: Vec3;
  readonly a: number;
  readonly k?: number;
  readonly rho: number;
}

export function quadricOf(shape: Shape): Quadric | null {
  if (shape.kind === 'cylinder') return { C: shape.center, a: 0, rho: shape.radius ** 2 };
  if (shape.kind === 'cone') return { C: shape.vertex, a: shape.slope ** 2, rho: 0 };
  if (shape.kind === 'hyperboloid')
    return { C: shape.center, a: shape.flare, rho: shape.radius ** 2 };
  if (shape.kind === 'sphere') return { C: shape.center, a: -1, rho: shape.radius ** 2 };
  if (shape.kind === 'paraboloid') return { C: shape.vertex, a: 0, k: shape.width, rho: 0 };
  return null;
}

export const at = ({ origin: E, direction: d }: Ray, t: number): Vec3 => [
  E[0] + t * d[0],
  E[1] + t * d[1],
  E[2] + t * d[2],
];

/** f at R(t): negative inside. */
export function f({ C, a, k = 0, rho }: Quadric, [x, y, z]: Vec3): number {
  const h = y - C[1];
  return (x - C[0]) ** 2 + (z - C[2]) ** 2 - a * h ** 2 - k * h - rho;
}

type Crossing = 'enters' | 'leaves';

/** What happens to f along the line, found by looking at its sign at chosen t. */
export interface Course {
  readonly A: number;
  readonly B: number;
  readonly C: number;
  readonly D: number;
  readonly behind: readonly Crossing[];
  readonly ahead: readonly Crossing[];
  /** At E itself: what f does there, or null where f(0) ≠ 0. */
  readonly atE: Crossing | 'touches' | null;
  /** Signs of f just before and just behind E, and far ahead. */
  readonly signs: { readonly before: number; readonly after: number; readonly end: number };
}

const FAR = 2 ** 20;
/** Below every root ≠ 0 of the small numbers used here. */
const NEAR = 2 ** -20;

export function courseOf(q: Quadric, r: Ray): Course {
  const value = (t: number): number => f(q, at(r, t));
  const C = value(0);
  const A = (value(1) + value(-1)) / 2 - C;
  const B = (value(1) - value(-1)) / 2;
  const D = B * B - 4 * A * C;
  const turn = A === 0 ? 0 : -B / (2 * A);
  const signs = (ts: readonly number[]): number[] =>
    ts.map((t) => (t === turn && D === 0 && A !== 0 ? 0 : Math.sign(value(t))));
  const behind = signs([-FAR, ...(turn < -NEAR ? [turn] : []), -NEAR]);
  const ahead = signs([NEAR, ...(turn > NEAR ? [turn] : []), FAR]);
  const [before = 0, after = 0] = [behind.at(-1), ahead[0]];
  const atE = C !== 0 ? null : before === after ? 'touches' : after < 0 ? 'enters' : 'leaves';
  return {
    ...{ A, B, C, D, atE },
    behind: changes(behind),
    ahead: changes(ahead),
    signs: { before, after, end: ahead.at(-1) ?? 0 },
  };
}

function changes(signs: readonly number[]): Crossing[] {
  const all = signs.filter((s) => s !== 0);
  return all.slice(1).flatMap((s, i) => (s === all[i] ? [] : [s < 0 ? 'enters' : 'leaves']));
}

/**
 * Of a flat shape: N, a point of its plane, and where a point of the plane lies as to the figure.
 */
export function flatOf(shape: Shape): { readonly N: Vec3; readonly P: Vec3 } | null {
  if (shape.kind === 'plane') return { N: shape.normal, P: shape.point };
  if (shape.kind === 'circle') return { N: shape.normal, P: shape.center };
  if (shape.kind !== 'square') return null;
  const N: Vec3 = [
    shape.axis === 'x' ? 1 : 0,
    shape.axis === 'y' ? 1 : 0,
    shape.axis === 'z' ? 1 : 0,
  ];
  return { N, P: shape.corner };
}

/**
 * How far a point of the plane lies outside the figure (0 within), and how many of its limits it
 * lies on.
 */
export function figurePlace(
  shape: Shape,
  x: Vec3,
): { readonly off: number; readonly limits: number } {
  if (shape.kind === 'circle') {
    const square = x.reduce((sum, c, i) => sum + (c - (shape.center[i] ?? 0)) ** 2, 0);
    const limits = square === shape.radius ** 2 ? 1 : 0;
    return { off: Math.max(0, Math.sqrt(square) - shape.radius), limits };
  }
  if (shape.kind !== 'square') return { off: 0, limits: 0 };
  const ways = [0, 1, 2]
    .filter((i) => 'xyz'[i] !== shape.axis)
    .map((i) => {
      const [u, P] = [x[i] ?? 0, shape.corner[i] ?? 0];
      return { off: Math.max(0, P - u, u - P - shape.side), on: u === P || u === P + shape.side };
    });
  return {
    off: Math.hypot(...ways.map(({ off }) => off)),
    limits: ways.filter(({ on }) => on).length,
  };
}

export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const less = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

const half = (random: Random): number => integer(random, -6, 6) / 2;
const whole = (random: Random): number => integer(random, -2, 2);
const triple = (random: Random, one: (random: Random) => number): Vec3 => [
  one(random),
  one(random),
  one(random),
];

function direction(random: Random): Vec3 {
  const d = triple(random, whole);
  return d.some((c) => c !== 0) ? d : [0, 1, 0];
}

type Draw = (random: Random) => Shape;

/**
 * Shapes of every name, the degenerate ones included, so small that every cell of the table comes
 * up.
 */
export const DRAWS: Readonly<Record<string, Draw>> = {
  cylinder: (random) => cylinder(triple(random, whole), integer(random, 0, 3)),
  cone: (random) => cone(triple(random, whole), pick(random, [-1, 0, 0.5, 1, 2])),
  hyperboloid: (random) =>
    hyperboloid(
      triple(random, whole),
      pick(random, [-2, -1, 0, 0.25, 1, 4]),
      integer(random, 0, 2),
    ),
  sphere: (random) => sphere(triple(random, whole), integer(random, 0, 3)),
  paraboloid: (random) => paraboloid(triple(random, whole), integer(random, -2, 2)),
  plane: (random) => plane(direction(random), triple(random, whole)),
  // A normal along one axis or (3, 4, 0)-like lines reach the rim in whole numbers.
  circle: (random) =>
    circle(
      pick(random, [
        [1, 0, 0],
        [0, 2, 0],
        [0, 0, -1],
        [1, 1, 0],
      ]),
      triple(random, whole),
      integer(random, 0, 2),
    ),
  square: (random) =>
    square(triple(random, whole), integer(random, 0, 2), pick(random, ['x', 'y', 'z'])),
};

/**
 * A point of the shape where something special is: its centre, its wall, its rim, an edge, a
 * corner.
 */
function special(random: Random, shape: Shape): Vec3 {
  const { C, rho } = quadricOf(shape) ?? { C: flatOf(shape)?.P ?? [0, 0, 0], rho: 0 };
  const r =
    shape.kind === 'circle' ? shape.radius : shape.kind === 'square' ? shape.side : Math.sqrt(rho);
  const out = pick(random, [0, r]);
  return pick(random, [
    [C[0] + out, C[1], C[2]],
    [C[0], C[1] + out, C[2]],
    [C[0], C[1], C[2] + out],
  ]);
}

/** Every other ray goes through, or starts at, a special point. */
export function drawRay(random: Random, shape: Shape): Ray {
  const d = direction(random);
  if (random() < 0.5) return ray(triple(random, half), d);
  return ray(at(ray(special(random, shape), d), integer(random, -2, 2)), d);
}
