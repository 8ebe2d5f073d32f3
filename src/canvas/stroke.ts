import type { Projection } from './projection.ts';
import type { Ink } from './theme.ts';

/** Lengths in px of a dash and of a gap. */
export type Dash = readonly [on: number, off: number];

/** A line of the scene: points in stage units, a width in CSS pixels. */
export interface Stroke {
  /** x, y, z of each point, one after the other. */
  readonly points: Float64Array;
  /** Factor on the opacity at each point, for lines that fade out. */
  readonly fade: Float64Array | null;
  readonly closed: boolean;
  readonly ink: Ink;
  readonly width: number;
  readonly alpha: number;
  readonly dash: Dash | null;
}

/**
 * A visible piece of a stroke: x, y in px, depth, opacity of each point. Reused for the next one.
 */
export interface Run {
  readonly data: readonly number[];
  readonly count: number;
  readonly closed: boolean;
}

/** Draws strokes: as triangles on the GPU, or as SVG paths without WebGL. */
export interface Pen {
  draw(run: Run, stroke: Stroke): void;
}

/** Points nearer than this in px count as one, since their direction would be rounding noise. */
const SAME_PIXELS = 0.02;

const data: number[] = [];

/** Projects a stroke and draws its visible pieces. `nearer` as in Projection.project. */
export function paint(stroke: Stroke, projection: Projection, pen: Pen, nearer = 0): void {
  const { points, fade } = stroke;
  const total = points.length / 3;
  let count = 0;
  let broken = false;
  const flush = (closed: boolean) => {
    if (count > 1) pen.draw({ data, count, closed: closed && count > 2 }, stroke);
    count = 0;
  };
  const add = (x: number, y: number, z: number, opacity: number) => {
    const spot = projection.project([x, y, z], nearer);
    if (!spot) return;
    const last = 4 * (count - 1);
    if (
      count &&
      Math.abs(spot.x - at(data, last)) + Math.abs(spot.y - at(data, last + 1)) < SAME_PIXELS
    )
      return;
    const next = 4 * count++;
    data[next] = spot.x;
    data[next + 1] = spot.y;
    data[next + 2] = spot.depth;
    data[next + 3] = opacity;
  };
  let wasSeen = false;
  for (let k = 0; k < total; k++) {
    const [x, y, z] = [at(points, 3 * k), at(points, 3 * k + 1), at(points, 3 * k + 2)];
    const opacity = fade ? at(fade, k) : 1;
    const w = projection.distance([x, y, z]);
    const isSeen = w >= projection.near;
    if (k > 0 && isSeen !== wasSeen) {
      // Cut slightly in front of the near plane, so that rounding cannot put the point behind it.
      broken = true;
      const p = 3 * (k - 1);
      const [px, py, pz] = [at(points, p), at(points, p + 1), at(points, p + 2)];
      const before = projection.distance([px, py, pz]);
      const s = (projection.near * (1 + 1e-9) - before) / (w - before);
      add(px + s * (x - px), py + s * (y - py), pz + s * (z - pz), opacity);
      if (wasSeen) flush(false);
    }
    if (isSeen) add(x, y, z, opacity);
    wasSeen = isSeen;
  }
  flush(stroke.closed && !broken);
}

/** A straight stroke. */
export function straight(
  from: readonly number[],
  to: readonly number[],
  style: Pick<Stroke, 'ink' | 'width' | 'alpha' | 'dash'>,
): Stroke {
  return { points: Float64Array.of(...from, ...to), fade: null, closed: false, ...style };
}

/** The element at an index that exists. */
export function at(list: ArrayLike<number>, index: number): number {
  return list[index] as number;
}
