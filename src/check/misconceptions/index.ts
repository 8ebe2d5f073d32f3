import {
  differenceTurned,
  flareSquared,
  heightAdded,
  radiusAdded,
  radiusNotSquared,
  slopeNotSquared,
  swappedInB,
  twoInBLost,
} from './coefficients.ts';
import type { Misconception } from './define.ts';
import {
  alwaysBeside,
  alwaysIn,
  alwaysTheRoot,
  cornerIsMiddle,
  flatDistance,
  flatInverted,
  flatMinusLost,
  flatPointForgotten,
  rimSquared,
} from './flat.ts';
import {
  alongUnit,
  backwards,
  behindAccepted,
  farForNear,
  lightForgotten,
  oneNappe,
  startForgotten,
} from './hits.ts';
import {
  normalFactor,
  normalIsPoint,
  normalOfSphere,
  normalSign,
  normalTurned,
} from './normals.ts';
import { ON_PAPER } from './on-paper.ts';
import { READINGS } from './readings.ts';
import {
  aEpsilon,
  dEpsilon,
  dividedByA,
  fourAdded,
  fourLost,
  linearIgnored,
  minusLost,
  rootsSwapped,
  tangentLost,
  tIsDistance,
} from './roots.ts';

/**
 * Every mistake that a program can show, in the order of the lines in which they happen. A new one
 * is one value and one word here.
 */
export const MISCONCEPTIONS: readonly Misconception[] = [
  radiusNotSquared,
  slopeNotSquared,
  flareSquared,
  heightAdded,
  twoInBLost,
  swappedInB,
  differenceTurned,
  radiusAdded,
  linearIgnored,
  aEpsilon,
  fourLost,
  fourAdded,
  tangentLost,
  dEpsilon,
  dividedByA,
  minusLost,
  tIsDistance,
  rootsSwapped,
  oneNappe,
  behindAccepted,
  farForNear,
  lightForgotten,
  startForgotten,
  backwards,
  alongUnit,
  normalTurned,
  normalOfSphere,
  normalSign,
  normalFactor,
  normalIsPoint,
  flatPointForgotten,
  flatInverted,
  flatMinusLost,
  flatDistance,
  rimSquared,
  cornerIsMiddle,
  alwaysBeside,
  alwaysIn,
  alwaysTheRoot,
];

/** All mistakes, also those that only answers to questions can show. */
export const ALL_MISCONCEPTIONS: readonly Misconception[] = [
  ...MISCONCEPTIONS,
  ...ON_PAPER,
  ...READINGS,
];

export const findMisconception = (id: string): Misconception | undefined =>
  ALL_MISCONCEPTIONS.find((one) => one.id === id);
