import type { Shape } from '../shapes/index.ts';
import type { Vec3 } from '../vec3.ts';

/**
 * The numbers of a curved shape, (x−Cx)² + (z−Cz)² = a(y−Cy)² + ρ, as kernels take them. Which symbol stands for what is
 * the shapes' own business; that this table and their trees agree is tested bit by bit. A curved shape that is not in
 * the table has no kernel and is served by its trees.
 */
export interface Quadric {
  readonly Cx: number;
  readonly Cy: number;
  readonly Cz: number;
  /** Whether the formula has a term in y at all: a cylinder's does not look at y, a hyperboloid's with a = 0 does. */
  readonly hasY: boolean;
  /** a, or c where a = c² (`squared`): c² is not always a double. */
  readonly flare: number;
  readonly squared: boolean;
  /** ρ = r²; a cone has r = 0. */
  readonly r: number;
  readonly hasR: boolean;
}

type ShapeOf<K extends Shape['kind']> = Extract<Shape, { readonly kind: K }>;

interface Reader<S> {
  read(shape: S): Quadric;
  /** Whether `q`, which was read from a shape of this kind, has the numbers that `shape` has now. */
  holds(shape: S, q: Quadric): boolean;
}

type Readers = { readonly [K in Shape['kind']]?: Reader<ShapeOf<K>> };

const isAt = (C: Vec3, { Cx, Cy, Cz }: Quadric): boolean =>
  C[0] === Cx && C[1] === Cy && C[2] === Cz;

const READERS: Readers = {
  cylinder: {
    read: ({ center: C, radius }) => ({
      Cx: C[0],
      Cy: C[1],
      Cz: C[2],
      hasY: false,
      flare: 0,
      squared: false,
      r: radius,
      hasR: true,
    }),
    holds: ({ center, radius }, q) => radius === q.r && isAt(center, q),
  },
  cone: {
    read: ({ vertex: V, slope }) => ({
      Cx: V[0],
      Cy: V[1],
      Cz: V[2],
      hasY: true,
      flare: slope,
      squared: true,
      r: 0,
      hasR: false,
    }),
    holds: ({ vertex, slope }, q) => slope === q.flare && isAt(vertex, q),
  },
  hyperboloid: {
    read: ({ center: C, flare, radius }) => ({
      Cx: C[0],
      Cy: C[1],
      Cz: C[2],
      hasY: true,
      flare,
      squared: false,
      r: radius,
      hasR: true,
    }),
    holds: ({ center, flare, radius }, q) => flare === q.flare && radius === q.r && isAt(center, q),
  },
};

const readerOf = (kind: Shape['kind']): Reader<Shape> | undefined =>
  READERS[kind] as Reader<Shape> | undefined;

/** Null for a shape without a kernel of this family. */
export function quadricOf(shape: Shape): Quadric | null {
  return readerOf(shape.kind)?.read(shape) ?? null;
}

/** Whether `q`, read from a shape of the kind `kind`, is what quadricOf(shape) would be: zeros of either sign are one number. Allocates nothing. */
export function stillHolds(q: Quadric, kind: Shape['kind'], shape: Shape): boolean {
  return shape.kind === kind && readerOf(kind)?.holds(shape, q) === true;
}
