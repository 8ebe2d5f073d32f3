import type { Shape } from '../shapes/index.ts';
import { type Axis, axisIndex, type Vec3 } from '../vec3.ts';

/**
 * The numbers of a flat shape as kernels take them: its plane and where the figure ends. As with quadrics, that this
 * table and the shapes' trees agree is tested bit by bit.
 */
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

type ShapeOf<K extends Shape['kind']> = Extract<Shape, { readonly kind: K }>;
type Readers = { readonly [K in Shape['kind']]?: (shape: ShapeOf<K>) => Planar };

const UNIT: Readonly<Record<Axis, Vec3>> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

const READERS: Readers = {
  plane: ({ normal, point }) => ({ N: normal, P: point, bound: 'none', size: 0, u: 0, v: 0 }),
  circle: ({ normal, center, radius }) => ({
    N: normal,
    P: center,
    bound: 'circle',
    size: radius,
    u: 0,
    v: 0,
  }),
  square: ({ corner, side, axis }) => {
    const n = axisIndex(axis);
    return {
      N: UNIT[axis],
      P: corner,
      bound: 'square',
      size: side,
      u: n === 0 ? 1 : 0,
      v: n === 2 ? 1 : 2,
    };
  },
};

/** Null for a shape without a kernel of this family. */
export function planarOf(shape: Shape): Planar | null {
  const read = READERS[shape.kind] as ((shape: Shape) => Planar) | undefined;
  return read ? read(shape) : null;
}
