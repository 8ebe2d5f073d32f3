import type { Stage } from '../math/drawing.ts';
import type { Intersection, Ray, Shape, Vec3 } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';

/**
 * The stage at the scale of the sliders, used while the shape is within `reach` of its centre and
 * everything together is larger than `tiny`; all in world units.
 */
const SLIDER_STAGE = { center: [0, 1.2, 0] as Vec3, radius: 5, reach: 10, tiny: 0.05 };
/** A point farther away than this many stage radii is left out, and the page says so. */
const FAR = 8;
/** Heights between which an unbounded surface is drawn, in stage radii from the centre. */
const LOW = -0.44;
const HIGH = 0.56;

/** The stage for a shape, E, the points where the ray meets the shape, and `more` points. */
export const stageOf = (
  shape: Shape,
  ray: Ray,
  found: Intersection,
  more: readonly Vec3[] = [],
): Stage => stageAround(shape, [ray.origin, ...pointsToShow(ray, found), ...more]);

/**
 * The stage for a shape and these points. Its size is a continuous function of them, so that a
 * slider does not make the picture jump. Far from the origin, or when everything is tiny, it is
 * centred on the shape.
 */
export function stageAround(shape: Shape, places: readonly Vec3[]): Stage {
  const anchor = definitionOf(shape).anchor(shape);
  const points = places.filter((p) => p.every(Number.isFinite));
  const spread = Math.max(anchor.size, ...points.map((p) => distance(p, anchor.at)));
  const onSliderScale =
    distance(anchor.at, SLIDER_STAGE.center) <= SLIDER_STAGE.reach &&
    anchor.size <= FAR * SLIDER_STAGE.radius &&
    spread >= SLIDER_STAGE.tiny;
  const center = onSliderScale ? SLIDER_STAGE.center : anchor.at;
  const own = onSliderScale ? SLIDER_STAGE.radius : ownScale(anchor, points);
  const seen = points.map((p) => pulledIn(p, center, FAR * own));
  const needed = [
    distance(anchor.at, center) + anchor.size,
    ...seen.map((p) => distance(p, center)),
  ];
  const radius = Math.max(own, 1.08 * Math.max(...needed));
  return withHeights(center, radius, seen);
}

/**
 * The point itself up to a distance `far` from the centre. Farther points are moved back along
 * their line, continuously, and reach the centre at twice that distance.
 */
function pulledIn(p: Vec3, center: Vec3, far: number): Vec3 {
  const away = distance(p, center);
  if (away <= far) return p;
  const share = Math.max(0, 2 * far - away) / away;
  const back = (i: 0 | 1 | 2): number => center[i] + (share > 0 ? (p[i] - center[i]) * share : 0);
  return [back(0), back(1), back(2)];
}

/**
 * The hits; without any, the point at the vertex of f, where two hits appear when D becomes
 * positive. For a figure also the point of its plane.
 */
function pointsToShow({ origin, direction }: Ray, { hits, details }: Intersection): Vec3[] {
  const points = hits.map(({ point }) => point);
  if (details.family === 'flat') return details.plane ? [...points, details.plane.point] : points;
  if (points.length > 0 || details.signs.D !== -1) return points;
  const t = -details.B / (2 * details.A);
  return [[0, 1, 2].map((i) => (origin[i] ?? 0) + t * (direction[i] ?? 0)) as unknown as Vec3];
}

/** Stage radius off the sliders' scale: from the shape's size, else from the nearest point. */
function ownScale(anchor: { at: Vec3; size: number }, points: readonly Vec3[]): number {
  if (anchor.size > 0 && Number.isFinite(anchor.size)) return 1.5 * anchor.size;
  const near = points.map((p) => distance(p, anchor.at)).filter((d) => d > 0 && d < Infinity);
  return near.length > 0 ? 1.2 * Math.min(...near) : SLIDER_STAGE.radius;
}

/** A stage with room for what others about the same centre show. */
export function stageOver(own: Stage, others: readonly Stage[]): Stage {
  const radius = Math.max(own.radius, ...others.map((other) => other.radius));
  return {
    center: own.center,
    radius,
    ground: own.center[1] + LOW * radius,
    low: Math.min(own.low, ...others.map(({ low }) => low)),
    high: Math.max(own.high, ...others.map(({ high }) => high)),
  };
}

function withHeights(center: Vec3, radius: number, points: readonly Vec3[]): Stage {
  const y = center[1];
  const heights = points.map((p) => p[1]);
  const margin = 0.05 * radius;
  return {
    center,
    radius,
    ground: y + LOW * radius,
    low: Math.min(y + LOW * radius, ...heights.map((h) => h - margin)),
    high: Math.max(y + HIGH * radius, ...heights.map((h) => h + margin)),
  };
}

/** Whether a point is within 1.3 stage radii, which is what is drawn. */
export function isDrawn(point: Vec3, { center, radius }: Stage): boolean {
  return distance(point, center) <= 1.3 * radius;
}

export function distance(a: Vec3, b: Vec3): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

export function sameStage(a: Stage, b: Stage): boolean {
  return (
    a.radius === b.radius &&
    a.ground === b.ground &&
    a.low === b.low &&
    a.high === b.high &&
    a.center.every((x, i) => x === b.center[i])
  );
}
