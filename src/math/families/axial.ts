import { pick, type Random, randomSign, uniform } from '../rng.ts';
import type { Vec3 } from '../vec3.ts';
import type { Setting } from './define.ts';
import { inBox, onUnitCircle } from './random-vectors.ts';

/**
 * A curved shape with the numbers of its equation (x−Cx)² + (z−Cz)² = a(y−Cy)² + r², as far as
 * doubles tell them.
 */
export interface Axial extends Setting {
  readonly center: Vec3;
  readonly a: number;
  readonly r: number;
  /** The same kind of shape in another place and size; a is a ratio and stays. */
  moved(center: Vec3, r: number): Axial;
}

export const cylinderOf = (center: Vec3, radius: number): Axial => ({
  shape: { kind: 'cylinder', center, radius },
  center,
  a: 0,
  r: radius,
  moved: cylinderOf,
});

export const coneOf = (vertex: Vec3, slope: number): Axial => ({
  shape: { kind: 'cone', vertex, slope },
  center: vertex,
  a: slope * slope,
  r: 0,
  moved: (at) => coneOf(at, slope),
});

export const hyperboloidOf = (center: Vec3, flare: number, radius: number): Axial => ({
  shape: { kind: 'hyperboloid', center, flare, radius },
  center,
  a: flare,
  r: radius,
  moved: (at, r) => hyperboloidOf(at, flare, r),
});

export const ordinaryCylinder = (random: Random): Axial =>
  cylinderOf(inBox(random, 2), uniform(random, 0.3, 2));
const ordinaryCone = (random: Random): Axial => coneOf(inBox(random, 2), uniform(random, 0.3, 2));
const ordinaryHyperboloid = (random: Random): Axial =>
  hyperboloidOf(inBox(random, 2), uniform(random, 0.2, 2), uniform(random, 0.3, 2));

/** One of the three curved shapes, about as large as its distance from the origin. */
export const ordinaryAxial = (random: Random): Axial =>
  pick(random, [ordinaryCylinder, ordinaryCone, ordinaryHyperboloid])(random);

/** A length to compare others with: r, or for a cone its radius at height 1. */
export const sizeOf = ({ a, r }: Axial): number => r || Math.sqrt(Math.abs(a)) || 1;

/**
 * A height at which the circle is not tiny: 1…2 from a cone's vertex, up to 1 from
 * another centre.
 */
const ordinaryHeight = (random: Random, { r }: Axial): number =>
  r === 0 ? randomSign(random) * uniform(random, 1, 2) : uniform(random, -1, 1);

/** The radius of its circle at height h above the centre. */
const radiusAt = ({ a, r }: Axial, h: number): number => Math.sqrt(Math.max(0, a * h * h + r * r));

interface SurfacePoint {
  readonly point: Vec3;
  /** The outward gradient's direction there, not normalised. */
  readonly normal: Vec3;
}

/** A point of the surface, as nearly as doubles have it. */
export function surfacePoint(random: Random, axial: Axial): SurfacePoint {
  const h = ordinaryHeight(random, axial);
  const [cos, sin] = onUnitCircle(random);
  const radius = radiusAt(axial, h);
  const [x, y, z] = axial.center;
  return {
    point: [x + radius * cos, y + h, z + radius * sin],
    normal: [radius * cos, -axial.a * h, radius * sin],
  };
}

/** A point well inside one of its circles, up to 0.95 of the radius from the axis. */
export function innerPoint(random: Random, axial: Axial): Vec3 {
  const h = ordinaryHeight(random, axial);
  const [cos, sin] = onUnitCircle(random);
  const radius = uniform(random, 0, 0.95) * radiusAt(axial, h);
  const [x, y, z] = axial.center;
  return [x + radius * cos, y + h, z + radius * sin];
}
