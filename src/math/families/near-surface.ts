import type { Ray } from '../ray.ts';
import { integer, pick, type Random, randomSign } from '../rng.ts';
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
  plus,
  pythagorean,
  unit,
  unitDirection,
  wholeVector,
} from './random-vectors.ts';

/** A shape in whole numbers and a point that lies on it exactly. */
interface PointOnSurface {
  readonly axial: Axial;
  readonly point: Vec3;
}

const POINTS_ON_SURFACE: NonEmpty<Draw<PointOnSurface>> = [
  (random) => atWaist(random, cylinderOf),
  (random) => atWaist(random, (center, r) => hyperboloidOf(center, integer(random, -8, 12) / 4, r)),
  (random) => {
    const { x, y: z, n } = pythagorean(random);
    const at = wholeVector(random, 8);
    const c = integer(random, 1, 20);
    const h = randomSign(random) * pick(random, [0.125, 0.25, 1, 2]);
    return { axial: coneOf(at, c), point: plus(at, [c * x * h, n * h, c * z * h]) };
  },
];

function atWaist(random: Random, make: (center: Vec3, r: number) => Axial): PointOnSurface {
  const { x, y: z, n } = pythagorean(random);
  const k = pick(random, [0.125, 0.5, 1, 2]);
  const center = wholeVector(random, 8);
  return { axial: make(center, n * k), point: plus(center, [x * k, 0, z * k]) };
}

export const onSurface: FamilyParts<Setting & { readonly point: Vec3 }> = {
  id: 'on-surface',
  hardness: 'special',
  title: 'on the surface',
  idea: 'E lies on the surface exactly: C = 0, and t = 0 is a root.',
  dial: null,
  setting(random) {
    const standing = pick(random, POINTS_ON_SURFACE)(random);
    return { shape: standing.axial.shape, point: standing.point };
  },
  ray: (random, { point }) => ({ origin: point, direction: unitDirection(random) }),
};

export const nearSurfaceRay = (random: Random, axial: Axial): Ray => ({
  origin: surfacePoint(random, axial).point,
  direction: unitDirection(random),
});

export const nearSurface: FamilyParts<Axial> = {
  id: 'near-surface',
  hardness: 'hard',
  title: 'near the surface',
  idea:
    'E is a point of the surface, rounded to doubles, as a reflected ray’s is: C is nothing ' +
    'but rounding.',
  dial: null,
  setting: ordinaryAxial,
  ray: nearSurfaceRay,
};

export function cancellationRay(random: Random, axial: Axial, k: number): Ray {
  const { point, normal } = surfacePoint(random, axial);
  const gap = randomSign(random) * powerOfTen(-k) * sizeOf(axial);
  return { origin: along(point, gap, unit(normal)), direction: unitDirection(random) };
}

export const cancellation: FamilyParts<Axial> = {
  id: 'cancellation',
  hardness: 'hard',
  title: 'small root',
  idea:
    'E is a hair off the surface: 4AC is tiny against B², and in −B ± √D the smaller root ' +
    'cancels.',
  dial: { title: 'E is 10^-k radii off the surface', range: [0, 15], usual: [7, 13] },
  setting: ordinaryAxial,
  ray: cancellationRay,
};
