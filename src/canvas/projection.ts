import type { Vec3 } from '../math/index.ts';
import { type Pose, radians } from './camera.ts';
import { along, dot, type Point } from './stage-units.ts';

/** Vertical field of view, in degrees. */
const FOV = 24;
/** Distance of the camera at zoom 1, in stage radii: the stage then fills the frame's width. */
const DISTANCE = 2.9;
/** Width over height below which the frame's width sets the camera's distance, not its height. */
const WIDEST_TALL = 1.6;

/**
 * A point in the frame: CSS pixels from the top left, and the depth that WebGL stores, −1 near to 1
 * far.
 */
export interface ScreenPoint {
  x: number;
  y: number;
  depth: number;
}

/**
 * A pose in a frame of a given size: turns stage units into pixels, in doubles. GPU and SVG use
 * this one projection.
 */
export class Projection {
  readonly width: number;
  readonly height: number;
  readonly eye: Point;
  readonly right: Point;
  readonly up: Point;
  readonly forward: Point;
  readonly near: number;
  readonly far: number;
  /** Focal length in px: px per unit of x/depth. */
  readonly focal: number;
  readonly #depthScale: number;
  readonly #depthShift: number;

  constructor(pose: Pose, width: number, height: number) {
    this.width = width;
    this.height = height;
    const [a, e] = [radians(pose.azimuth), radians(pose.elevation)];
    const [sa, ca, se, ce] = [Math.sin(a), Math.cos(a), Math.sin(e), Math.cos(e)];
    // The up vector is the derivative by elevation, so looking straight down needs no special case.
    this.right = [ca, 0, -sa];
    this.up = [-se * sa, ce, -se * ca];
    this.forward = [-ce * sa, -se, -ce * ca];
    const distance = (DISTANCE * Math.max(1, (WIDEST_TALL * height) / width)) / pose.zoom;
    this.eye = along(pose.target, this.forward, -distance);
    this.near = Math.max(distance - 4, distance / 20);
    this.far = distance + 6;
    this.focal = height / 2 / Math.tan(radians(FOV / 2));
    this.#depthScale = (this.far + this.near) / (this.far - this.near);
    this.#depthShift = (2 * this.far * this.near) / (this.far - this.near);
  }

  /** Depth of p in front of the eye, in stage units. */
  distance(p: Vec3): number {
    return dot(along(p, this.eye, -1), this.forward);
  }

  /** Null behind the near plane. `nearer` reduces only the depth, in stage radii. */
  project(p: Vec3, nearer = 0): ScreenPoint | null {
    const rel = along(p, this.eye, -1);
    const w = dot(rel, this.forward);
    if (!(w >= this.near)) return null;
    const seen = Math.max(w - nearer, this.near);
    return {
      x: this.width / 2 + (this.focal * dot(rel, this.right)) / w,
      y: this.height / 2 - (this.focal * dot(rel, this.up)) / w,
      depth: this.#depthScale - this.#depthShift / seen,
    };
  }

  /**
   * A direction of the world on the screen, without perspective: pixels per stage unit at the
   * target. y points down.
   */
  onScreen(direction: Vec3): readonly [number, number] {
    return [dot(direction, this.right), -dot(direction, this.up)];
  }

  /** Column-major, as in WebGL. */
  viewMatrix(): number[] {
    const { right: r, up: u, forward: f, eye } = this;
    const [x, y, z] = [-dot(r, eye), -dot(u, eye), dot(f, eye)];
    return [r[0], u[0], -f[0], 0, r[1], u[1], -f[1], 0, r[2], u[2], -f[2], 0, x, y, z, 1];
  }

  projectionMatrix(): number[] {
    const x = (2 * this.focal) / this.width;
    const y = (2 * this.focal) / this.height;
    return [x, 0, 0, 0, 0, y, 0, 0, 0, 0, -this.#depthScale, -1, 0, 0, -this.#depthShift, 0];
  }
}
