import { describe, expect, test } from 'vitest';
import type { Question } from '../../../src/math/families.ts';
import { scale } from '../../../src/math/float/bits.ts';
import { integer, pick, type Random, randomSign, seeded, uniform } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { many } from '../many.ts';
import { disagreement, misplaced } from './against-exact.ts';

/*
 * Hits and misses by a few ulps, with every exponent: each product of a filter leaves the doubles
 * for some of them. The guards of the fast stages (BOX, the absolute terms) are there for these
 * alone.
 */
const SEED = 81;
const times = (v: Vec3, k: number): Vec3 => [scale(v[0], k), scale(v[1], k), scale(v[2], k)];
const vector = (random: Random): Vec3 => [
  uniform(random, -1, 1),
  uniform(random, -1, 1),
  uniform(random, -1, 1),
];
const few = (random: Random): number => 1 + randomSign(random) * 2 ** -uniform(random, 20, 53);

/**
 * Exponents of the shape's own number (a normal, or heights), of lengths and of d: anything, all
 * within the box, or one such that it adds up with another one, or with both, to about those of the
 * smallest doubles, or so that t does. The others are within the box half of the time.
 */
function exponents(random: Random): [number, number, number] {
  const most = random() < 0.5 ? 99 : 900;
  const all = [0, 1, 2].map(() => integer(random, -most, most)) as [number, number, number];
  const target = integer(random, -1090, -960);
  const k = integer(random, 0, 2);
  const other = (k + integer(random, 1, 2)) % 3;
  const third = 3 - k - other;
  const kind = integer(random, 0, 5);
  if (kind === 1) all[k] = target - (all[other] as number);
  if (kind === 2) all[k] = Math.round(target / 2);
  if (kind === 3) all[k] = target - (all[other] as number) - (all[third] as number);
  if (kind === 4) all[2] = all[1] + randomSign(random) * target;
  if (kind === 5) all[1] = all[2] + randomSign(random) * target;
  return all.map((x) => Math.max(-1010, Math.min(1000, x))) as [number, number, number];
}

/**
 * Straight up but for rests, so that the circle lies in y = 0 as far as the doubles of its rim
 * tell.
 */
const lean = (random: Random): Vec3 => [
  uniform(random, -1, 1) * 2 ** -70,
  uniform(random, 1, 2),
  uniform(random, -1, 1) * 2 ** -70,
];

/** A line past a point of a plane, of the rim of a circle, or of the edge of a square. */
function beside(random: Random): Question {
  const [n, l, s] = exponents(random);
  const phi = uniform(random, 0, 6.3);
  const direction = vector(random);
  const t = uniform(random, -4, 4);
  const by = few(random);
  const onEdge: Vec3 = [by, 0, uniform(random, 0, 1)];
  const onRim: Vec3 = [Math.cos(phi) * by, 0, Math.sin(phi) * by];
  const center: Vec3 = [0, 0, 0];
  const normal = times(lean(random), n);
  const shapes: readonly [Shape, Shape, Shape] = [
    { kind: 'square', corner: center, side: scale(1, l), axis: 'y' },
    { kind: 'circle', normal, center, radius: scale(1, l) },
    { kind: 'plane', normal: times(vector(random), n), point: times(vector(random), l) },
  ];
  const shape = pick(random, shapes);
  const target = shape.kind === 'square' ? onEdge : onRim;
  const origin = target.map((x, k) => x - t * (direction[k] as number)) as unknown as Vec3;
  return { shape, ray: { origin: times(origin, l), direction: times(direction, s) } };
}

/**
 * A line past a point of a curved shape, nearly along its tangent or not; heights have an exponent
 * of their own.
 */
function along(random: Random): Question {
  const [l, s, h] = exponents(random);
  const up = Math.round(h / 3);
  const phi = uniform(random, 0, 6.3);
  const y = random() < 0.3 ? 0 : uniform(random, -1, 1);
  const cone = random() < 0.4;
  const slope = uniform(random, 0.3, 2);
  const flare = cone ? slope * slope : randomSign(random) * slope;
  const wide = Math.sqrt(Math.max(flare * y * y + (cone ? 0 : 1), 0)) * few(random);
  const point: Vec3 = [wide * Math.cos(phi), y, wide * Math.sin(phi)];
  const tangent: Vec3 = [
    -Math.sin(phi),
    random() < 0.5 ? 0 : uniform(random, -1, 1),
    Math.cos(phi),
  ];
  const direction = random() < 0.5 ? tangent : vector(random);
  const t = random() < 0.2 ? 0 : uniform(random, -2, 2);
  const at = point.map((x, k) => x - t * (direction[k] as number)) as unknown as Vec3;
  const tall = (v: Vec3): Vec3 => [v[0], scale(v[1], -up), v[2]];
  const shape: Shape = cone
    ? { kind: 'cone', vertex: [0, 0, 0], slope: scale(slope, up) }
    : { kind: 'hyperboloid', center: [0, 0, 0], flare: scale(flare, 2 * up), radius: scale(1, l) };
  return { shape, ray: { origin: times(tall(at), l), direction: times(tall(direction), s) } };
}

const finite = ({ shape, ray }: Question): boolean =>
  ray.direction.some((x) => x !== 0) &&
  [...ray.origin, ...ray.direction].every(Number.isFinite) &&
  !('normal' in shape && shape.normal.every((x) => x === 0));

describe(`hits and misses by a few ulps, of every exponent (seed ${SEED})`, () => {
  test.each([
    ['flat', beside],
    ['curved', along],
  ] as const)('%s', (_, make) => {
    const random = seeded(SEED);
    for (let k = 0; k < many(16_000); k++) {
      const question = make(random);
      if (!finite(question)) continue;
      expect(disagreement(question.shape, question.ray)).toBeNull();
      if (k % 4 === 0) expect(misplaced(question)).toEqual([]);
    }
  });
});
