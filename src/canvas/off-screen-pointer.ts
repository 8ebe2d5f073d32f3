import type { Vec3 } from '../math/index.ts';
import type { RaySegment, SceneModel } from '../state/scene-model.ts';
import { BUTTONS, NARROW } from './framing.ts';
import { spanInside } from './labels.ts';
import type { Projection } from './projection.ts';
import { pointAt } from './ray.ts';
import { along, type Point, type StageUnits, unit } from './stage-units.ts';

/** A pointer "E →" to a point outside of the picture. */
export interface OffScreenPointer {
  readonly x: number;
  readonly y: number;
  /** Unit vector on the screen. */
  readonly direction: readonly [number, number];
}

/** Distance in px at scale 1 from the frame's edges, for buttons and rounded corners. */
const INSET = { x: 34, top: 60, bottom: 30 };
/** Distance in px from the end of the drawn ray to the pointer's letter. */
const BEYOND = 22;
/** Distance in px above the ray, where it leaves the frame. */
const ABOVE = 16;

/** A pointer to R(t): at the end of the drawn ray, or without one at the frame's edge. */
export function pointerTo(
  point: Vec3,
  t: number,
  model: SceneModel,
  units: StageUnits,
  projection: Projection,
  scale: number,
): OffScreenPointer {
  const { segments } = model.ray;
  const end = nearestEnd(segments, t);
  const width = widthOf(projection);
  const seen = visibleRay(model, units, projection, width);
  if (end && seen) {
    const { x, y } = end.sign < 0 ? seen.start : seen.end;
    const [dx, dy] = seen.course;
    const direction = [end.sign * dx, end.sign * dy] as const;
    const isEnd = x > 1 && x < width - 1 && y > 1 && y < projection.height - 1;
    if (!isEnd) return clamp(x, y - ABOVE * scale, direction, projection, scale);
    const reach = BEYOND * scale;
    return clamp(x + reach * direction[0], y + reach * direction[1], direction, projection, scale);
  }
  return fromCentre(point, units, projection, scale);
}

interface VisibleRay {
  readonly start: { readonly x: number; readonly y: number };
  readonly end: { readonly x: number; readonly y: number };
  readonly course: readonly [number, number];
}

/** The frame's width in px without the column of views. */
const widthOf = ({ width }: Projection): number => width - (width < NARROW ? BUTTONS.column : 0);

/** Both ends of the drawn ray within the frame; null if it is outside or seen head-on. */
export function visibleRay(
  model: SceneModel,
  units: StageUnits,
  projection: Projection,
  width = projection.width,
): VisibleRay | null {
  const { segments } = model.ray;
  const [first, last] = [segments[0], segments.at(-1)];
  const from = first && pointAt(model.ray, first.from, units);
  const to = last && pointAt(model.ray, last.to, units);
  const a = from && projection.project(from);
  const b = to && projection.project(to);
  if (!a || !b) return null;
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const length = Math.hypot(dx, dy);
  const frame = {
    x: width / 2,
    y: projection.height / 2,
    w: width,
    h: projection.height,
  };
  const inside = spanInside([a.x, a.y, b.x, b.y], frame);
  if (!inside || length < 1) return null;
  return {
    start: { x: a.x + inside[0] * dx, y: a.y + inside[0] * dy },
    end: { x: a.x + inside[1] * dx, y: a.y + inside[1] * dy },
    course: [dx / length, dy / length],
  };
}

/** The drawn end beyond which t lies; null when t is on the drawn part or nothing is drawn. */
function nearestEnd(
  segments: readonly RaySegment[],
  t: number,
): { t: number; sign: 1 | -1 } | null {
  const from = segments[0]?.from;
  const to = segments.at(-1)?.to;
  if (from !== undefined && t <= from) return { t: from, sign: -1 };
  if (to !== undefined && t >= to) return { t: to, sign: 1 };
  return null;
}

function fromCentre(
  point: Vec3,
  units: StageUnits,
  projection: Projection,
  scale: number,
): OffScreenPointer {
  const place = units.toStage(point);
  const spot = place && projection.project(place);
  const [cx, cy] = [projection.width / 2, projection.height / 2];
  const [x, y] = spot
    ? [spot.x - cx, spot.y - cy]
    : projection.onScreen(units.towards(point) ?? [0, 1, 0]);
  const length = Math.hypot(x, y);
  const direction = length > 0 ? ([x / length, y / length] as const) : ([0, -1] as const);
  const far = projection.width + projection.height;
  const reach = spot && isInside(spot, projection) ? length : far;
  return clamp(cx + reach * direction[0], cy + reach * direction[1], direction, projection, scale);
}

/** The point, moved towards the frame's centre until it is in the frame. */
function clamp(
  x: number,
  y: number,
  direction: OffScreenPointer['direction'],
  projection: Projection,
  scale: number,
): OffScreenPointer {
  const width = widthOf(projection);
  const [cx, cy] = [width / 2, (projection.height + (INSET.top - INSET.bottom) * scale) / 2];
  const halfWidth = Math.max(width / 2 - INSET.x * scale, 1);
  const halfHeight = Math.max((projection.height - (INSET.top + INSET.bottom) * scale) / 2, 1);
  const excess = Math.max(Math.abs(x - cx) / halfWidth, Math.abs(y - cy) / halfHeight, 1);
  return { x: cx + (x - cx) / excess, y: cy + (y - cy) / excess, direction };
}

export function isInside(
  { x, y }: { x: number; y: number },
  { width, height }: Projection,
): boolean {
  return x >= 0 && x <= width && y >= 0 && y <= height;
}

/** Step in stage units for numeric derivatives. */
const STEP = 0.01;
/** Length in px of a step below which a direction counts as pointing at the eye. */
const HEAD_ON = 0.02;

/** Unit direction of d on the screen at a point; null if d points towards or away from the eye. */
export function heading(at: Point, d: Vec3, projection: Projection): [number, number] | null {
  const step = unit(d);
  const from = step && projection.project(along(at, step, -STEP));
  const to = step && projection.project(along(at, step, STEP));
  if (!from || !to) return null;
  const [x, y] = [to.x - from.x, to.y - from.y];
  const length = Math.hypot(x, y);
  return length > HEAD_ON ? [x / length, y / length] : null;
}
