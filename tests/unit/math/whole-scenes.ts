import type { Question } from '../../../src/math/families.ts';
import { exponentOf, MAX_EXPONENT, MIN_EXPONENT, scale } from '../../../src/math/float/bits.ts';
import { LEAST_EXACT_PRODUCT } from '../../../src/math/float/eft.ts';
import * as algebra from '../../../src/math/methods/certified/algebra.ts';
import * as classes from '../../../src/math/methods/certified/class.ts';
import * as moment from '../../../src/math/methods/certified/class.ts';
import { ORDINARY } from '../../../src/math/methods/certified/doubled.ts';
import * as hit from '../../../src/math/methods/certified/hits.ts';
import * as places from '../../../src/math/methods/certified/hits.ts';
import { BOX, FAITHFUL } from '../../../src/math/methods/certified/numbers.ts';
import * as flat from '../../../src/math/methods/certified/planar.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { integer, pick, type Random, uniform } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';

/*
 * Hard rays in other units: all lengths times one power of two, d times another. Where these stand
 * is what decides which stage answers, and what overflows or underflows on the way; the mantissas
 * have no say in it. So they are drawn near the powers of two at which the source compares.
 */

const limits = [
  ...[
    algebra.SMALLEST_ALGEBRA,
    algebra.SMALLEST_ALGEBRA_D,
    algebra.LARGE,
    classes.SMALLEST_DIRECT,
    classes.LARGEST,
  ],
  ...[
    hit.SMALLEST_NORMAL,
    hit.LOST_POINT,
    moment.SMALLEST_D,
    algebra.SMALLEST_C,
    places.SMALLEST_PLACE,
    places.WIDE,
  ],
  ...[flat.SMALLEST_PLANAR, BOX, 1 / BOX, ORDINARY, 1 / ORDINARY, LEAST_EXACT_PRODUCT],
].map(exponentOf);

/** Where a bound is compared with a number that it is to be a small share of. */
const shares = limits.filter((at) => at < 0).map((at) => at - exponentOf(FAITHFUL));

/** Where doubles end, lose bits, or can no longer be split in halves. */
const doubles = [MIN_EXPONENT, -1022, -968, 996, 1022, MAX_EXPONENT];

const GROUPS = [limits, shares, doubles] as const;
const threshold = (random: Random): number =>
  pick(random, pick(random, GROUPS) as [number, ...number[]]);

const near = (random: Random, at: number): number => Math.round(at) + integer(random, -3, 3);

/**
 * Exponents of the lengths and of d by which one of them, or what the algebra makes of both, is
 * near a threshold: lengths l, l² or l⁴, d likewise, b and F' ~ l d, D ~ l² d², t ~ l / d.
 */
function units(random: Random): { readonly length: number; readonly speed: number } {
  const one = (): number => near(random, threshold(random) / pick(random, [1, 2, 4]));
  const wide = exponentOf(places.WIDE);
  const length = pick<() => number>(random, [
    one,
    () => integer(random, -wide, wide),
    () => integer(random, MIN_EXPONENT, MAX_EXPONENT),
  ])();
  const speed = pick<() => number>(random, [
    one,
    () => near(random, threshold(random) - length),
    () => near(random, threshold(random) / 2 - length),
    () => near(random, length - threshold(random)),
    () => 0,
  ])();
  return { length, speed };
}

const MAX = Number.MAX_VALUE;
const finite = (x: number): number => (x > MAX ? MAX : x < -MAX ? -MAX : x);

/**
 * The question with its largest length near 2^length and its largest part of d near 2^speed; as it
 * was, where d or a normal would vanish.
 */
export function inUnits({ shape, ray }: Question, length: number, speed: number): Question {
  const largest = (xs: readonly number[]): number => Math.max(...xs.map(Math.abs));
  const isLength = (key: string, x: unknown): boolean =>
    Array.isArray(x) ? key !== 'normal' : key === 'radius' || key === 'side';
  const entries = Object.entries(shape) as [string, unknown][];
  const lengths = entries.filter(([key, x]) => isLength(key, x)).flatMap(([, x]) => x as number[]);
  const size = largest([...lengths, ...ray.origin]);
  const by = size > 0 ? length - exponentOf(size) : 0;
  const times = (x: number, k: number): number => finite(scale(x, k));
  const vector = (v: readonly number[], k: number): Vec3 =>
    v.map((x) => times(x, k)) as unknown as Vec3;
  const direction = vector(ray.direction, speed - exponentOf(largest(ray.direction)));
  if (direction.every((x) => x === 0)) return { shape, ray };
  const made = entries.map(([key, x]): [string, unknown] => {
    if (!isLength(key, x)) return [key, x];
    return [key, Array.isArray(x) ? vector(x, by) : times(x as number, by)];
  });
  return {
    shape: Object.fromEntries(made) as unknown as Shape,
    ray: { origin: vector(ray.origin, by), direction },
  };
}

/** The question with everything scaled to where the source compares. */
export function scaled(question: Question, random: Random): Question {
  const { length, speed } = units(random);
  return inUnits(question, length, speed);
}

/**
 * E so far off a surface that C, which cancels, is near a threshold, with d by which D or F' is
 * near one, or is of ordinary size.
 */
export function aimed(random: Random): Question {
  const C = near(
    random,
    pick(random, [...limits, ...shares].filter((at) => at < -100) as [number]),
  );
  const bits = integer(random, 2, 50);
  // C ~ l² 2^-bits.
  const length = Math.floor((C + bits) / 2);
  const by = pick<() => number>(random, [
    () => near(random, threshold(random) / 2 - length),
    () => near(random, threshold(random) - length),
    () => integer(random, -3, 100),
  ])();
  const speed = Math.min(Math.max(by, MIN_EXPONENT), MAX_EXPONENT);
  const phi = pick(random, [0, Math.PI, uniform(random, 0, 7)]);
  const away = 1 + pick(random, [1, -1]) * 2 ** -bits * uniform(random, 0.5, 1);
  const [c, s] = [Math.cos(phi), phi === Math.PI ? 0 : Math.sin(phi)];
  const shape = pick<Shape>(random, [
    { kind: 'cylinder', center: [0, 0, 0], radius: 1 },
    { kind: 'cone', vertex: [0, 0, 0], slope: 1 },
    { kind: 'hyperboloid', center: [0, 0, 0], flare: pick(random, [1, -1, 0.5]), radius: 1 },
  ]);
  const y = shape.kind === 'cone' ? 1 : 0;
  const some = (): number => pick(random, [0, 1, uniform(random, -1, 1)]);
  const ray: Ray = {
    origin: [away * c, y, away * s],
    direction: [pick(random, [1, -1, uniform(random, -1, 1)]), some(), some()],
  };
  return inUnits({ shape, ray }, length, speed);
}
