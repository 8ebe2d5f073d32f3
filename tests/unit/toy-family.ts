import { type Axial, ordinaryAxial } from '../../src/math/families/axial.ts';
import type { FamilyParts } from '../../src/math/families/define.ts';
import { uniform } from '../../src/math/rng.ts';

/** A family that is not Graze's own, as a newcomer would add it. */
export const level: FamilyParts<Axial> = {
  id: 'level',
  hardness: 'ordinary',
  title: 'level',
  idea: 'Rays at right angles to the axis: what depends on dy falls out of every formula.',
  dial: null,
  setting: ordinaryAxial,
  ray: (random, { center: [x, y, z] }) => ({
    origin: [x + 9, y + uniform(random, -2, 2), z + uniform(random, -2, 2)],
    direction: [-1, 0, uniform(random, -0.2, 0.2)],
  }),
};
