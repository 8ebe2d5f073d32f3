import type { Vec3 } from '../math/index.ts';
import type { FreeView, NamedView, View } from '../state/camera-view.ts';
import { along, dot, type Point, type StageUnits, unit } from './stage-units.ts';

/** The camera in stage units: it looks at `target` from `distance`. */
export interface Pose {
  readonly target: Vec3;
  /** Degrees, as in FreeView. */
  readonly azimuth: number;
  readonly elevation: number;
  readonly zoom: number;
}

interface Ray {
  readonly origin: Vec3;
  readonly direction: Vec3;
}

const FIXED_VIEWS: Record<Exclude<NamedView, 'ray'>, FreeView> = {
  iso: { azimuth: 16, elevation: 14, zoom: 1 },
  // From above, the stage's depth has to fit into the frame's short side.
  top: { azimuth: 0, elevation: 90, zoom: 0.78 },
  front: { azimuth: 0, elevation: 0, zoom: 0.95 },
  side: { azimuth: 90, elevation: 0, zoom: 0.95 },
};

const RAY_ZOOM = 0.9;

export function poseOf(view: View, ray: Ray, units: StageUnits): Pose {
  if (typeof view !== 'string') return { target: [0, 0, 0], ...view, zoom: view.zoom ?? 1 };
  if (view === 'ray') return alongRay(ray, units) ?? { target: [0, 0, 0], ...FIXED_VIEWS.iso };
  return { target: [0, 0, 0], ...FIXED_VIEWS[view] };
}

/**
 * The view along the ray. The camera is on the ray's line, at the framing distance before the
 * line's point nearest to the centre, not at E, which may be too near or too far.
 */
function alongRay(ray: Ray, units: StageUnits): Pose | null {
  const d = unit(ray.direction);
  if (!d) return null;
  const E = units.toStage(ray.origin);
  const nearest: Point = E ? along(E, d, -dot(E, d)) : [0, 0, 0];
  // If the ray passes far from the stage, the camera looks at the centre.
  const target: Point = Math.hypot(...nearest) < 1.5 ? nearest : [0, 0, 0];
  return {
    target,
    azimuth: degrees(Math.atan2(-d[0], -d[2])),
    elevation: degrees(Math.asin(Math.min(Math.max(-d[1], -1), 1))),
    zoom: RAY_ZOOM,
  };
}

/** The same camera as angles about the stage's centre, for an orbit that starts at a named view. */
export function freeOf(pose: Pose): FreeView {
  return { azimuth: pose.azimuth, elevation: pose.elevation, zoom: pose.zoom };
}

/** Interpolates two poses, with angles the short way round. */
export function mix(a: Pose, b: Pose, s: number): Pose {
  const turn = wrapped(b.azimuth - a.azimuth);
  return {
    target: along(along([0, 0, 0], a.target, 1 - s), b.target, s),
    azimuth: a.azimuth + turn * s,
    elevation: a.elevation + (b.elevation - a.elevation) * s,
    zoom: a.zoom * (b.zoom / a.zoom) ** s,
  };
}

/** An angle in degrees brought to [−180, 180). */
export function wrapped(angle: number): number {
  return ((((angle + 180) % 360) + 360) % 360) - 180;
}

export function radians(angle: number): number {
  return (angle * Math.PI) / 180;
}

function degrees(angle: number): number {
  return (angle * 180) / Math.PI;
}
