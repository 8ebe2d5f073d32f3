import type { Ray } from '../ray.ts';
import { pick, type Random, uniform } from '../rng.ts';
import { nearAxisRay } from './asymptotes.ts';
import { type Axial, ordinaryAxial } from './axial.ts';
import type { FamilyParts } from './define.ts';
import { cancellationRay, nearSurfaceRay } from './near-surface.ts';
import { farOriginRay, typicalRay } from './ordinary.ts';
import type { NonEmpty } from './random-vectors.ts';
import { nearTangentFarRay, nearTangentRay } from './tangents.ts';

type DrawRay = (random: Random, axial: Axial) => Ray;

/** Hard rays that any curved shape has. */
const HARD: NonEmpty<DrawRay> = [
  (random, axial) => farOriginRay(random, axial, uniform(random, 3, 9)),
  (random, axial) => nearTangentRay(random, axial, uniform(random, 6, 14)),
  (random, axial) => nearTangentFarRay(random, axial, uniform(random, 2, 6)),
  (random, axial) => nearAxisRay(random, axial, uniform(random, 3, 13)),
  (random, axial) => cancellationRay(random, axial, uniform(random, 7, 13)),
  nearSurfaceRay,
];

export const mix: FamilyParts<Axial> = {
  id: 'mix',
  title: 'typical with 1 % hard',
  idea:
    'Each ray is typical, or with the given chance one of the hard kinds that any curved ' +
    'shape has, in random order.',
  dial: { title: 'hard rays, in percent', range: [0, 100], usual: [1, 1] },
  setting: ordinaryAxial,
  ray: (random, axial, percent) =>
    100 * random() < percent ? pick(random, HARD)(random, axial) : typicalRay(random, axial),
};
