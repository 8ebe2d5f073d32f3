import type { Ray } from '../ray.ts';
import { integer, pick, type Random, uniform } from '../rng.ts';
import type { Circle } from '../shapes/circle.ts';
import type { Square } from '../shapes/square.ts';
import type { Vec3 } from '../vec3.ts';
import type { FamilyParts, Setting } from './define.ts';
import {
  along,
  cross,
  dot,
  inBox,
  inQuarters,
  minus,
  type NonEmpty,
  nudgedVector,
  quarter,
  stepsOf,
  times,
  unitDirection,
  wholeVector,
} from './random-vectors.ts';

/** A direction to `aim`, of any length: with d = aim − E, t would always be 1, without rounding. */
const towards = (random: Random, origin: Vec3, aim: Vec3): Vec3 =>
  times(uniform(random, 0.3, 3), minus(aim, origin));

/**
 * Value of the dial for points exactly on a rim or an edge: 2^-2000 is 0 as a double. Next to a
 * border the class that a program finds depends on its rounding.
 */
const NOT_NUDGED = -2000;

export const circle: FamilyParts<Setting & Omit<Circle, 'kind'>> = {
  id: 'circle',
  hardness: 'ordinary',
  title: 'circle',
  idea: 'A circle and a ray in no special position, about as often inside as outside.',
  dial: null,
  setting(random) {
    const normal = unitDirection(random);
    const center = inBox(random, 2);
    const radius = uniform(random, 0.3, 2);
    return { shape: { kind: 'circle', normal, center, radius }, normal, center, radius };
  },
  ray(random, { normal, center, radius }) {
    const origin = inBox(random, 5);
    const inPlane = cross(normal, unitDirection(random));
    const aim = along(center, radius * uniform(random, 0, 2), inPlane);
    return { origin, direction: towards(random, origin, aim) };
  },
};

/** N, u and v in whole numbers: orthogonal, u and v of the same `length`. */
interface Frame {
  readonly normal: Vec3;
  readonly u: Vec3;
  readonly v: Vec3;
  readonly length: number;
}

const FRAMES: NonEmpty<Frame> = [
  { normal: [0, 0, 1], u: [1, 0, 0], v: [0, 1, 0], length: 1 },
  { normal: [0, -3, 0], u: [1, 0, 0], v: [0, 0, 1], length: 1 },
  { normal: [1, 2, 2], u: [2, 1, -2], v: [2, -2, 1], length: 3 },
  { normal: [2, -3, 6], u: [6, -2, -3], v: [3, 6, 2], length: 7 },
];

const RIM_POINTS: NonEmpty<Vec3> = [
  [3, 4, 5],
  [5, -12, 13],
  [-8, 15, 17],
  [0, 1, 1],
];

export const circleRim: FamilyParts<Setting & { readonly frame: Frame; readonly rim: Vec3 }> = {
  id: 'circle-rim',
  hardness: 'hard',
  border: NOT_NUDGED,
  title: 'rim of a circle',
  idea:
    'The ray meets the plane on the circle’s rim exactly, or E is moved off that by a few ' +
    'doubles.',
  dial: { title: 'by up to 2^k doubles', range: [0, 20], usual: [0, 6] },
  setting(random) {
    const frame = pick(random, FRAMES);
    const [x, y, n] = pick(random, RIM_POINTS);
    const k = pick(random, [0.03125, 0.25, 1, 64]);
    const center = wholeVector(random, 8);
    const radius = k * n * frame.length;
    const rim = along(along(center, k * x, frame.u), k * y, frame.v);
    return { shape: { kind: 'circle', normal: frame.normal, center, radius }, frame, rim };
  },
  ray: (random, { frame, rim }, k) => throughPoint(random, rim, frame.normal, k),
};

/** A ray exactly through the point, from up to 12 lengths of d away; or the same with E nudged. */
function throughPoint(random: Random, point: Vec3, normal: Vec3, k: number): Ray {
  const direction = crossing(random, normal);
  const origin = along(point, quarter(random, 12), direction);
  return {
    origin: random() < 0.4 ? origin : nudgedVector(random, origin, stepsOf(k)),
    direction,
  };
}

/** A direction in quarters that is not parallel to the plane. */
function crossing(random: Random, normal: Vec3): Vec3 {
  for (;;) {
    const d = inQuarters(random, 2);
    if (dot(d, normal) !== 0) return d;
  }
}

const NORMALS = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] } as const;

export const square: FamilyParts<Setting & Omit<Square, 'kind'>> = {
  id: 'square',
  hardness: 'ordinary',
  title: 'square',
  idea: 'A square and a ray in no special position, about as often inside as outside.',
  dial: null,
  setting(random) {
    const axis = pick(random, ['x', 'y', 'z'] as const);
    const corner = inBox(random, 2);
    const side = uniform(random, 0.3, 2);
    return { shape: { kind: 'square', corner, side, axis }, axis, corner, side };
  },
  ray(random, { axis, corner, side }) {
    const origin = inBox(random, 5);
    const place = (i: 0 | 1 | 2): number =>
      corner[i] + (NORMALS[axis][i] === 1 ? 0 : uniform(random, -0.2, 1.2) * side);
    return { origin, direction: towards(random, origin, [place(0), place(1), place(2)]) };
  },
};

export const squareEdge: FamilyParts<Setting & Omit<Square, 'kind'>> = {
  id: 'square-edge',
  hardness: 'hard',
  border: NOT_NUDGED,
  title: 'edge of a square',
  idea:
    'The ray meets the plane on an edge or a corner exactly, or E is moved off that by a few ' +
    'doubles.',
  dial: { title: 'by up to 2^k doubles', range: [0, 20], usual: [0, 6] },
  setting(random) {
    const axis = pick(random, ['x', 'y', 'z'] as const);
    const corner = inQuarters(random, 2);
    const side = integer(random, 0, 16) / 4;
    return { shape: { kind: 'square', corner, side, axis }, axis, corner, side };
  },
  ray(random, { axis, corner, side }, k) {
    const normal = NORMALS[axis];
    // One of the two coordinates lies on an edge, the other one anywhere on it.
    const edge = integer(random, 0, 1);
    let seen = 0;
    const place = (i: 0 | 1 | 2): number => {
      if (normal[i] === 1) return corner[i];
      const onEdge = seen === edge;
      seen += 1;
      return corner[i] + side * (onEdge ? integer(random, 0, 1) : integer(random, 0, 4) / 4);
    };
    return throughPoint(random, [place(0), place(1), place(2)], normal, k);
  },
};
