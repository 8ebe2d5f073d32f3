import type { Vec3 } from '../math/index.ts';
import type { Handle, ReachHandle } from '../state/handles.ts';
import type { Projection, ScreenPoint } from './projection.ts';
import { along, dot, type Point, type StageUnits, unit } from './stage-units.ts';

/** A handle with its place in the picture. */
export interface HandlePlace<H extends Handle = Handle> {
  readonly handle: H;
  /** Place in stage units; null outside of the picture. */
  readonly place: Point | null;
  readonly spot: ScreenPoint | null;
  /** Unit vector in which a reach grows; null for a point. */
  readonly course: Point | null;
}

export function placeHandle(
  handle: Handle,
  units: StageUnits,
  projection: Projection,
): HandlePlace {
  const course = handle.type === 'reach' ? courseOf(handle, projection) : null;
  const at = handle.type === 'point' ? handle.at : reachedBy(handle, course);
  const place = at && units.toStage(at);
  return { handle, place, spot: place && projection.project(place), course };
}

function reachedBy({ grip }: ReachHandle, course: Point | null): Vec3 | null {
  return course && along(grip.from, course, grip.reach);
}

/** Direction of a circle's radius that is parallel to the screen, to the right if possible. */
function courseOf({ grip: { direction } }: ReachHandle, projection: Projection): Point | null {
  if ('along' in direction) return unit(direction.along);
  const axis = unit(direction.about);
  if (!axis) return null;
  const [a, f] = [axis, projection.forward];
  const across = unit([
    a[1] * f[2] - a[2] * f[1],
    a[2] * f[0] - a[0] * f[2],
    a[0] * f[1] - a[1] * f[0],
  ]);
  // Seen along the axis every radius is parallel to the screen: the one to the right is taken.
  const flat = across ?? unit(along(projection.right, axis, -dot(projection.right, axis)));
  if (!flat) return null;
  const [x, y] = [dot(flat, projection.right), dot(flat, projection.up)];
  const isBackwards = Math.abs(x) > 1e-9 ? x < 0 : y < 0;
  return isBackwards ? along([0, 0, 0], flat, -1) : flat;
}
