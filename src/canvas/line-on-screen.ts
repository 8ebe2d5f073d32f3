import type { Vec3 } from '../math/index.ts';
import type { Projection } from './projection.ts';
import { along, dot, type Point } from './stage-units.ts';

/** The projection of a line through a point of the scene, to convert px along it to lengths. */
export interface LineOnScreen {
  /** The line's direction on the screen, of length 1. */
  readonly course: readonly [number, number];
  /** Pixels per stage unit at the point. */
  readonly scale: number;
  /** Length along the line, in stage units, of so many pixels along `course`. */
  reach(pixels: number): number;
}

/**
 * Least ratio of seen to true length. A line that is foreshortened more, because it leads to the
 * eye, is treated as if it had this ratio.
 */
const MIN_FORESHORTENING = 0.12;
/** Least ratio of the scale near the vanishing point to the scale at the handle. */
const MIN_CLOSING = 0.1;
/** Longest drag, in stage radii. */
const MAX_REACH = 4;

export function lineOnScreen(place: Point, direction: Vec3, projection: Projection): LineOnScreen {
  const depth = Math.max(projection.distance(place), projection.near);
  const from = along(place, projection.eye, -1);
  const towards = dot(direction, projection.forward);
  // The derivative of the projection along the line.
  const x = dot(direction, projection.right) - (dot(from, projection.right) * towards) / depth;
  const y = -dot(direction, projection.up) + (dot(from, projection.up) * towards) / depth;
  const length = Math.hypot(x, y);
  const scale = (projection.focal / depth) * Math.max(length, MIN_FORESHORTENING);
  return {
    course: length > 1e-6 ? [x / length, y / length] : [1, 0],
    scale,
    reach(pixels) {
      const closing = Math.max(scale - (pixels * towards) / depth, MIN_CLOSING * scale);
      return Math.min(Math.max(pixels / closing, -MAX_REACH), MAX_REACH);
    },
  };
}
