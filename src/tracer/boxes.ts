import type { Rays } from '../math/batch.ts';
import type { Box } from '../math/drawing.ts';
import type { Vec3 } from '../math/index.ts';

/** A bounding volume hierarchy of boxes; a leaf is one surface. */
export type Hierarchy =
  | HierarchyLeaf
  | {
      readonly box: Box;
      readonly leaf: false;
      readonly near: Hierarchy;
      readonly far: Hierarchy;
    };

export interface HierarchyLeaf {
  readonly box: Box;
  readonly leaf: true;
  readonly surface: number;
}

export interface Boxed {
  readonly box: Box;
  readonly surface: number;
}

/**
 * Builds a hierarchy top down. Of the ways to cut the list, sorted by the middles of its boxes
 * along an axis, it takes one with the least sum of area × surfaces of both sides: the surface area
 * heuristic (Goldsmith and Salmon 1987), by which a large floor stands apart from small things. Not
 * for empty lists.
 */
export function hierarchyOf(list: readonly Boxed[]): Hierarchy {
  const [first] = list;
  if (!first) throw new RangeError('no boxes to put into a hierarchy');
  if (list.length === 1) return { box: first.box, leaf: true, surface: first.surface };
  let least = Number.POSITIVE_INFINITY;
  let near: readonly Boxed[] = [];
  let far: readonly Boxed[] = [];
  for (const axis of [0, 1, 2] as const) {
    const middle = ({ box: { low, high } }: Boxed): number => low[axis] + high[axis];
    const sorted = [...list].sort((a, b) => middle(a) - middle(b));
    const before = costs(sorted);
    const after = costs([...sorted].reverse());
    for (let k = 1; k < sorted.length; k++) {
      const cost = (before[k - 1] as number) + (after[sorted.length - k - 1] as number);
      if (near.length > 0 && !(cost < least)) continue;
      least = cost;
      near = sorted.slice(0, k);
      far = sorted.slice(k);
    }
  }
  const halves = { near: hierarchyOf(near), far: hierarchyOf(far) };
  return { box: around(halves.near.box, halves.far.box), leaf: false, ...halves };
}

/** Of the first k + 1 boxes: half the area of the box around them, times their number. */
function costs(list: readonly Boxed[]): readonly number[] {
  let all = (list[0] as Boxed).box;
  return list.map(({ box }, k) => {
    all = around(all, box);
    const { low, high } = all;
    const [x, y, z] = [high[0] - low[0], high[1] - low[1], high[2] - low[2]];
    return (x * y + y * z + z * x) * (k + 1);
  });
}

function around(a: Box, b: Box): Box {
  const pick = (f: (x: number, y: number) => number, u: Vec3, v: Vec3): Vec3 => [
    f(u[0], v[0]),
    f(u[1], v[1]),
    f(u[2], v[2]),
  ];
  return { low: pick(Math.min, a.low, b.low), high: pick(Math.max, a.high, b.high) };
}

/** Rays in a bundle. */
export const BUNDLE = 16;

/** Least and largest of one component of E and of 1/d among a bundle's rays, for each bundle. */
interface Range {
  readonly lowE: Float64Array;
  readonly highE: Float64Array;
  readonly lowSlope: Float64Array;
  readonly highSlope: Float64Array;
}

/** Rays prepared for boxes; bundle b holds rays BUNDLE·b … BUNDLE·b + BUNDLE − 1. */
export interface Bundles {
  /** 1/d by component, for each ray. */
  readonly slopes: { readonly x: Float64Array; readonly y: Float64Array; readonly z: Float64Array };
  /** By component. */
  readonly ranges: readonly [Range, Range, Range];
}

export function createBundles(capacity: number): Bundles {
  const array = (n: number): Float64Array => new Float64Array(n);
  const bundles = Math.ceil(capacity / BUNDLE);
  const range = (): Range => ({
    lowE: array(bundles),
    highE: array(bundles),
    lowSlope: array(bundles),
    highSlope: array(bundles),
  });
  const slopes = { x: array(capacity), y: array(capacity), z: array(capacity) };
  return { slopes, ranges: [range(), range(), range()] };
}

/** Computes the bundles of rays 0 … count − 1, and returns their number. */
export function bundle(
  { Ex, Ey, Ez, dx, dy, dz }: Rays,
  count: number,
  { slopes, ranges: [x, y, z] }: Bundles,
): number {
  rangeOf(Ex, dx, count, slopes.x, x);
  rangeOf(Ey, dy, count, slopes.y, y);
  rangeOf(Ez, dz, count, slopes.z, z);
  return Math.ceil(count / BUNDLE);
}

function rangeOf(
  E: Float64Array,
  d: Float64Array,
  count: number,
  slopes: Float64Array,
  { lowE, highE, lowSlope, highSlope }: Range,
): void {
  for (let first = 0, b = 0; first < count; first += BUNDLE, b++) {
    const end = Math.min(first + BUNDLE, count);
    let low = Number.POSITIVE_INFINITY;
    let high = Number.NEGATIVE_INFINITY;
    let least = Number.POSITIVE_INFINITY;
    let most = Number.NEGATIVE_INFINITY;
    for (let i = first; i < end; i++) {
      const e = E[i] as number;
      const slope = d[i] as number;
      slopes[i] = 1 / slope;
      low = e < low ? e : low;
      high = e > high ? e : high;
      least = slope < least ? slope : least;
      most = slope > most ? slope : most;
    }
    lowE[b] = low;
    highE[b] = high;
    // 1/d falls while d rises, on each side of 0; with both signs it is unbounded.
    const oneSided = least > 0 || most < 0;
    lowSlope[b] = oneSided ? 1 / most : Number.NEGATIVE_INFINITY;
    highSlope[b] = oneSided ? 1 / least : Number.POSITIVE_INFINITY;
  }
}

/**
 * Factor on t: a box side's t has 3 roundings of 2^-53 at most, however far away E is (Ize 2013,
 * Robust BVH ray traversal).
 */
const SLACK = 1 + 2 ** -50;

/**
 * Puts the bundles of list[0 … count − 1] with a ray that may meet the box at t ≥ 0 into `kept`,
 * and returns their number. Differences and products round monotonically, so that a bundle is left
 * out only if `meetBox` leaves out each of its rays. NaN, of 0·∞, rejects nothing.
 */
export function bundlesAtBox(
  { low, high }: Box,
  { ranges: [x, y, z] }: Bundles,
  list: Int32Array,
  count: number,
  kept: Int32Array,
): number {
  const [lx, ly, lz] = low;
  const [hx, hy, hz] = high;
  let n = 0;
  for (let k = 0; k < count; k++) {
    const b = list[k] as number;
    const enter = Math.max(
      0,
      bound(x, b, lx, hx, 1),
      bound(y, b, ly, hy, 1),
      bound(z, b, lz, hz, 1),
    );
    const leave = -Math.max(
      bound(x, b, lx, hx, -1),
      bound(y, b, ly, hy, -1),
      bound(z, b, lz, hz, -1),
    );
    kept[n] = b;
    n += enter > SLACK * leave ? 0 : 1;
  }
  return n;
}

/**
 * No larger than way·t of any of the bundle's rays where it enters low ≤ x ≤ high, for `way` 1, or
 * leaves it, for −1: a ray leaves where one that runs backwards enters.
 */
function bound(
  { lowE, highE, lowSlope, highSlope }: Range,
  b: number,
  low: number,
  high: number,
  way: 1 | -1,
): number {
  const forwards = way > 0;
  const least = way * ((forwards ? lowSlope : highSlope)[b] as number);
  const most = way * ((forwards ? highSlope : lowSlope)[b] as number);
  if (!(least > 0 || most < 0)) return Number.NEGATIVE_INFINITY;
  const side = least > 0 ? low - (highE[b] as number) : high - (lowE[b] as number);
  return side * (side < 0 ? most : least);
}

/**
 * Puts the rays of list[0 … count − 1] that may meet the box before their limit into `kept`, and
 * returns their number. For a ray in the plane of a side 0·∞ is NaN, which rejects nothing.
 */
export function meetBox(
  { low, high }: Box,
  { Ex, Ey, Ez }: Rays,
  { slopes: { x, y, z } }: Bundles,
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
    let enter = 0;
    let leave = limit[i] as number;
    let near = ((sx < 0 ? hx : lx) - ex) * sx;
    let far = ((sx < 0 ? lx : hx) - ex) * sx;
    if (near > enter) enter = near;
    if (far < leave) leave = far;
    near = ((sy < 0 ? hy : ly) - ey) * sy;
    far = ((sy < 0 ? ly : hy) - ey) * sy;
    if (near > enter) enter = near;
    if (far < leave) leave = far;
    near = ((sz < 0 ? hz : lz) - ez) * sz;
    far = ((sz < 0 ? lz : hz) - ez) * sz;
    if (near > enter) enter = near;
    if (far < leave) leave = far;
    kept[n] = i;
    n += enter > SLACK * leave ? 0 : 1;
  }
  return n;
}
