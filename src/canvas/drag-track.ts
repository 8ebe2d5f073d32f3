import type { Vec3 } from '../math/index.ts';
import type { PointHandle, ReachHandle } from '../state/handles.ts';
import type { DragLine, Value } from '../state/snap.ts';
import type { HandlePlace } from './handle-place.ts';
import { type LineOnScreen, lineOnScreen } from './line-on-screen.ts';
import type { Projection } from './projection.ts';
import { along, type StageUnits } from './stage-units.ts';

/** Turns the pointer's movement in px since the drag began into values. */
export interface DragTrack {
  /** The value before the drag; components that still have it were not dragged. */
  readonly start: Value;
  readonly perPixel: number;
  to(dx: number, dy: number): Value;
  /** Lines of values through the value at (dx, dy), on which snap targets are searched. */
  lines(dx: number, dy: number): readonly DragLine[];
}

/** The track of a handle; with an axis along that axis only. Null outside of the picture. */
export function trackOf(
  found: HandlePlace,
  axis: 0 | 1 | 2 | null,
  units: StageUnits,
  projection: Projection,
): DragTrack | null {
  const { handle, ...rest } = found;
  if (!rest.place) return null;
  if (handle.type === 'reach') return reachTrack({ handle, ...rest }, units, projection);
  if (axis !== null) return axisTrack({ handle, ...rest }, axis, units, projection);
  return planeTrack({ handle, ...rest }, units, projection);
}

const WAYS = 16;

/** Moves in the plane through the handle that is parallel to the screen. */
function planeTrack(
  { handle, place }: HandlePlace<PointHandle>,
  units: StageUnits,
  projection: Projection,
): DragTrack {
  const depth = place ? projection.distance(place) : 1;
  const perPixel = (units.stage.radius * Math.max(depth, projection.near)) / projection.focal;
  const to = (dx: number, dy: number): Vec3 => {
    const flat = along([0, 0, 0], projection.right, dx * perPixel);
    return clean(along(flat, projection.up, -dy * perPixel), handle.here, perPixel);
  };
  return {
    start: handle.here,
    perPixel,
    to,
    lines: (dx, dy) =>
      Array.from({ length: WAYS }, (_, k) => {
        const angle = (2 * Math.PI * k) / WAYS;
        const [c, s] = [Math.cos(angle), Math.sin(angle)];
        return (pixels: number) => to(dx + pixels * c, dy + pixels * s);
      }),
  };
}

/** Adds a move to a point; components that are rounding errors of the camera's axes are dropped. */
function clean(move: Vec3, to: Vec3, perPixel: number): Vec3 {
  const add = (i: 0 | 1 | 2): number =>
    Math.abs(move[i]) < 1e-9 * perPixel ? to[i] : to[i] + move[i];
  return [add(0), add(1), add(2)];
}

/** Moves along one axis of the world. */
function axisTrack(
  { handle, place }: HandlePlace<PointHandle>,
  axis: 0 | 1 | 2,
  units: StageUnits,
  projection: Projection,
): DragTrack {
  const direction: Vec3 = [axis === 0 ? 1 : 0, axis === 1 ? 1 : 0, axis === 2 ? 1 : 0];
  const line = lineOnScreen(place ?? [0, 0, 0], direction, projection);
  const { radius } = units.stage;
  return lineTrack(line, handle.value, radius / line.scale, (move) => {
    const put = (i: 0 | 1 | 2): number =>
      i === axis ? handle.value[i] + move * radius : handle.value[i];
    return [put(0), put(1), put(2)];
  });
}

function reachTrack(
  { handle, place, course }: HandlePlace<ReachHandle>,
  units: StageUnits,
  projection: Projection,
): DragTrack {
  const { grip, value } = handle;
  const line = lineOnScreen(place ?? [0, 0, 0], course ?? projection.right, projection);
  const { radius } = units.stage;
  const read = (move: number): number =>
    move === 0 ? value : grip.value(Math.max(grip.reach + move * radius, 0));
  const perPixel = Math.abs(read(2 / line.scale) - read(1 / line.scale));
  return lineTrack(line, value, perPixel || radius / line.scale, read);
}

function lineTrack(
  line: LineOnScreen,
  start: Value,
  perPixel: number,
  read: (move: number) => Value,
): DragTrack {
  const { course } = line;
  const pixels = (dx: number, dy: number): number => dx * course[0] + dy * course[1];
  return {
    start,
    perPixel,
    to: (dx, dy) => read(line.reach(pixels(dx, dy))),
    lines: (dx, dy) =>
      [1, -1].map((sign) => (more: number) => read(line.reach(pixels(dx, dy) + sign * more))),
  };
}
