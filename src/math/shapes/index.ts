import type { Ends } from './checked.ts';
import { circle } from './circle.ts';
import { cone } from './cone.ts';
import { cylinder } from './cylinder.ts';
import type { ShapeDefinition } from './define.ts';
import { hyperboloid } from './hyperboloid.ts';
import { paraboloid } from './paraboloid.ts';
import { plane } from './plane.ts';
import { sphere } from './sphere.ts';
import { square } from './square.ts';

/**
 * Every shape there is, in the order of the menu. A new shape is one new file and one word here.
 *
 * @example
 * const { params } = SHAPES.find(({ kind }) => kind === 'cone')!;
 * params.map(({ key }) => key); // → ['vertex', 'slope']
 */
export const SHAPES = [
  plane,
  cylinder,
  cone,
  hyperboloid,
  circle,
  square,
  sphere,
  paraboloid,
] as const;

type ShapeOf<D> = D extends ShapeDefinition<infer S> ? S : never;

/**
 * A kind with its parameters, by the keys of its `params`: points and lengths in units of length.
 */
export type Shape = ShapeOf<(typeof SHAPES)[number]>;

/** A shape, which may have ends if it is curved. */
export type Solid = Shape & Ends;

/** The `kind` of one of SHAPES. */
export type ShapeKind = Shape['kind'];
