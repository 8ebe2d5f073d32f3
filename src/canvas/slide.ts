import type { Vec3 } from '../math/vec3.ts';
import type { Lens } from './lens.ts';
import { along, dot, type Point } from './space.ts';

/** Along a straight line through a point of the picture. */
export interface Slide {
  /** On the screen, of length 1. */
  readonly course: readonly [number, number];
  /** Pixels per stage unit at the point. */
  readonly scale: number;
  /** How far along the line, in stage units, so many pixels along its course are. */
  reach(pixels: number): number;
}

/** Foreshortened to less than this, a line leads to the eye: it then moves as if it were seen at this length. */
const LEAST_LENGTH = 0.12;
/** Towards its vanishing point a line is drawn ever closer: from here on evenly. */
const LEAST_CLOSING = 0.1;
/** No drag leads farther than this, in stage radii. */
const FARTHEST = 4;

export function slide(place: Point, direction: Vec3, lens: Lens): Slide {
  const depth = Math.max(lens.distance(place), lens.near);
  const from = along(place, lens.eye, -1);
  const towards = dot(direction, lens.forward);
  // The derivative of the projection along the line.
  const x = dot(direction, lens.right) - (dot(from, lens.right) * towards) / depth;
  const y = -dot(direction, lens.up) + (dot(from, lens.up) * towards) / depth;
  const length = Math.hypot(x, y);
  const scale = (lens.focal / depth) * Math.max(length, LEAST_LENGTH);
  return {
    course: length > 1e-6 ? [x / length, y / length] : [1, 0],
    scale,
    reach(pixels) {
      const closing = Math.max(scale - (pixels * towards) / depth, LEAST_CLOSING * scale);
      return Math.min(Math.max(pixels / closing, -FARTHEST), FARTHEST);
    },
  };
}
