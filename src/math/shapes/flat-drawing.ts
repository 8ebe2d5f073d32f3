import type { Axis, Vec3 } from '../vec3.ts';
import type { Figure, Patch, Stage } from './drawing.ts';
import { multiplesWithin, roundStep } from './steps.ts';

/** Two unit vectors that span the plane with this normal; doubles, for the picture only. */
export function spanning(normal: Vec3): { e1: Vec3; e2: Vec3; unit: Vec3 } {
  // Scaled first: the square of a very long or very short normal is not a double.
  const largest = Math.max(...normal.map(Math.abs));
  const scaled = normal.map((x) => x / largest);
  const length = Math.hypot(...scaled);
  const [x = 0, y = 0, z = 0] = scaled.map((c) => c / length);
  // e1 lies flat on the ground where it can, so that a plane's edges look level.
  const flat = Math.hypot(x, z);
  const e1: Vec3 = flat > 1e-6 ? [z / flat, 0, -x / flat] : [1, 0, 0];
  const e2: Vec3 = [y * e1[2] - z * e1[1], z * e1[0] - x * e1[2], x * e1[1] - y * e1[0]];
  return { e1, e2, unit: [x, y, z] };
}

const along = (p: Vec3, s: number, e1: Vec3, t: number, e2: Vec3): Vec3 => [
  p[0] + s * e1[0] + t * e2[0],
  p[1] + s * e1[1] + t * e2[1],
  p[2] + s * e1[2] + t * e2[2],
];

/**
 * A square part of the whole plane, about the point of it that is nearest to the stage's middle.
 */
export function drawPlane(normal: Vec3, point: Vec3, stage: Stage): Figure {
  const { e1, e2, unit } = spanning(normal);
  const gap =
    (point[0] - stage.center[0]) * unit[0] +
    (point[1] - stage.center[1]) * unit[1] +
    (point[2] - stage.center[2]) * unit[2];
  const middle: Vec3 = along(stage.center, gap, unit, 0, unit);
  const half = stage.radius * 0.6;
  const step = roundStep(stage.radius / 5);
  const lines = multiplesWithin(-half, half, step).map((x) => (x / half + 1) / 2);
  const patch: Patch = {
    at: (u, v) => along(middle, (2 * u - 1) * half, e1, (2 * v - 1) * half, e2),
    normal: () => unit,
    closed: false,
    rings: lines,
    start: 'goes-on',
    end: 'goes-on',
    sides: 'goes-on',
    stepsV: 1,
  };
  return flat(patch, 'P', point, unit);
}

export function drawDisc(normal: Vec3, center: Vec3, radius: number): Figure {
  const { e1, e2, unit } = spanning(normal);
  const patch: Patch = {
    at(u, v) {
      const angle = 2 * Math.PI * u;
      return along(center, radius * v * Math.cos(angle), e1, radius * v * Math.sin(angle), e2);
    },
    normal: () => unit,
    closed: true,
    rings: [],
    start: 'point',
    end: 'edge',
    sides: 'joins',
    stepsV: 1,
  };
  return flat(patch, 'C', center, unit);
}

const UNIT: Readonly<Record<Axis, Vec3>> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

export function unitAlong(axis: Axis): Vec3 {
  return UNIT[axis];
}

/**
 * The two axes of a plane whose normal is `axis`, in the order that makes a right-handed frame with
 * it.
 */
export function inPlaneAxes(axis: Axis): readonly [Axis, Axis] {
  return axis === 'x' ? ['y', 'z'] : axis === 'y' ? ['z', 'x'] : ['x', 'y'];
}

export function drawSquare(axis: Axis, corner: Vec3, side: number): Figure {
  const [first, second] = inPlaneAxes(axis);
  const patch: Patch = {
    at: (u, v) => along(corner, u * side, UNIT[first], v * side, UNIT[second]),
    normal: () => UNIT[axis],
    closed: false,
    rings: [],
    start: 'edge',
    end: 'edge',
    sides: 'edge',
    stepsV: 1,
  };
  return flat(patch, 'P', corner, UNIT[axis]);
}

function flat(patch: Patch, symbol: string, mark: Vec3, direction: Vec3): Figure {
  return {
    patches: [patch],
    lines: [],
    marks: [{ symbol, at: mark }],
    normals: [{ at: mark, direction }],
  };
}
