import type { Vec3 } from '../vec3.ts';

/**
 * The numbers of a round quadric (x−Cx)² + (z−Cz)² = a(y−Cy)² + ρ, as `certified` and
 * `exact` take them: their answers do not depend on an order of operations.
 */
export interface Quadric {
  readonly Cx: number;
  readonly Cy: number;
  readonly Cz: number;
  /** False: the formula has no term in y (a cylinder's; a hyperboloid's with a = 0 has one). */
  readonly hasY: boolean;
  /** a where `squared` is false; c where it is true, and a = c², which is not always a double. */
  readonly flare: number;
  /** A cone's: its `flare` is its slope c. */
  readonly squared: boolean;
  /** ρ = r²; 0 for a cone. */
  readonly r: number;
  readonly hasR: boolean;
}

/** The numbers of a flat shape as kernels take them: its plane, and where the figure ends. */
export interface Planar {
  readonly N: Vec3;
  /** P, or a circle's C. */
  readonly P: Vec3;
  readonly bound: 'none' | 'circle' | 'square';
  /** r of a circle, L of a square. */
  readonly size: number;
  /** A square's in-plane axes, ascending. */
  readonly u: 0 | 1 | 2;
  readonly v: 0 | 1 | 2;
}

export interface QuadricNumbers<S> {
  readonly family: 'quadric';
  read(shape: S): Quadric;
  /** Whether `q`, read from a shape of this kind, has the numbers that `shape` has now. */
  holds(shape: S, q: Quadric): boolean;
}

export interface PlanarNumbers<S> {
  readonly family: 'planar';
  read(shape: S): Planar;
}

/** How the fast kernels take a shape; null: every method answers by the shape's trees. */
export type KernelNumbers<S> = QuadricNumbers<S> | PlanarNumbers<S> | null;

/** Whether the quadric's centre is C; zeros of either sign are one number. */
export const isAt = (C: Vec3, { Cx, Cy, Cz }: Quadric): boolean =>
  C[0] === Cx && C[1] === Cy && C[2] === Cz;
