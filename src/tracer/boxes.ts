import type { Rays } from '../math/batch/batch.ts';
import { planarOf } from '../math/batch/planar.ts';
import { quadricOf } from '../math/batch/quadric.ts';
import type { Vec3 } from '../math/vec3.ts';
import type { Surface } from '../scene/surfaces.ts';

/** A box with sides along the axes that the whole surface lies in. */
export interface Box {
  readonly low: Vec3;
  readonly high: Vec3;
}

/** The box of a surface, a little larger than it is; null for one that has no end. */
export function boxOf({ shape, between }: Surface): Box | null {
  const planar = planarOf(shape);
  if (planar) {
    const { N, P, bound, size, u, v } = planar;
    if (bound === 'none') return null;
    if (bound === 'circle') {
      const length = Math.hypot(...N);
      return roomy(
        N.map((n) => -size * across(n / length)),
        N.map((n) => size * across(n / length)),
        P,
      );
    }
    const reach = [0, 1, 2].map((axis) => (axis === u || axis === v ? size : 0));
    return roomy([0, 0, 0], reach, P);
  }
  const q = quadricOf(shape);
  if (!q) return null;
  const a = q.squared ? q.flare * q.flare : q.hasY ? q.flare : 0;
  // An ellipsoid ends by itself.
  const end = a < 0 ? q.r / Math.sqrt(-a) : Number.POSITIVE_INFINITY;
  const center = q.hasY ? q.Cy : 0;
  const low = Math.max(between ? between[0] - center : -end, -end);
  const high = Math.min(between ? between[1] - center : end, end);
  if (!(high - low < Number.POSITIVE_INFINITY)) return null;
  // The widest circle: at an end, or for an ellipsoid where it is nearest to the middle.
  const height = a < 0 ? Math.min(Math.max(0, low), high) : Math.max(Math.abs(low), Math.abs(high));
  const radius = Math.sqrt(Math.max(0, a * height * height + q.r * q.r));
  return roomy([-radius, low, -radius], [radius, high, radius], [q.Cx, center, q.Cz]);
}

/** The extent of a unit disc along an axis that makes this cosine with its normal. */
const across = (cosine: number): number => Math.sqrt(Math.max(0, 1 - cosine * cosine));

/** Some roundings of 2^-53 go into a box's corner, relative to its size and its place. */
const ROOM = 2 ** -40;

function roomy(low: readonly number[], high: readonly number[], at: Vec3): Box {
  const size = Math.max(...low.map(Math.abs), ...high.map(Math.abs), ...at.map(Math.abs));
  const room = ROOM * size;
  const place = (v: readonly number[], by: number): Vec3 => [
    (v[0] as number) + at[0] + by,
    (v[1] as number) + at[1] + by,
    (v[2] as number) + at[2] + by,
  ];
  return { low: place(low, -room), high: place(high, room) };
}

/** Boxes around boxes: a leaf is one surface. */
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

/** Halves the list at the median along the axis in which it is longest. The list must not be empty. */
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

/** Each t of a side is off by 3 roundings of 2^-53 at most, however far away E is (Ize 2013, Robust BVH ray traversal). */
const SLACK = 1 + 2 ** -50;

/**
 * Of the rays list[0 … count − 1] those that may meet the box before their limit, into `kept`; returns how many. A ray in the plane of a side
 * makes 0·∞, which is NaN and rejects nothing.
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
