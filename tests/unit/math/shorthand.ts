import { coefficients, type Intersection, intersect, METHODS } from '../../../src/math/index.ts';
import type { CurvedDetails, FlatDetails, PlaneHit } from '../../../src/math/intersection.ts';
import type { Method } from '../../../src/math/methods/define.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';

export const METHOD_IDS: readonly string[] = METHODS.map(({ id }) => id);

/** Whether a method computes in float32, whose range is small. */
export const isFloat32 = (id: string): boolean =>
  (METHODS as readonly Method[])
    .find((method) => method.id === id)
    ?.parts?.(({ arithmetic }) => arithmetic.id === 'float32') === true;

/** R(t) = E + t d. */
export const ray = (E: Vec3, d: Vec3): Ray => ({ origin: E, direction: d });

export const plane = (N: Vec3, P: Vec3): Shape => ({ kind: 'plane', normal: N, point: P });
export const cylinder = (C: Vec3, r: number): Shape => ({ kind: 'cylinder', center: C, radius: r });
export const cone = (V: Vec3, c: number): Shape => ({ kind: 'cone', vertex: V, slope: c });
export const hyperboloid = (C: Vec3, a: number, r: number): Shape => ({
  kind: 'hyperboloid',
  center: C,
  flare: a,
  radius: r,
});
export const circle = (N: Vec3, C: Vec3, r: number): Shape => ({
  kind: 'circle',
  normal: N,
  center: C,
  radius: r,
});
export const square = (P: Vec3, L: number, axis: 'x' | 'y' | 'z'): Shape => ({
  kind: 'square',
  corner: P,
  side: L,
  axis,
});
export const sphere = (C: Vec3, r: number): Shape => ({ kind: 'sphere', center: C, radius: r });
export const paraboloid = (V: Vec3, k: number): Shape => ({
  kind: 'paraboloid',
  vertex: V,
  width: k,
});

export const exactly = (shape: Shape, r: Ray): Intersection => intersect(shape, r, 'exact');
export const exactCoefficients = (shape: Shape, r: Ray) => coefficients(shape, r, 'exact');

export function curvedDetails({ details }: Intersection): CurvedDetails {
  if (details.family !== 'curved') throw new Error('a flat shape');
  return details;
}

export function flatDetails({ details }: Intersection): FlatDetails {
  if (details.family !== 'flat') throw new Error('a curved shape');
  return details;
}

/** Where the line meets the figure's plane; throws if nowhere. */
export function planeHit(found: Intersection): PlaneHit {
  const { plane: hit } = flatDetails(found);
  if (!hit) throw new Error('the line is parallel to the plane');
  return hit;
}

export const roots = ({ hits }: Intersection): number[] => hits.map(({ t }) => t);
