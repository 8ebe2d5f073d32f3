import type { Quadric } from '../../../src/math/batch/quadric.ts';
import * as dy from '../../../src/math/exact/dyadic.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { type Random, randomSign, uniform } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { flareOf, form, solved } from './exact-quadratic.ts';

/* A curved shape and a ray as numbers in a row, so that a search can change them. */

export const log = (random: Random, low: number, high: number): number =>
  2 ** uniform(random, low, high);

/** C, a (or c), r, E and d in a row. */
export type Numbers = readonly number[];

export function questionOf(kind: Kind, x: Numbers): { readonly shape: Shape; readonly ray: Ray } {
  const [Cx, Cy, Cz, flare, radius, Ex, Ey, Ez, dx, dyi, dz] = x as unknown as readonly [
    ...[number, number, number, number, number, number],
    ...[number, number, number, number, number],
  ];
  const C = [Cx, Cy, Cz] as const;
  const shapes: Readonly<Record<Kind, Shape>> = {
    cylinder: { kind: 'cylinder', center: C, radius },
    cone: { kind: 'cone', vertex: C, slope: flare },
    hyperboloid: { kind: 'hyperboloid', center: C, flare, radius },
  };
  return { shape: shapes[kind], ray: { origin: [Ex, Ey, Ez], direction: [dx, dyi, dz] } };
}
export type Kind = 'cylinder' | 'cone' | 'hyperboloid';
export const KINDS: readonly Kind[] = ['cylinder', 'cone', 'hyperboloid'];

const n = dy.fromNumber;
/** D/4, exactly. */
export const quarter = (q: Quadric, ray: Ray): dy.Dyadic =>
  dy.shift(solved(q, ray).discriminant, -2);

export function exactA(q: Quadric, { direction }: Ray): dy.Dyadic {
  const d = direction.map(n);
  return form(q.hasY ? flareOf(q) : dy.ZERO, d, d);
}

/** A ray that passes the shape's outline by `off` of its size, from `far` sizes away. */
export function grazing(kind: Kind, random: Random, off: number, far: number): number[] {
  const radius = uniform(random, 0.5, 2);
  const phi = uniform(random, 0, 6.3);
  const [c, s] = [Math.cos(phi), Math.sin(phi)];
  const speed = log(random, -3, 3);
  const side = 1 - off;
  const center = [uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -2, 2)];
  const h = uniform(random, -1, 1);
  const flare = randomSign(random) * log(random, -3, 2);
  const outline =
    kind === 'cone'
      ? Math.abs(flare * h) * side
      : Math.sqrt(Math.max(radius * radius + (kind === 'cylinder' ? 0 : flare * h * h), 0.01)) *
        side;
  const [x, z] = [outline * c, outline * s];
  const direction = [-speed * s, 0, speed * c];
  return [
    ...center,
    flare,
    radius,
    ...[x + far * s, h, z - far * c].map((e, k) => e + (center[k] as number)),
    ...direction,
  ];
}

/** Any ray about the shape. */
export function about(random: Random): number[] {
  const any = (size: number): number => uniform(random, -size, size);
  return [
    ...[any(2), any(2), any(2), randomSign(random) * log(random, -4, 4), uniform(random, 0.3, 2)],
    ...[any(9), any(9), any(9), any(2), any(2), any(2)],
  ];
}
