import type { Projection } from './projection.ts';
import type { Stroke } from './stroke.ts';
import type { Theme } from './theme.ts';

/**
 * The strokes of a frame in the order they are painted; the shape's walls come between `ray` and
 * `shape`.
 */
export interface Strokes {
  readonly ground: readonly Stroke[];
  readonly ray: readonly Stroke[];
  readonly shape: readonly Stroke[];
}

/** Paints a frame by WebGL or SVG. */
export interface Painter {
  /** @param ratio device px per CSS px, if it can be chosen; by default the screen's. */
  paint(strokes: Strokes, projection: Projection, theme: Theme, ratio?: number): void;
  dispose(): void;
}

/**
 * The ray is painted this much nearer than it is, in stage radii, so that a ray that lies in the
 * surface is not broken up by it: the sampled walls are off by up to 1 − cos(π/96) = 0.0005 of
 * their radius.
 */
export const RAY_NEARER = 0.004;
