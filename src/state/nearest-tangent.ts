import { intersect, type Shape, type Vec3 } from '../math/index.ts';
import { type CircleNear, definitionOf, short } from '../math/shapes.ts';
import { type AppState, rayOf, shapeOf } from './state.ts';

/** A ray and a shape that touch in exact arithmetic. */
export interface Tangent {
  readonly shape: Shape;
  readonly E: Vec3;
  readonly d: Vec3;
}

/**
 * Bits of the numbers to try, with the largest leg of their Pythagorean triangles; nearest first.
 */
const TRIES = [16, 14, 12, 10, 8, 6, 5].flatMap((bits) =>
  [48, 24, 12, 6].map((legs) => [bits, legs] as const),
);
/** Largest change of a number, relative to its vector's size. */
const FARTHEST = 0.05;

/**
 * A ray and a shape near those of the state that touch exactly; null if none is found. A point of
 * the surface with short coordinates is made from a Pythagorean triangle; then a direction of short
 * numbers in the tangent plane there, and E on that line. Exact arithmetic checks the result.
 */
export function nearestTangent(state: AppState): Tangent | null {
  const shape = shapeOf(state);
  const { circleNear } = definitionOf(shape);
  if (!circleNear || state.unit) return null;
  const { origin, direction } = rayOf(state);
  const { details } = intersect(shape, { origin, direction }, 'exact');
  if (details.family !== 'curved' || !details.signs.A) return null;
  const t = -details.B / (2 * details.A);
  const { at } = definitionOf(shape).anchor(shape);
  const place = at.map((c, i) => (origin[i] ?? 0) - c + t * (direction[i] ?? 0));
  if (!place.every(Number.isFinite)) return null;
  for (const [bits, legs] of TRIES) {
    const found = tangentNear(
      shape,
      circleNear,
      place as unknown as Vec3,
      t,
      direction,
      bits,
      legs,
    );
    if (found && isNear(state, shape, found) && isTangent(found)) return found;
  }
  return null;
}

function tangentNear(
  shape: Shape,
  circleNear: CircleNear<Shape>,
  [x, y, z]: Vec3,
  t: number,
  d: Vec3,
  bits: number,
  legs: number,
): Tangent | null {
  const [u, v, hypotenuse] = triangle(x, z, legs);
  const circle = circleNear(shape, y, hypotenuse, bits);
  if (!circle || !(circle.unit > 0)) return null;
  const { at } = definitionOf(circle.shape).anchor(circle.shape);
  const { height, unit, out, up } = circle;
  // In the tangent plane: along the circle (−v, 0, u), and along the meridian (out·u, up, out·v).
  const rise = short(d[1] / up, bits);
  const turn = short((u * d[2] - v * d[0]) / hypotenuse ** 2, bits);
  const direction: Vec3 = [rise * out * u - turn * v, rise * up, rise * out * v + turn * u];
  const far = short(t, bits);
  const [cx, cy, cz] = at;
  const E: Vec3 = [
    cx + unit * u - far * direction[0],
    cy + height - far * direction[1],
    cz + unit * v - far * direction[2],
  ];
  return { shape: circle.shape, E, d: direction };
}

/** Whole numbers with u² + v² = hypotenuse², nearest to the direction of (x, z). */
function triangle(x: number, z: number, legs: number): readonly [number, number, number] {
  const mirrored = x < 0;
  const half = Math.tan(Math.atan2(z, Math.abs(x)) / 2);
  let [p, q, least] = [1, 0, Number.POSITIVE_INFINITY];
  for (let n = 1; n <= legs; n++) {
    const m = Math.round(n * half);
    const off = Math.abs(m / n - half);
    if (off < least) [p, q, least] = [n, m, off];
  }
  const u = p * p - q * q;
  return [mirrored ? -u : u, 2 * p * q, p * p + q * q];
}

function isTangent({ shape, E, d }: Tangent): boolean {
  if (![...E, ...d].every(Number.isFinite) || d.every((x) => x === 0)) return false;
  const found = intersect(shape, { origin: E, direction: d }, 'exact');
  return found.class === 'tangent' && !found.hits[0]?.singular;
}

function isNear(state: AppState, shape: Shape, found: Tangent): boolean {
  return [
    [state.E, found.E],
    [state.d, found.d],
    ...Object.entries(shape).map(([key, value]) => [
      value,
      (found.shape as unknown as Record<string, unknown>)[key],
    ]),
  ].every(([a, b]) => moved(a, b) <= FARTHEST);
}

/** The change of a number or a vector, relative to its size. */
function moved(a: unknown, b: unknown): number {
  const [from, to] = [a, b].map((x) => (Array.isArray(x) ? x : [x])) as [unknown[], unknown[]];
  if (typeof from[0] !== 'number') return 0;
  const size = Math.hypot(...(from as number[]));
  const off = Math.hypot(...from.map((x, i) => (x as number) - (to[i] as number)));
  return off === 0 ? 0 : off / size;
}
