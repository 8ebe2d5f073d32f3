import type { Vec3 } from '../math/index.ts';
import { AXES } from '../math/shapes.ts';
import type { Handle } from '../state/handles.ts';
import {
  chooseTarget,
  ENTER,
  finestStep,
  gridUnit,
  onGrid,
  type SnapTarget,
  tangentTarget,
  type Value,
} from '../state/snap.ts';
import type { DragTrack } from './drag-track.ts';
import { lineOnScreen } from './line-on-screen.ts';
import type { Projection } from './projection.ts';
import { along, type StageUnits } from './stage-units.ts';

export interface Modifiers {
  /** Alt: nothing snaps. */
  readonly free: boolean;
  /** Shift: no grid. */
  readonly fine: boolean;
}

export interface Snapped {
  readonly value: Value;
  readonly reason: string | null;
  /** Key of the target that it snapped to, for the next move; null if none. */
  readonly held: string | null;
}

/** Largest distance in px between two snap positions of a number's handle. */
const MAX_STEP_PX = 12;

/** The value of a drag at (dx, dy) px: a target that it snaps to, or a multiple of the grid. */
export function snapDrag(
  handle: Handle,
  track: DragTrack,
  [dx, dy]: readonly [number, number],
  { free, fine }: Modifiers,
  axes: readonly SnapTarget[],
  held: string | null,
  stageRadius: number,
): Snapped {
  const raw = track.to(dx, dy);
  const least = finestStep(track.perPixel);
  const step = handle.isLength
    ? handle.step * gridUnit(stageRadius, track.perPixel)
    : Math.min(handle.step, least * 10 * MAX_STEP_PX);
  const grid = (to: number) => (value: Value) => onGrid(value, track.start, to);
  const plain = grid(free || fine ? least : step)(raw);
  if (free) return { value: plain, reason: null, held: null };
  const tangent =
    handle.tangency &&
    tangentTarget(track.lines(dx, dy), handle.tangency, [grid(step), grid(step / 10), grid(least)]);
  const offer = chooseTarget(tangent ? [...axes, tangent] : axes, held);
  return offer
    ? { value: offer.value, reason: offer.reason, held: offer.key }
    : { value: plain, reason: null, held: null };
}

/** Largest angle in degrees, out of the screen too, between d and an axis it snaps to. */
const MAX_ANGLE_DEG = 30;

/** Targets on the axes through E near the dragged tip of d, with the length seen there. */
export function axisTargets(
  handle: Handle,
  value: Value,
  tip: { readonly x: number; readonly y: number },
  units: StageUnits,
  projection: Projection,
): SnapTarget[] {
  const origin = handle.type === 'point' ? handle.origin : null;
  const place = origin && units.toStage(origin);
  const from = place && projection.project(place);
  if (!from) return [];
  const to = value as Vec3;
  return AXES.flatMap((axis, i) => {
    const sign = (to[i] ?? 0) < 0 ? -1 : 1;
    const cosine = Math.abs(to[i] ?? 0) / Math.hypot(...to);
    if (!(cosine > Math.cos((MAX_ANGLE_DEG * Math.PI) / 180))) return [];
    const unit = AXES.map((_, k) => (k === i ? sign : 0)) as unknown as Vec3;
    const { course, scale, reach } = lineOnScreen(place, unit, projection);
    const [x, y] = [tip.x - from.x, tip.y - from.y];
    const pixels = x * course[0] + y * course[1];
    if (pixels < ENTER) return [];
    const { radius } = units.stage;
    const step = handle.step * gridUnit(radius, radius / scale);
    const exact = along([0, 0, 0], unit, reach(pixels) * radius);
    return [
      {
        key: `axis ${axis}`,
        value: onGrid(exact, [0, 0, 0], step),
        reason: `snapped: parallel to ${axis}`,
        gap: Math.abs(x * course[1] - y * course[0]),
      },
    ];
  });
}
