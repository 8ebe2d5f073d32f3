import { describe, expect, test } from 'vitest';
import { quadricOf } from '../../../src/math/batch/quadric.ts';
import type { Question } from '../../../src/math/families.ts';
import { shortQuadric } from '../../../src/math/methods/certified/curved.ts';
import { certifiedQuadric, readQuadric } from '../../../src/math/methods/certified/numbers.ts';
import { exact } from '../../../src/math/methods/exact.ts';
import { integer, pick, type Random, seeded } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { disagreement, misplaced } from './against-exact.ts';
import { exactHits } from './exact-hits.ts';

/* What people type: whole numbers, quarters, zeros; and the longest numbers that count as short. */

const number = (random: Random, wild: boolean): number => {
  if (random() < 1 / 3) return 0;
  if (!wild) return pick(random, [integer(random, -6, 6), integer(random, -24, 24) / 4]);
  return pick(random, [integer(random, -65536, 65536) / 256, pick(random, [256, -256, 1 / 256])]);
};
const vector = (random: Random, wild: boolean): Vec3 => [
  number(random, wild),
  number(random, wild),
  number(random, wild),
];

function question(random: Random): Question {
  const wild = random() < 0.3;
  const at = vector(random, wild);
  const size = Math.abs(number(random, wild));
  const slope = wild ? integer(random, -256, 256) / 16 : number(random, false) / 4;
  const direction = random() < 0.1 ? ([slope, 1, 0] as const) : vector(random, wild);
  const shapes: readonly [Shape, ...Shape[]] = [
    { kind: 'cylinder', center: at, radius: size },
    { kind: 'cone', vertex: at, slope },
    { kind: 'hyperboloid', center: at, flare: number(random, wild), radius: size },
    { kind: 'sphere', center: at, radius: size },
  ];
  return {
    shape: pick(random, shapes),
    ray: {
      origin: vector(random, wild),
      direction: direction.every((x) => x === 0) ? [0, 1, 0] : direction,
    },
  };
}

describe('rays and shapes in short numbers', () => {
  test('have the exact class, details, roots, points and normals, without whole numbers', () => {
    const random = seeded(91);
    const classes = new Map<string, number>();
    for (let k = 0; k < 6000; k++) {
      const { shape, ray } = question(random);
      const q = quadricOf(shape);
      if (!q) throw new Error(`no numbers of ${shape.kind}`);
      const truth = exactHits(shape, ray);
      const found = shortQuadric(q, certifiedQuadric(q), ray);
      const right = exact.intersect(shape, ray);
      const told = `${JSON.stringify({ shape, ray })} `;
      expect(told + disagreement(shape, ray, truth)).toBe(`${told}null`);
      expect([told, misplaced({ shape, ray }, truth)]).toEqual([told, []]);
      if (!found) continue;
      classes.set(found.class, (classes.get(found.class) ?? 0) + 1);
      expect([told, found.class, found.details]).toEqual([told, right.class, right.details]);
      expect([told, found.hits.map((hit) => hit.singular)]).toEqual([
        told,
        right.hits.map((hit) => hit.singular),
      ]);
    }
    for (const one of ['two', 'none', 'tangent', 'one', 'contained']) {
      expect([one, (classes.get(one) ?? 0) > 3]).toEqual([one, true]);
    }
    expect([...classes.values()].reduce((sum, n) => sum + n, 0)).toBeGreaterThan(5000);
  });
});

describe('a shape that was read before', () => {
  test('is read again once it has changed', () => {
    const shapes = Array.from({ length: 20 }, (_, k) => ({
      kind: 'cone' as const,
      vertex: [k, 0, 0] as [number, number, number],
      slope: 1,
    }));
    for (const shape of shapes) expect(readQuadric(shape)?.q.Cx).toBe(shape.vertex[0]);
    for (const shape of shapes) shape.vertex[0] += 0.5;
    for (const shape of shapes) expect(readQuadric(shape)?.q.Cx).toBe(shape.vertex[0]);
  });
});
