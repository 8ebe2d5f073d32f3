import { integer, pick, type Random, uniform } from '../rng.ts';
import type { Vec3 } from '../vec3.ts';
import { type Axial, coneOf, cylinderOf, hyperboloidOf } from './axial.ts';
import type { FamilyParts } from './define.ts';
import {
  along,
  type Draw,
  inQuarters,
  type NonEmpty,
  nudgedVector,
  quarter,
} from './random-vectors.ts';

/** A shape with a point where its normal is 0, in eighths but for its slope. */
const SINGULAR: NonEmpty<Draw<Axial>> = [
  (random) => coneOf(inQuarters(random, 2), uniform(random, 0.3, 2)),
  (random) => coneOf(inQuarters(random, 2), integer(random, 1, 10) / 4),
  (random) => hyperboloidOf(inQuarters(random, 2), uniform(random, -2, 2), 0),
  (random) => cylinderOf(inQuarters(random, 2), 0),
];

export const vertex: FamilyParts<Axial> = {
  id: 'vertex',
  hardness: 'hard',
  title: 'vertex',
  idea:
    'Through a cone’s vertex, or another singular point, exactly or past it by up to 128 ' +
    'doubles.',
  dial: null,
  setting: (random) => pick(random, SINGULAR)(random),
  ray(random, { center, a }) {
    const direction = slanted(random, a);
    const origin = along(center, -quarter(random, 8), direction);
    return random() < 0.5
      ? { origin, direction }
      : { origin: nudgedVector(random, origin, 128), direction };
  },
};

/** A direction in quarters, not along a generator: that would be another family. */
function slanted(random: Random, a: number): Vec3 {
  for (;;) {
    const [x, y, z] = inQuarters(random, 3);
    if (x * x + z * z !== a * y * y) return [x, y, z];
  }
}
