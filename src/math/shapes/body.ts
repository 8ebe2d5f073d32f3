import type { Vec3 } from '../vec3.ts';
import type { Planar, Quadric } from './numbers.ts';

/** A box with sides along the axes that holds a whole surface. */
export interface Box {
  readonly low: Vec3;
  readonly high: Vec3;
}

/** Heights y from `low` to `high` that a surface is kept between. */
export type Heights = readonly [low: number, high: number];

/** A horizontal circle about a vertical axis. */
interface Disc {
  readonly x: number;
  readonly z: number;
  readonly radius: number;
}

/** What a picture needs to know of a shape as a thing in space. */
export interface Body<S> {
  /** A box that holds the surface (its part between the heights, if given); null: none is known. */
  box(shape: S, between: Heights | null): Box | null;
  /** The circle that the surface has at height y, null where it has none. Null: it is not round. */
  readonly circleAt: ((shape: S, y: number) => Disc | null) | null;
  /** Whether the surface is the border of a convex set, or flat. False where it is not known. */
  convex(shape: S): boolean;
}

/** For a shape of which nothing is known: it is traced without a box and has no caps. */
export const UNKNOWN_BODY: Body<unknown> = {
  box: () => null,
  circleAt: null,
  convex: () => false,
};

export function quadricBody<S>(read: (shape: S) => Quadric): Body<S> {
  return {
    box: (shape, between) => quadricBox(read(shape), between),
    circleAt: (shape, y) => circleOf(read(shape), y),
    convex(shape) {
      const q = read(shape);
      return !q.hasY || (!q.squared && q.flare < 0);
    },
  };
}

export function planarBody<S>(read: (shape: S) => Planar): Body<S> {
  return { box: (shape) => planarBox(read(shape)), circleAt: null, convex: () => true };
}

function circleOf(q: Quadric, y: number): Disc | null {
  const h = q.hasY ? y - q.Cy : 0;
  const squared = q.squared ? (q.flare * h) ** 2 : q.flare * h * h;
  const radius = Math.sqrt(squared + q.r * q.r);
  return radius > 0 ? { x: q.Cx, z: q.Cz, radius } : null;
}

function quadricBox(q: Quadric, between: Heights | null): Box | null {
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
  return roomyBox([-radius, low, -radius], [radius, high, radius], [q.Cx, center, q.Cz]);
}

function planarBox({ N, P, bound, size, u, v }: Planar): Box | null {
  if (bound === 'none') return null;
  if (bound === 'circle') {
    const length = Math.hypot(...N);
    return roomyBox(
      N.map((n) => -size * across(n / length)),
      N.map((n) => size * across(n / length)),
      P,
    );
  }
  const reach = [0, 1, 2].map((axis) => (axis === u || axis === v ? size : 0));
  return roomyBox([0, 0, 0], reach, P);
}

/** The extent of a unit disc along an axis that makes this cosine with its normal. */
const across = (cosine: number): number => Math.sqrt(Math.max(0, 1 - cosine * cosine));

/** Some roundings of 2^-53 go into a box's corner, relative to its size and its place. */
const ROOM = 2 ** -40;

/** The box from at + low to at + high, made larger by 2^-40 of its largest number. */
export function roomyBox(low: readonly number[], high: readonly number[], at: Vec3): Box {
  const size = Math.max(...low.map(Math.abs), ...high.map(Math.abs), ...at.map(Math.abs));
  const room = ROOM * size;
  const place = (v: readonly number[], by: number): Vec3 => [
    (v[0] as number) + at[0] + by,
    (v[1] as number) + at[1] + by,
    (v[2] as number) + at[2] + by,
  ];
  return { low: place(low, -room), high: place(high, room) };
}
