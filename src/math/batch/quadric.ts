import type { Shape } from '../shapes/index.ts';

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
type Readers = { readonly [K in Shape['kind']]?: (shape: ShapeOf<K>) => Quadric };

const READERS: Readers = {
  cylinder: ({ center: [Cx, Cy, Cz], radius }) => ({
    Cx,
    Cy,
    Cz,
    hasY: false,
    flare: 0,
    squared: false,
    r: radius,
    hasR: true,
  }),
  cone: ({ vertex: [Cx, Cy, Cz], slope }) => ({
    Cx,
    Cy,
    Cz,
    hasY: true,
    flare: slope,
    squared: true,
    r: 0,
    hasR: false,
  }),
  hyperboloid: ({ center: [Cx, Cy, Cz], flare, radius }) => ({
    Cx,
    Cy,
    Cz,
    hasY: true,
    flare,
    squared: false,
    r: radius,
    hasR: true,
  }),
};

/** Null for a shape without a kernel of this family. */
export function quadricOf(shape: Shape): Quadric | null {
  const read = READERS[shape.kind] as ((shape: Shape) => Quadric) | undefined;
  return read ? read(shape) : null;
}
