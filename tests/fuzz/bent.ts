import type { Question } from '../../src/math/families.ts';
import { scale } from '../../src/math/float/bits.ts';
import { nextDown, nextUp } from '../../src/math/float/ulp.ts';
import type { Ray } from '../../src/math/ray.ts';
import { integer, pick, type Random, wide } from '../../src/math/rng.ts';
import type { Shape } from '../../src/math/shapes/index.ts';

type Bend = (x: number, random: Random) => number;
const BENDS: readonly [Bend, ...Bend[]] = [
  (x) => x,
  (x) => nextUp(x),
  (x) => nextDown(x),
  (x, random) => scale(x, integer(random, -60, 60)),
  (x, random) => scale(x, integer(random, -1100, 1000)),
  () => 0,
  (_, random) => wide(random),
  (_, random) => wide(random, -1074, -900),
  (_, random) => integer(random, -3, 3),
];

const MAX = Number.MAX_VALUE;
const finite = (x: number): number => (x > MAX ? MAX : x < -MAX ? -MAX : x);

/** A question with a few of its numbers bent; one in three is left as its family made it. */
export function bent({ shape, ray }: Question, random: Random): Question {
  const chance = pick(random, [0, 0.08, 0.3]);
  const touch = (x: number): number =>
    random() < chance ? finite(pick(random, BENDS)(x, random)) : x;
  const entries = Object.entries(shape).map(([key, x]): [string, unknown] => {
    if (Array.isArray(x)) return [key, x.map(touch)];
    if (typeof x !== 'number') return [key, x];
    return [key, key === 'radius' || key === 'side' ? Math.abs(touch(x)) : touch(x)];
  });
  const made = Object.fromEntries(entries) as unknown as Shape;
  const direction = ray.direction.map(touch) as unknown as Ray['direction'];
  return {
    shape: 'normal' in made && made.normal.every((x) => x === 0) ? shape : made,
    ray: {
      origin: ray.origin.map(touch) as unknown as Ray['origin'],
      direction: direction.every((x) => x === 0) ? ray.direction : direction,
    },
  };
}
