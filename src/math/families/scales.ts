import { scale } from '../float/bits.ts';
import type { Ray } from '../ray.ts';
import { integer, pick, type Random, randomSign, uniform } from '../rng.ts';
import {
  type Axial,
  coneOf,
  cylinderOf,
  hyperboloidOf,
  innerPoint,
  ordinaryAxial,
  sizeOf,
} from './axial.ts';
import { binaryExponent, type FamilyParts, powerOfTen } from './define.ts';
import { typicalRay } from './ordinary.ts';
import {
  along,
  type Draw,
  inBox,
  minus,
  type NonEmpty,
  onUnitCircle,
  scaled,
} from './random-vectors.ts';

function scaleRayRay(random: Random, axial: Axial, k: number): Ray {
  const { origin, direction } = typicalRay(random, axial);
  return { origin, direction: scaled(direction, binaryExponent(k)) };
}

export const scaleRay: FamilyParts<Axial> = {
  id: 'scale-ray',
  hardness: 'hard',
  title: 'long or short d',
  idea:
    'An ordinary ray whose d is extremely long or short; t shrinks or grows by the same ' +
    'power of two.',
  dial: { title: '|d| is about 10^k', range: [-150, 150], usual: [-150, 150] },
  setting: ordinaryAxial,
  ray: scaleRayRay,
};

/** An ordinary shape and the same shape with every length times 2^bits. */
interface Enlarged {
  readonly shape: Axial['shape'];
  readonly ordinary: Axial;
  readonly bits: number;
}

function enlarged(ordinary: Axial, bits: number): Enlarged {
  const { shape } = ordinary.moved(scaled(ordinary.center, bits), scale(ordinary.r, bits));
  return { shape, ordinary, bits };
}

export const scaleWorld: FamilyParts<Enlarged> = {
  id: 'scale-world',
  title: 'large or small world',
  idea:
    'An ordinary scene with every length times one power of two: t does not change, but D ' +
    'grows with its fourth power.',
  dial: { title: 'lengths are about 10^k', range: [-150, 150], usual: [-140, 140] },
  setting: (random, k) => enlarged(ordinaryAxial(random), binaryExponent(k)),
  ray(random, { ordinary, bits }) {
    const { origin, direction } = typicalRay(random, ordinary);
    return { origin: scaled(origin, bits), direction: scaled(direction, bits) };
  },
};

/**
 * A level ray through the shape, so that there are roots, with t of the order of 2^(±1050 … ±1110).
 */
function rayOutOfRange(random: Random, { ordinary, bits }: Enlarged): Ray {
  const [x, z] = onUnitCircle(random);
  const direction = [x, uniform(random, -0.1, 0.1), z] as const;
  const back = -uniform(random, 4, 8) * sizeOf(ordinary);
  return {
    origin: scaled(along(innerPoint(random, ordinary), back, direction), bits),
    direction: scaled(direction, -Math.sign(bits) * integer(random, 560, 600)),
  };
}

export const outOfRange: FamilyParts<Enlarged> = {
  id: 'out-of-range',
  title: 'roots out of range',
  idea:
    'Lengths near 1e±150 and d near 1e∓175: the roots are beyond the largest double, or ' +
    'below the normal ones.',
  dial: null,
  setting: (random) =>
    enlarged(ordinaryAxial(random), randomSign(random) * integer(random, 490, 510)),
  ray: rayOutOfRange,
};

/** A length from 1e-12 to 1e9, uniform in its logarithm. */
const anySize = (random: Random): number => powerOfTen(uniform(random, -12, 9));

const EXTREMES: NonEmpty<Draw<Axial>> = [
  (random) => cylinderOf(inBox(random, 1), anySize(random)),
  (random) => cylinderOf(inBox(random, 1), 0),
  (random) => coneOf(inBox(random, 1), randomSign(random) * anySize(random)),
  (random) => hyperboloidOf(inBox(random, 1), randomSign(random) * anySize(random), 1),
  (random) => hyperboloidOf(inBox(random, 1), 0, anySize(random)),
  (random) => hyperboloidOf(inBox(random, 1), anySize(random), anySize(random)),
  (random) => hyperboloidOf(inBox(random, 1), -anySize(random), 0),
];

export const extremeParameter: FamilyParts<Axial> = {
  id: 'extreme-parameter',
  title: 'extreme parameter',
  idea: 'c, a or r between 1e-12 and 1e9, or 0, or a < 0, with an ordinary ray.',
  dial: null,
  setting: (random) => pick(random, EXTREMES)(random),
  ray(random, axial) {
    const origin = inBox(random, 5);
    return { origin, direction: minus(innerPoint(random, axial), origin) };
  },
};
