import type { Ray } from '../ray.ts';
import type { Random } from '../rng.ts';
import { uniform } from '../rng.ts';
import { type Axial, innerPoint, ordinaryAxial, sizeOf } from './axial.ts';
import { type FamilyParts, powerOfTen } from './define.ts';
import { along, inBox, minus, plus, unitDirection } from './random-vectors.ts';

/**
 * From somewhere around the shape; four in five are aimed at its inside, the others anywhere near
 * it.
 */
export function typicalRay(random: Random, axial: Axial): Ray {
  const size = Math.max(1, sizeOf(axial));
  const origin = plus(axial.center, inBox(random, 5 * size));
  const aim =
    random() < 0.8 ? innerPoint(random, axial) : plus(axial.center, inBox(random, 3 * size));
  return { origin, direction: minus(aim, origin) };
}

export const typical: FamilyParts<Axial> = {
  id: 'typical',
  hardness: 'ordinary',
  title: 'typical',
  idea: 'Shapes and rays of a picture: every number between a tenth and ten or so.',
  dial: null,
  setting: ordinaryAxial,
  ray: typicalRay,
};

export function farOriginRay(random: Random, axial: Axial, k: number): Ray {
  const direction = unitDirection(random);
  const distance = powerOfTen(k) * sizeOf(axial) * uniform(random, 1, 2);
  return { origin: along(innerPoint(random, axial), -distance, direction), direction };
}

export const farOrigin: FamilyParts<Axial> = {
  id: 'far-origin',
  hardness: 'hard',
  title: 'far origin',
  idea:
    'E is many radii away and aimed at the shape’s inside: B² and 4AC agree in almost every ' +
    'digit.',
  dial: { title: 'E is 10^k radii away', range: [0, 12], usual: [3, 9] },
  setting: ordinaryAxial,
  ray: farOriginRay,
};
