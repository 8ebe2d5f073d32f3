import type { Ray } from '../ray.ts';
import { type Random, randomSign, uniform } from '../rng.ts';
import type { Vec3 } from '../vec3.ts';
import { type Axial, innerPoint, ordinaryAxial, ordinaryCylinder } from './axial.ts';
import { type FamilyParts, powerOfTen } from './define.ts';
import { along, onUnitCircle, plus, unitDirection } from './random-vectors.ts';

/** A direction along the surface at infinity, where A = 0, but for rounding. */
function asymptote(random: Random, { a }: Axial): Vec3 {
  const [cos, sin] = onUnitCircle(random);
  const slope = Math.sqrt(Math.max(a, 0));
  return [slope * cos, randomSign(random), slope * sin];
}

export function nearAxisRay(random: Random, axial: Axial, k: number): Ray {
  const direction = along(asymptote(random, axial), powerOfTen(-k), unitDirection(random));
  const back = -uniform(random, 0, 3);
  return { origin: along(innerPoint(random, axial), back, direction), direction };
}

export const nearAxis: FamilyParts<Axial> = {
  id: 'near-axis',
  hardness: 'hard',
  title: 'near the axis',
  idea: 'd is nearly parallel to the axis or to a generator: A is almost 0 and one root runs off.',
  dial: { title: 'the angle is 10^-k', range: [0, 16], usual: [3, 13] },
  setting: ordinaryAxial,
  ray: nearAxisRay,
};

/**
 * Beside the axis, going nearly along it and nearly at right angles to p: the two products of B
 * cancel.
 */
export const linearCancellation: FamilyParts<Axial> = {
  id: 'linear-cancellation',
  title: 'B cancels',
  idea:
    'Nearly along a cylinder’s axis and nearly at right angles to E − C: A is tiny, and the ' +
    'two products in B cancel.',
  dial: { title: 'the angle to the axis is 10^-k', range: [0, 12], usual: [5, 9] },
  setting: ordinaryCylinder,
  ray(random, { center, r }, k) {
    const [cos, sin] = onUnitCircle(random);
    const distance = r * uniform(random, 0.5, 1.3);
    const tilt = powerOfTen(-k);
    const towards = powerOfTen(-k - uniform(random, 1, 8));
    return {
      origin: plus(center, [distance * cos, uniform(random, -3, 3), distance * sin]),
      direction: [-tilt * sin + towards * cos, randomSign(random), tilt * cos + towards * sin],
    };
  },
};
