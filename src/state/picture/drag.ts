import type { Vec3 } from '../../math/index.ts';
import { changeLight, changeThing, moved, sum } from '../../scene/edit.ts';
import { viewSize } from '../../scene/place.ts';
import type { Light, Scene } from '../../scene/types.ts';

/*
 * Things and lights are dragged along the floor or along a wall: in the level plane through the
 * dragged point, or in the upright plane parallel to the picture's width. The picture and the view
 * in space use the same code.
 */

export const DRAG_PLANES = ['floor', 'wall'] as const;
export type DragPlane = (typeof DRAG_PLANES)[number];

/** A camera: `right` and `up` are half the picture's width and height at distance 1 ahead. */
export interface CameraFrame {
  readonly eye: Vec3;
  readonly ahead: Vec3;
  readonly right: Vec3;
  readonly up: Vec3;
  /** In pixels of whatever size. */
  readonly width: number;
  readonly height: number;
}

type Pixel = readonly [x: number, y: number];

/** Largest ratio of the distances from the eye after and before a drag. */
const FARTHEST = 8;

/** The direction of the ray through a place of the picture. */
export function rayThrough({ ahead, right, up, width, height }: CameraFrame, [x, y]: Pixel): Vec3 {
  const [u, v] = [(2 * x) / width - 1, 1 - (2 * y) / height];
  const at = (i: 0 | 1 | 2): number => ahead[i] + u * right[i] + v * up[i];
  return [at(0), at(1), at(2)];
}

/** Where a point is in the picture, and how far ahead. */
export function projectedPoint({ eye, ahead, right, up, width, height }: CameraFrame, p: Vec3) {
  const by = minus(p, eye);
  const depth = dot(by, ahead);
  const [u, v] = [dot(by, right) / dot(right, right), dot(by, up) / dot(up, up)];
  // A depth near 0 is replaced, so that the point is projected far outside of the picture.
  const per = Math.max(Math.abs(depth), 1e-9 * Math.hypot(...by), Number.MIN_VALUE);
  return { x: (width / 2) * (1 + u / per), y: (height / 2) * (1 - v / per), depth };
}

/** How a point moves when it is dragged from one place of the picture to another. */
export function dragged(
  frame: CameraFrame,
  at: Vec3,
  from: Pixel,
  to: Pixel,
  along: DragPlane,
): Vec3 {
  const depth = Math.max(dot(minus(at, frame.eye), frame.ahead), 0);
  const spot = projectedPoint(frame, at);
  const isThere = depth > 1e-9 && Math.hypot(spot.x - from[0], spot.y - from[1]) < frame.width / 50;
  const by = isThere ? inPlane(frame, at, from, to, along) : sideways(frame, at, from, to, along);
  const pixel =
    ((isThere ? depth : distance(frame, at)) * 2 * Math.hypot(...frame.up)) / frame.height;
  // Coordinates are rounded to a power of ten below one pixel, so that they stay short.
  const grid = 10 ** Math.floor(Math.log10(pixel));
  const round = (x: number): number => Number((Math.round(x / grid) * grid).toPrecision(12)) + 0;
  return [round(by[0]), round(by[1]), round(by[2])];
}

/** The move in the plane that keeps the point under the pointer, up to the plane's horizon. */
function inPlane(frame: CameraFrame, at: Vec3, from: Pixel, to: Pixel, along: DragPlane): Vec3 {
  const normal: Vec3 = along === 'floor' ? [0, 1, 0] : levelAhead(frame);
  const height = dot(minus(at, frame.eye), normal);
  const meet = (share: number): Vec3 | null => {
    const way = rayThrough(frame, [
      from[0] + share * (to[0] - from[0]),
      from[1] + share * (to[1] - from[1]),
    ]);
    const t = height / dot(way, normal);
    return t > 0 && t <= FARTHEST * start ? plus(frame.eye, way, t) : null;
  };
  const start = height / dot(rayThrough(frame, from), normal);
  const here = meet(0);
  if (!here) return sideways(frame, at, from, to, along);
  const there = meet(1);
  if (there) return minus(there, here);
  // Up to where the plane comes to its horizon.
  let [low, high] = [0, 1];
  for (let i = 0; i < 24; i++) {
    const middle = (low + high) / 2;
    if (meet(middle)) low = middle;
    else high = middle;
  }
  return minus(meet(low) ?? here, here);
}

/** The move for a point that is not in the picture: the pointer's, at the point's distance. */
function sideways(frame: CameraFrame, at: Vec3, from: Pixel, to: Pixel, along: DragPlane): Vec3 {
  const far = distance(frame, at);
  const x = (2 * far * (to[0] - from[0])) / frame.width;
  const y = (-2 * far * Math.hypot(...frame.up) * (to[1] - from[1])) / frame.height;
  const upwards: Vec3 = along === 'floor' ? levelAhead(frame) : [0, 1, 0];
  return plus(plus([0, 0, 0], frame.right, x), upwards, y);
}

const distance = ({ eye }: CameraFrame, at: Vec3): number =>
  Math.max(Math.hypot(...minus(at, eye)), 1e-9);

/** The level direction into the picture; upwards in it, for a view straight down. */
function levelAhead({ ahead, up }: CameraFrame): Vec3 {
  const flat = Math.hypot(ahead[0], ahead[2]);
  const [x, z] = flat > 1e-6 ? [ahead[0], ahead[2]] : [up[0], up[2]];
  const length = Math.hypot(x, z) || 1;
  return [x / length, 0, z / length];
}

/** The move of an arrow key, along the world axis nearest to the key's direction on screen. */
export function arrowMove(
  frame: CameraFrame,
  key: string,
  step: number,
  along: DragPlane,
): Vec3 | null {
  const across = axisOf(frame.right);
  const inwards = levelAhead(frame);
  // The other level axis, so that a view along a diagonal has both.
  const level: Vec3 =
    across[0] === 0 ? [Math.sign(inwards[0]) || 1, 0, 0] : [0, 0, Math.sign(inwards[2]) || 1];
  const upwards: Vec3 = [0, 1, 0];
  const [ahead, aside] = along === 'floor' ? [level, upwards] : [upwards, level];
  const ways: Readonly<Record<string, Vec3>> = {
    ArrowRight: across,
    ArrowLeft: times(across, -1),
    ArrowUp: ahead,
    ArrowDown: times(ahead, -1),
    PageUp: aside,
    PageDown: times(aside, -1),
  };
  const way = ways[key];
  return way ? times(way, step) : null;
}

function axisOf(v: Vec3): Vec3 {
  const isX = Math.abs(v[0]) >= Math.abs(v[2]);
  return isX ? [Math.sign(v[0]) || 1, 0, 0] : [0, 0, Math.sign(v[2])];
}

/** Length of an arrow key's step; with Shift a tenth of it. A sun's direction has its own scale. */
export function arrowStep(scene: Scene, id: string, isFine: boolean): number {
  const light = scene.lights.find((one) => one.id === id);
  const size = light?.light === 'sun' ? Math.hypot(...light.towards) / 5 : viewSize(scene);
  return Number((size / (isFine ? 60 : 6)).toPrecision(1));
}

/** The scene with the thing or light of this id moved by so much from where it was in `taken`. */
export const movedFrom =
  (taken: Scene, id: string, by: Vec3) =>
  (now: Scene): Scene => {
    const thing = taken.things.find((one) => one.id === id);
    const light = taken.lights.find((one) => one.id === id);
    if (thing) return changeThing(now, id, (one) => moved(one, by, thing));
    return light ? changeLight(now, id, (one) => movedLight(one, by, light)) : now;
  };

/** A sun is moved as the lamp would be that stands at the tip of its direction. */
function movedLight(light: Light, by: Vec3, from: Light): Light {
  const place = from.light === 'sun' ? from.towards : from.at;
  const to: Vec3 = [sum(place[0], by[0]), sum(place[1], by[1]), sum(place[2], by[2])];
  if (light.light !== 'sun') return { ...light, at: to };
  return to.every((x) => x === 0) ? light : { ...light, towards: to };
}

const plus = (a: Vec3, b: Vec3, s: number): Vec3 => [
  a[0] + s * b[0],
  a[1] + s * b[1],
  a[2] + s * b[2],
];
const minus = (a: Vec3, b: Vec3): Vec3 => plus(a, b, -1);
const times = (a: Vec3, s: number): Vec3 => [s * a[0] + 0, s * a[1] + 0, s * a[2] + 0];
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
