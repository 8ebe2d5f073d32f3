import type { Ray } from '../ray.ts';
import { integer, pick, type Random, randomSign } from '../rng.ts';
import type { Vec3 } from '../vec3.ts';
import { type Axial, coneOf, cylinderOf, hyperboloidOf } from './axial.ts';
import type { FamilyParts } from './define.ts';
import {
  along,
  type Draw,
  inQuarters,
  type NonEmpty,
  nudgedVector,
  plus,
  pythagorean,
  quarter,
  stepsOf,
  times,
} from './random-vectors.ts';

/**
 * A curved shape in quarters whose slope √a is one of them too, so that A = 0 has solutions in
 * doubles.
 */
interface Ruled extends Axial {
  readonly slope: number;
}

const RULED: NonEmpty<Draw<Ruled>> = [
  (random) => ({ ...cylinderOf(inQuarters(random, 2), positiveQuarter(random)), slope: 0 }),
  (random) => {
    const slope = positiveQuarter(random) * randomSign(random);
    return { ...coneOf(inQuarters(random, 2), slope), slope };
  },
  (random) => {
    const slope = positiveQuarter(random);
    const center = inQuarters(random, 2);
    return { ...hyperboloidOf(center, slope * slope, positiveQuarter(random)), slope };
  },
];

const positiveQuarter = (random: Random): number => integer(random, 1, 10) / 4;
const ruled = (random: Random): Ruled => pick(random, RULED)(random);

/** A = 0 exactly: (slope x, n, slope z) with x² + z² = n². */
function exactAsymptote(random: Random, { slope }: Ruled): Vec3 {
  const { x, y: z, n } = pythagorean(random);
  const k = randomSign(random) * pick(random, [1, 0.5, 2, 0.125]);
  return times(k, slope === 0 ? [0, 1, 0] : [slope * x, n, slope * z]);
}

export const linear: FamilyParts<Ruled> = {
  id: 'linear',
  hardness: 'special',
  title: 'A = 0',
  idea:
    'd is exactly parallel to the axis or to a generator: the quadratic is a line, with one ' +
    'root or none.',
  dial: null,
  setting: ruled,
  ray: (random, shape) => ({
    origin: plus(inQuarters(random, 4), [0.125, 0, 0]),
    direction: exactAsymptote(random, shape),
  }),
};

/**
 * Either way round at one of the four quarters of the waist, whose points are doubles for any r.
 */
function waistRuling(random: Random, { center, r, slope }: Ruled): Ray {
  const s = randomSign(random);
  const turn = randomSign(random) * slope;
  return random() < 0.5
    ? { origin: plus(center, [s * r, 0, 0]), direction: [0, 1, turn] }
    : { origin: plus(center, [0, 0, s * r]), direction: [turn, 1, 0] };
}

/**
 * A line in the surface: along a cone's generator, a cylinder's, or one of a hyperboloid's two
 * rulings.
 */
function generatorRay(random: Random, shape: Ruled): Ray {
  const through =
    shape.r === 0
      ? { origin: shape.center, direction: exactAsymptote(random, shape) }
      : waistRuling(random, shape);
  return { ...through, origin: along(through.origin, quarter(random, 3), through.direction) };
}

export const generator: FamilyParts<Ruled> = {
  id: 'generator',
  hardness: 'special',
  title: 'generator',
  idea: 'The whole ray lies in the surface: A = B = C = 0.',
  dial: null,
  setting: ruled,
  ray: generatorRay,
};

export const nearGenerator: FamilyParts<Ruled> = {
  id: 'near-generator',
  hardness: 'hard',
  title: 'near a generator',
  idea: 'A ray in the surface with one coordinate of E or d moved by a few doubles.',
  dial: { title: 'by up to 2^k doubles', range: [0, 12], usual: [0, 2] },
  setting: ruled,
  ray(random, shape, k) {
    const { origin, direction } = generatorRay(random, shape);
    const most = stepsOf(k);
    return random() < 0.5
      ? { origin: nudgedVector(random, origin, most), direction }
      : { origin, direction: nudgedVector(random, direction, most) };
  },
};
