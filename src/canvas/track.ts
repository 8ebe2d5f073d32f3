import type { Vec3 } from '../math/vec3.ts';
import type { PointHandle, ReachHandle } from '../state/handles.ts';
import type { Value, Way } from '../state/snap.ts';
import type { Lens } from './lens.ts';
import type { Placed } from './placed.ts';
import { type Slide, slide } from './slide.ts';
import { along, type Space } from './space.ts';

/** Turns pixels that the pointer has moved since it took the handle into values. */
export interface Track {
  /** What the value is before the pointer moves: components that are the same have not been dragged. */
  readonly start: Value;
  readonly perPixel: number;
  to(dx: number, dy: number): Value;
  /** Lines of values through what `to` gives, for looking around there. */
  ways(dx: number, dy: number): readonly Way[];
}

/** For a handle that is taken; with an axis it moves along that one only. Null outside of the picture. */
export function trackOf(
  found: Placed,
  axis: 0 | 1 | 2 | null,
  space: Space,
  lens: Lens,
): Track | null {
  const { handle, ...rest } = found;
  if (!rest.place) return null;
  if (handle.type === 'reach') return reachTrack({ handle, ...rest }, space, lens);
  if (axis !== null) return axisTrack({ handle, ...rest }, axis, space, lens);
  return planeTrack({ handle, ...rest }, space, lens);
}

const WAYS = 16;

/** In the plane through the handle that faces the viewer. */
function planeTrack({ handle, place }: Placed<PointHandle>, space: Space, lens: Lens): Track {
  const depth = place ? lens.distance(place) : 1;
  const perPixel = (space.stage.radius * Math.max(depth, lens.near)) / lens.focal;
  const to = (dx: number, dy: number): Vec3 => {
    const flat = along([0, 0, 0], lens.right, dx * perPixel);
    return clean(along(flat, lens.up, -dy * perPixel), handle.here, perPixel);
  };
  return {
    start: handle.here,
    perPixel,
    to,
    ways: (dx, dy) =>
      Array.from({ length: WAYS }, (_, k) => {
        const angle = (2 * Math.PI * k) / WAYS;
        const [c, s] = [Math.cos(angle), Math.sin(angle)];
        return (pixels: number) => to(dx + pixels * c, dy + pixels * s);
      }),
  };
}

/** Adds a move to a point. What is a rounding error of the camera's directions is no move. */
function clean(move: Vec3, to: Vec3, perPixel: number): Vec3 {
  const add = (i: 0 | 1 | 2): number =>
    Math.abs(move[i]) < 1e-9 * perPixel ? to[i] : to[i] + move[i];
  return [add(0), add(1), add(2)];
}

/** Along one axis of the world. */
function axisTrack(
  { handle, place }: Placed<PointHandle>,
  axis: 0 | 1 | 2,
  space: Space,
  lens: Lens,
): Track {
  const direction: Vec3 = [axis === 0 ? 1 : 0, axis === 1 ? 1 : 0, axis === 2 ? 1 : 0];
  const line = slide(place ?? [0, 0, 0], direction, lens);
  const { radius } = space.stage;
  return lineTrack(line, handle.value, radius / line.scale, (move) => {
    const put = (i: 0 | 1 | 2): number =>
      i === axis ? handle.value[i] + move * radius : handle.value[i];
    return [put(0), put(1), put(2)];
  });
}

function reachTrack(
  { handle, place, course }: Placed<ReachHandle>,
  space: Space,
  lens: Lens,
): Track {
  const { grip, value } = handle;
  const line = slide(place ?? [0, 0, 0], course ?? lens.right, lens);
  const { radius } = space.stage;
  const read = (move: number): number =>
    move === 0 ? value : grip.value(Math.max(grip.reach + move * radius, 0));
  const perPixel = Math.abs(read(2 / line.scale) - read(1 / line.scale));
  return lineTrack(line, value, perPixel || radius / line.scale, read);
}

function lineTrack(
  line: Slide,
  start: Value,
  perPixel: number,
  read: (move: number) => Value,
): Track {
  const { course } = line;
  const pixels = (dx: number, dy: number): number => dx * course[0] + dy * course[1];
  return {
    start,
    perPixel,
    to: (dx, dy) => read(line.reach(pixels(dx, dy))),
    ways: (dx, dy) =>
      [1, -1].map((sign) => (more: number) => read(line.reach(pixels(dx, dy) + sign * more))),
  };
}
