import type { Axis, Vec3 } from '../vec3.ts';
import type { Grip, Stage } from './drawing.ts';
import { inPlaneAxes, unitAlong } from './flat-drawing.ts';

const AXIS: Vec3 = [0, 1, 0];
/**
 * How high above a vertex or centre, in stage radii, a slope is taken: well inside the picture, and
 * not on top of the point.
 */
const LEVER = 0.3;
/**
 * The same in radii of a surface that has one: on a sphere, and on ellipsoids nearly twice as flat,
 * there is a circle.
 */
const LEVER_OF_RADIUS = 0.75;
/** A radius below this many stage radii is too short to be a lever. */
const SHORT = 0.03;

/** In units of the stage; at the least double a part of its radius would be 0. */
const leverOf = ({ radius }: Stage): number => Math.max(LEVER * radius, Number.MIN_VALUE);

export function pointGrip(param: string, at: Vec3): Grip {
  return { type: 'point', param, at };
}

/** The radius of a circle, on any of its points. */
export function radiusGrip(param: string, center: Vec3, radius: number, axis: Vec3 = AXIS): Grip {
  const direction = { about: axis };
  const value = (reach: number): number => reach;
  return { type: 'reach', param, from: center, direction, reach: radius, isLength: true, value };
}

/**
 * A cone's slope, on the circle at a height below its vertex, or above where below is out of the
 * picture: c = radius / height.
 */
export function slopeGrip(param: string, vertex: Vec3, slope: number, stage: Stage): Grip {
  const h = leverOf(stage);
  const side = vertex[1] - h < stage.low ? 1 : -1;
  const sign = slope < 0 ? -1 : 1;
  const from: Vec3 = [vertex[0], vertex[1] + side * h, vertex[2]];
  const value = (reach: number): number => (sign * reach) / h;
  const reach = Math.abs(slope) * h;
  const direction = { about: AXIS };
  return { type: 'reach', param, from, direction, reach, isLength: false, value };
}

/** A hyperboloid's a, on the circle at a height above its centre: a = (reach² − r²) / height². */
export function flareGrip(
  param: string,
  { center, a, r }: { readonly center: Vec3; readonly a: number; readonly r: number },
  stage: Stage,
): Grip {
  const h = r > SHORT * stage.radius ? LEVER_OF_RADIUS * r : leverOf(stage);
  // As products of quotients: the square of a very long or very short length is not a double.
  const value = (reach: number): number => ((reach - r) / h) * ((reach + r) / h);
  const reach = h * Math.sqrt(Math.max(a + (r / h) ** 2, 0));
  const from: Vec3 = [center[0], center[1] + h, center[2]];
  const direction = { about: AXIS };
  return { type: 'reach', param, from, direction, reach, isLength: false, value };
}

/**
 * A paraboloid's k, on the circle at a height from its vertex on the side where it is: k = reach² /
 * height.
 */
export function widthGrip(param: string, vertex: Vec3, width: number, stage: Stage): Grip {
  const h = width < 0 ? -leverOf(stage) : leverOf(stage);
  const from: Vec3 = [vertex[0], vertex[1] + h, vertex[2]];
  const value = (reach: number): number => reach * (reach / h);
  const reach = Math.sqrt(width / h) * Math.abs(h);
  const direction = { about: AXIS };
  return { type: 'reach', param, from, direction, reach, isLength: false, value };
}

/** A square's side, at the corner opposite to its own. */
export function sideGrip(param: string, corner: Vec3, side: number, normal: Axis): Grip {
  const [first, second] = inPlaneAxes(normal).map(unitAlong) as [Vec3, Vec3];
  const along: Vec3 = [first[0] + second[0], first[1] + second[1], first[2] + second[2]];
  const value = (reach: number): number => reach * Math.SQRT1_2;
  const [direction, reach] = [{ along }, side * Math.SQRT2];
  return { type: 'reach', param, from: corner, direction, reach, isLength: true, value };
}
