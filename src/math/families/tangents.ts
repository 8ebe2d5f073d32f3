import { scale } from '../float/bits.ts';
import type { Ray } from '../ray.ts';
import { integer, pick, type Random, randomSign, uniform } from '../rng.ts';
import type { Vec3 } from '../vec3.ts';
import {
  type Axial,
  coneOf,
  cylinderOf,
  hyperboloidOf,
  ordinaryAxial,
  sizeOf,
  surfacePoint,
} from './axial.ts';
import { type FamilyParts, powerOfTen, type Setting } from './define.ts';
import {
  along,
  type Draw,
  type NonEmpty,
  perpendicular,
  pythagorean,
  quarter,
  unit,
  wholeVector,
} from './random-vectors.ts';

/**
 * A tangent line of the surface moved 10^-k radii along the normal, with E `distance` radii before
 * the touching point.
 */
function besideTangent(random: Random, axial: Axial, k: number, distance: number): Ray {
  const { point, normal } = surfacePoint(random, axial);
  const n = unit(normal);
  const direction = perpendicular(random, n);
  const size = sizeOf(axial);
  const touching = along(point, randomSign(random) * powerOfTen(-k) * size, n);
  return { origin: along(touching, -distance * size, direction), direction };
}

export const nearTangentRay = (random: Random, axial: Axial, k: number): Ray =>
  besideTangent(random, axial, k, uniform(random, 1, 5));

export const nearTangentFarRay = (random: Random, axial: Axial, k: number): Ray =>
  besideTangent(random, axial, uniform(random, 6, 10), powerOfTen(k));

export const nearTangent: FamilyParts<Axial> = {
  id: 'near-tangent',
  hardness: 'hard',
  title: 'near tangent',
  idea: 'The ray passes the surface within a hair of touching it: D is tiny against B².',
  dial: { title: 'the gap is 10^-k radii', range: [1, 17], usual: [8, 16] },
  setting: ordinaryAxial,
  ray: nearTangentRay,
};

export const nearTangentFar: FamilyParts<Axial> = {
  id: 'near-tangent-far',
  title: 'near tangent from afar',
  idea: 'A gap of 1e-6 to 1e-10 radii, seen from many radii away: both cancellations at once.',
  dial: { title: 'E is 10^k radii away', range: [0, 9], usual: [2, 6] },
  setting: ordinaryAxial,
  ray: nearTangentFarRay,
};

/** A shape and a point of it in whole numbers, and two directions that span its tangent plane. */
interface TangentPlane {
  readonly axial: Axial;
  readonly point: Vec3;
  readonly across: Vec3;
  readonly upwards: Vec3;
}

/**
 * At the waist, r = n·2^j: the point is (x, 0, z)·2^j from the centre, and the tangent plane is
 * upright.
 */
function atWaist(random: Random, make: (center: Vec3, r: number) => Axial): TangentPlane {
  const { x, y: z, n } = pythagorean(random);
  const j = integer(random, -2, 9);
  const center = wholeVector(random, 50);
  return {
    axial: make(center, scale(n, j)),
    point: [center[0] + scale(x, j), center[1], center[2] + scale(z, j)],
    across: [-z, 0, x],
    upwards: [0, 1, 0],
  };
}

/**
 * At height n·h of a cone of slope c: (c x h, n h, c z h) from the vertex, which is a generator
 * too.
 */
function onCone(random: Random): TangentPlane {
  const { x, y: z, n } = pythagorean(random);
  const vertex = wholeVector(random, 50);
  const c = quarter(random, 3) || 1;
  const h = integer(random, 1, 8) * randomSign(random);
  const generator: Vec3 = [c * x, n, c * z];
  return {
    axial: coneOf(vertex, c),
    point: along(vertex, h, generator),
    across: [-z, 0, x],
    upwards: generator,
  };
}

const TANGENT_PLANES: NonEmpty<Draw<TangentPlane>> = [
  (random) => atWaist(random, cylinderOf),
  (random) => atWaist(random, (center, r) => hyperboloidOf(center, quarter(random, 2), r)),
  onCone,
];

/** Along `across` and up or down, but never along a generator, where A = 0. */
function tangentDirection(random: Random, { axial, across, upwards }: TangentPlane): Vec3 {
  for (;;) {
    const lift = integer(random, -5, 5);
    const d = along([0, 0, 0], integer(random, 1, 4) * randomSign(random), across);
    const [x, y, z] = along(d, lift, upwards);
    if (x * x + z * z !== axial.a * y * y) return [x, y, z];
  }
}

export const exactTangent: FamilyParts<Setting & TangentPlane> = {
  id: 'exact-tangent',
  hardness: 'special',
  title: 'exact tangent',
  idea: 'Whole numbers from Pythagorean triples make D exactly 0.',
  dial: null,
  setting(random) {
    const touching = pick(random, TANGENT_PLANES)(random);
    return { ...touching, shape: touching.axial.shape };
  },
  ray(random, touching) {
    const direction = tangentDirection(random, touching);
    const back = quarter(random, 4) * pick(random, [1, 1, 256, 8192]);
    return { origin: along(touching.point, back, direction), direction };
  },
};
