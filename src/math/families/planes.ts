import { type Random, uniform } from '../rng.ts';
import type { Shape } from '../shapes/index.ts';
import type { Vec3 } from '../vec3.ts';
import { type FamilyParts, powerOfTen } from './define.ts';
import {
  along,
  cross,
  inBox,
  inQuarters,
  nonZero,
  nudgedVector,
  plus,
  quarter,
  stepsOf,
  unitDirection,
  wholeVector,
} from './random-vectors.ts';

type PlaneSetting = { readonly shape: Shape; readonly normal: Vec3; readonly point: Vec3 };

const planeOf = (normal: Vec3, point: Vec3): PlaneSetting => ({
  shape: { kind: 'plane', normal, point },
  normal,
  point,
});

const ordinaryPlane = (random: Random): PlaneSetting =>
  planeOf(unitDirection(random), inBox(random, 2));

export const plane: FamilyParts<PlaneSetting> = {
  id: 'plane',
  hardness: 'ordinary',
  title: 'plane',
  idea: 'A plane and a ray in no special position.',
  dial: null,
  setting: ordinaryPlane,
  ray: (random) => ({ origin: inBox(random, 5), direction: unitDirection(random) }),
};

/** N and d whole with N·d = 0; d = N × (anything) is at right angles to both. */
function levelDirection(random: Random, normal: Vec3): Vec3 {
  return nonZero(() => cross(normal, wholeVector(random, 4)));
}

export const planeGrazing: FamilyParts<PlaneSetting> = {
  id: 'plane-grazing',
  hardness: 'hard',
  title: 'grazing a plane',
  idea:
    'A ray parallel to the plane, in it or beside it, exactly or with one coordinate of d ' +
    'moved by a few doubles.',
  dial: { title: 'by up to 2^k doubles', range: [0, 12], usual: [0, 3] },
  setting: (random) =>
    planeOf(
      nonZero(() => wholeVector(random, 15)),
      inQuarters(random, 5),
    ),
  ray(random, { normal, point }, k) {
    const level = levelDirection(random, normal);
    const inside = along(point, quarter(random, 2), level);
    const origin = random() < 0.4 ? inside : plus(inside, inQuarters(random, 3));
    const direction = random() < 0.4 ? level : nudgedVector(random, level, stepsOf(k));
    return { origin, direction };
  },
};

export const planeFar: FamilyParts<PlaneSetting> = {
  id: 'plane-far',
  hardness: 'hard',
  title: 'plane from afar',
  idea: 'E is far from a plane near the origin: t is large and N·(E − P) + t N·d cancels.',
  dial: { title: 'E is 10^k away', range: [0, 14], usual: [3, 12] },
  setting: ordinaryPlane,
  ray(random, { point }, k) {
    const direction = unitDirection(random);
    const aim = plus(point, inBox(random, 2));
    return { origin: along(aim, -powerOfTen(k) * uniform(random, 1, 2), direction), direction };
  },
};
