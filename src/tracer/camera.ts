import type { Vec3 } from '../math/index.ts';
import { cameraNumbers } from '../scene/camera-ray.ts';
import { CAMERA, type Wave } from '../scene/effects/body.ts';
import type { Camera } from '../scene/types.ts';
import type { PicturePart, Tile, TraceSettings } from './types.ts';

/** The camera's axes; `right` and `up` are half the picture's width and height at distance 1. */
interface CameraAxes {
  readonly eye: Vec3;
  readonly ahead: Vec3;
  readonly right: Vec3;
  readonly up: Vec3;
  /** Surface of the glass in which the eye is, or −1. */
  readonly medium: number;
}

/** By the formulas of scene/camera-ray.ts. */
export function cameraAxes(camera: Camera, aspect: number, medium = -1): CameraAxes {
  const { g, R, U } = cameraNumbers(camera, aspect, 1).vectors;
  return { eye: camera.eye, ahead: g as Vec3, right: R as Vec3, up: U as Vec3, medium };
}

/** The pixels of a tile as y · width + x, row by row; with `part` those of its pixels alone. */
export function pixelsOf(
  { y0, y1, step, refines }: Tile,
  width: number,
  part?: PicturePart,
): Int32Array {
  const found: number[] = [];
  for (let y = Math.ceil(y0 / step) * step; y < y1; y += step) {
    const known = refines && y % (2 * step) === 0;
    for (let x = known ? step : 0; x < width; x += known ? 2 * step : step) {
      const pixel = y * width + x;
      if (part?.pixels[pixel] !== 0) found.push(pixel);
    }
  }
  return Int32Array.from(found);
}

/**
 * Puts the camera rays of these pixels into the wave, a pixel's rays one after the other: u, v, D
 * and d of scene/camera-ray.ts, operation by operation.
 */
export function fireCamera(
  axes: CameraAxes,
  { width, height, samples, part }: TraceSettings,
  pixels: ArrayLike<number>,
  wave: Wave,
): void {
  const { eye, ahead, right, up, medium } = axes;
  const side = Math.round(Math.sqrt(samples));
  const fired = part?.samples ?? Array.from({ length: side * side }, (_, s) => s);
  const { rays } = wave;
  let j = 0;
  for (let k = 0; k < pixels.length; k++) {
    const pixel = pixels[k] as number;
    const x = pixel % width;
    const y = (pixel - x) / width;
    for (const s of fired) {
      const u = (2 * (x + ((s % side) + 0.5) / side)) / width - 1;
      const v = 1 - (2 * (y + (Math.floor(s / side) + 0.5) / side)) / height;
      const dx = ahead[0] + u * right[0] + v * up[0];
      const dy = ahead[1] + u * right[1] + v * up[1];
      const dz = ahead[2] + u * right[2] + v * up[2];
      const length = Math.sqrt(dx * dx + dy * dy + dz * dz);
      rays.Ex[j] = eye[0];
      rays.Ey[j] = eye[1];
      rays.Ez[j] = eye[2];
      rays.dx[j] = dx / length;
      rays.dy[j] = dy / length;
      rays.dz[j] = dz / length;
      wave.sample[j] = j;
      wave.path[j] = Math.imul(pixel * side * side + s + 1, 0x9e3779b1);
      wave.from[j] = -1;
      wave.medium[j] = medium;
      wave.kind[j] = CAMERA;
      wave.red[j] = 1;
      wave.green[j] = 1;
      wave.blue[j] = 1;
      wave.node[j] = -1;
      j += 1;
    }
  }
  wave.count = j;
  rays.count = j;
}
