import type { Vec3 } from '../../math/index.ts';
import type { Camera } from '../../scene/types.ts';

/*
 * Edits of a camera: turn it about its target, shift both, change their distance. Each edit is a
 * function of the camera, so that the edits of one gesture can be applied one after the other.
 */

export type CameraEdit = (camera: Camera) => Camera;

/** How near to straight up or down a camera may look, in radians. */
const MOST_STEEP = Math.PI / 2 - 0.001;

/** Turns it by angles in radians: to the right, and upwards. */
export const turned =
  (right: number, up: number): CameraEdit =>
  (camera) => {
    const { target } = camera;
    const [x, y, z] = away(camera);
    const distance = Math.hypot(x, y, z);
    const around = Math.atan2(x, z) + right;
    const high = Math.asin(y / distance) + up;
    const steep = Math.min(Math.max(high, -MOST_STEEP), MOST_STEEP);
    const flat = distance * Math.cos(steep);
    const eye: Vec3 = [
      target[0] + flat * Math.sin(around),
      target[1] + distance * Math.sin(steep),
      target[2] + flat * Math.cos(around),
    ];
    return { ...camera, eye };
  };

/** Shifts it with its target, in heights of the picture at the target: right and upwards. */
export const shifted =
  (right: number, up: number): CameraEdit =>
  (camera) => {
    const [x, y, z] = away(camera);
    const distance = Math.hypot(x, y, z);
    const flat = Math.hypot(x, z);
    const height = 2 * distance * Math.tan((camera.angle * Math.PI) / 360);
    const across: Vec3 = flat > 0 ? [z / flat, 0, -x / flat] : [1, 0, 0];
    const upwards: Vec3 =
      flat > 0
        ? [(-x * y) / (flat * distance), flat / distance, (-z * y) / (flat * distance)]
        : [0, 0, -Math.sign(y)];
    const by = (p: Vec3): Vec3 => [
      p[0] + height * (right * across[0] + up * upwards[0]),
      p[1] + height * (right * across[1] + up * upwards[1]),
      p[2] + height * (right * across[2] + up * upwards[2]),
    ];
    return { ...camera, eye: by(camera.eye), target: by(camera.target) };
  };

/** Multiplies its distance from the target; a factor below 1 comes nearer. */
export const nearer =
  (factor: number): CameraEdit =>
  (camera) => {
    const [x, y, z] = away(camera);
    const { target } = camera;
    const eye: Vec3 = [target[0] + x * factor, target[1] + y * factor, target[2] + z * factor];
    return { ...camera, eye };
  };

/**
 * The camera on a grid of a power of ten below a pixel of a picture of this height, so that its
 * coordinates stay short; unchanged if a coordinate would be lost in doubles.
 */
export function onGrid(camera: Camera, height: number): Camera {
  const distance = Math.hypot(...away(camera));
  const pixel = (2 * distance * Math.tan((camera.angle * Math.PI) / 360)) / height;
  const power = Math.floor(Math.log10(pixel));
  if (!Number.isFinite(power)) return camera;
  const round = (x: number): number =>
    power < 0 && power > -16
      ? Number(x.toFixed(-power))
      : Math.round(x / 10 ** power) * 10 ** power;
  // Without −0, which would come back from a link as 0.
  const place = ([x, y, z]: Vec3): Vec3 => [round(x) + 0, round(y) + 0, round(z) + 0];
  const next = { ...camera, eye: place(camera.eye), target: place(camera.target) };
  return away(next).every((x) => x === 0) ? camera : next;
}

const away = ({ eye, target }: Camera): Vec3 => [
  eye[0] - target[0],
  eye[1] - target[1],
  eye[2] - target[2],
];
