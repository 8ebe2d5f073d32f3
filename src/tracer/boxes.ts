import type { Rays } from '../math/batch.ts';
import type { Box } from '../math/drawing.ts';
import type { Vec3 } from '../math/index.ts';

/** A bounding volume hierarchy of boxes; a leaf is one surface. */
export type Hierarchy =
  | { readonly box: Box; readonly leaf: true; readonly surface: number }
  | {
      readonly box: Box;
      readonly leaf: false;
      readonly near: Hierarchy;
      readonly far: Hierarchy;
    };

export interface Boxed {
  readonly box: Box;
  readonly surface: number;
}

/**
 * Builds a hierarchy by halving the list at the median of its longest axis. Not for empty lists.
 */
export function hierarchyOf(list: readonly Boxed[]): Hierarchy {
  const [first] = list;
  if (!first) throw new RangeError('no boxes to put into a hierarchy');
  const box = list.reduce((all, one) => around(all, one.box), first.box);
  if (list.length === 1) return { box, leaf: true, surface: first.surface };
  const sizes = [0, 1, 2].map((k) => (box.high[k] as number) - (box.low[k] as number));
  const axis = sizes.indexOf(Math.max(...sizes)) as 0 | 1 | 2;
  const middle = ({ box: { low, high } }: Boxed): number => low[axis] + high[axis];
  const sorted = [...list].sort((a, b) => middle(a) - middle(b));
  const half = sorted.length >> 1;
  return {
    box,
    leaf: false,
    near: hierarchyOf(sorted.slice(0, half)),
    far: hierarchyOf(sorted.slice(half)),
  };
}

function around(a: Box, b: Box): Box {
  const pick = (f: (x: number, y: number) => number, u: Vec3, v: Vec3): Vec3 => [
    f(u[0], v[0]),
    f(u[1], v[1]),
    f(u[2], v[2]),
  ];
  return { low: pick(Math.min, a.low, b.low), high: pick(Math.max, a.high, b.high) };
}

/** 1/d by component. */
export interface Slopes {
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
}

/**
 * Factor on t: a box side's t has 3 roundings of 2^-53 at most, however far away E is (Ize 2013,
 * Robust BVH ray traversal).
 */
const SLACK = 1 + 2 ** -50;

/**
 * Puts the rays of list[0 … count − 1] that may meet the box before their limit into `kept`, and
 * returns their number. For a ray in the plane of a side 0·∞ is NaN, which rejects nothing.
 */
export function meetBox(
  { low, high }: Box,
  { Ex, Ey, Ez }: Rays,
  { x, y, z }: Slopes,
  limit: Float64Array,
  list: Int32Array,
  count: number,
  kept: Int32Array,
): number {
  const [lx, ly, lz] = low;
  const [hx, hy, hz] = high;
  let n = 0;
  for (let k = 0; k < count; k++) {
    const i = list[k] as number;
    const ex = Ex[i] as number;
    const ey = Ey[i] as number;
    const ez = Ez[i] as number;
    const sx = x[i] as number;
    const sy = y[i] as number;
    const sz = z[i] as number;
    const ax = (lx - ex) * sx;
    const bx = (hx - ex) * sx;
    const ay = (ly - ey) * sy;
    const by = (hy - ey) * sy;
    const az = (lz - ez) * sz;
    const bz = (hz - ez) * sz;
    const enter = Math.max(Math.min(ax, bx), Math.min(ay, by), Math.min(az, bz));
    const leave = SLACK * Math.min(Math.max(ax, bx), Math.max(ay, by), Math.max(az, bz));
    kept[n] = i;
    n += enter > leave || leave < 0 || enter > SLACK * (limit[i] as number) ? 0 : 1;
  }
  return n;
}
