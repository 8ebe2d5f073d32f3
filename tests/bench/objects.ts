import { measure, type Plan, type Task } from '../../src/lab/run.ts';
import { quartiles } from '../../src/lab/stats.ts';
import { FAMILIES, type Family } from '../../src/math/families.ts';
import { intersect, type Ray, type Shape } from '../../src/math/index.ts';
import { integer, pick, type Random, seeded } from '../../src/math/rng.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { clock, ratioOf } from './prices.ts';

/*
 * One ray at a time, as objects, input checked: t and class are read, which is what a caller wants
 * who asks "where is it hit?".
 */

interface Question {
  readonly shape: Shape;
  readonly ray: Ray;
}

/** What one number of a scene that somebody types is: half of them whole, one in three zero. */
const typed = (random: Random): number =>
  random() < 1 / 3 ? 0 : pick(random, [integer(random, -6, 6), integer(random, -24, 24) / 4]);
const typedVector = (random: Random): Vec3 => [typed(random), typed(random), typed(random)];

function typedDirection(random: Random): Vec3 {
  const d = typedVector(random);
  return d.some((x) => x !== 0) ? d : [-1, 0, 0];
}

/** A cylinder, a cone or a hyperboloid in such numbers, and a ray likewise, aimed at nothing. */
function handTyped(random: Random): Question {
  const at = typedVector(random);
  const size = pick(random, [0.5, 1, 1.5, 2, 3]);
  const shapes: readonly [Shape, ...Shape[]] = [
    { kind: 'cylinder', center: at, radius: size },
    { kind: 'cone', vertex: at, slope: size },
    { kind: 'hyperboloid', center: at, flare: pick(random, [0.25, 1, -1, 2]), radius: size },
  ];
  return {
    shape: pick(random, shapes),
    ray: { origin: typedVector(random), direction: typedDirection(random) },
  };
}

const findFamily = (id: string): Family => FAMILIES().find((family) => family.id === id) as Family;
const typical = findFamily('typical');

/** Rays of six shapes, one shape after the other. */
function typicalQuestions(random: Random): Question[] {
  return Array.from({ length: 6 }, () => {
    const { shape, rays } = typical.batch(random, 512);
    return rays.map((ray) => ({ shape, ray }));
  }).flat();
}

const MANY = 4000;

/** How far apart neighbours of many shapes are. */
const STEP = 2 ** -10;

/**
 * A cone and 4,000 rays; and the same again, each ray with a cone of its own, both moved along x by
 * so many steps: the same work but for the shapes.
 */
function manyShapes(random: Random): { readonly many: Question[]; readonly one: Question[] } {
  for (;;) {
    const { shape, rays } = typical.batch(random, MANY);
    if (shape.kind !== 'cone') continue;
    const moved = ([x, y, z]: Vec3, k: number): Vec3 => [x + k * STEP, y, z];
    return {
      one: rays.map((ray) => ({ shape, ray })),
      many: rays.map((ray, k) => ({
        shape: { ...shape, vertex: moved(shape.vertex, k) },
        ray: { ...ray, origin: moved(ray.origin, k) },
      })),
    };
  }
}

let sum = 0;

/** Each method in a loop of its own: a call that meets two methods is slower for both. */
const BY: Readonly<Record<'textbook' | 'certified', (asked: readonly Question[]) => void>> = {
  textbook(asked) {
    for (const { shape, ray } of asked) {
      const { hits } = intersect(shape, ray, 'textbook');
      for (let k = 0; k < hits.length; k++) sum += hits[k]?.t ?? 0;
    }
  },
  certified(asked) {
    for (const { shape, ray } of asked) {
      const { hits } = intersect(shape, ray, 'certified');
      for (let k = 0; k < hits.length; k++) sum += hits[k]?.t ?? 0;
    }
  },
};

const task = (id: string, method: 'textbook' | 'certified', asked: readonly Question[]): Task => ({
  id,
  run: () => BY[method](asked),
});

/** A line of what was compared, and its quartiles. */
export interface Compared {
  readonly what: string;
  readonly low: number;
  readonly median: number;
  readonly high: number;
}

/**
 * Objects go through many more functions than a batch does: the engine has to have compiled them,
 * in other threads of this process, before a round counts.
 */
export function objectPrices(seed: number, plan: Plan): Compared[] {
  const random = seeded(seed);
  const usual = typicalQuestions(random);
  const hand = Array.from({ length: 3000 }, () => handTyped(random));
  const { many, one } = manyShapes(random);
  const times = measure(
    [
      task('textbook, typical', 'textbook', usual),
      task('certified, typical', 'certified', usual),
      task('textbook, hand-typed', 'textbook', hand),
      task('certified, hand-typed', 'certified', hand),
      task('textbook, one shape', 'textbook', one),
      task('textbook, many shapes', 'textbook', many),
      task('certified, one shape', 'certified', one),
      task('certified, many shapes', 'certified', many),
    ],
    clock,
    { ...plan, warmUp: Math.max(plan.warmUp, 4 * plan.rounds) },
  );
  if (Number.isNaN(sum)) throw new Error('a root was not a number');
  const compared = (what: string, id: string, base: string): Compared => ({
    what,
    ...(ratioOf(times, id, base) ?? quartiles([])),
  });
  return [
    compared('certified / textbook, typical', 'certified, typical', 'textbook, typical'),
    compared(
      'certified / textbook, hand-typed numbers with zeros',
      'certified, hand-typed',
      'textbook, hand-typed',
    ),
    compared(
      'certified, 4,000 shapes in turn / one shape',
      'certified, many shapes',
      'certified, one shape',
    ),
    compared(
      'textbook, 4,000 shapes in turn / one shape',
      'textbook, many shapes',
      'textbook, one shape',
    ),
  ];
}
