import { describe, expect, test } from 'vitest';
import { intersect } from '../../../src/math/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { seeded } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { graphOf } from '../../../src/state/graph.ts';
import { at, DRAWS, dot, drawRay, f, figurePlace, flatOf, less, quadricOf } from './ray-oracle.ts';

/** What a place at t is to be called, from nothing but the point there. */
function nameAt(shape: Shape, ray: Ray, t: number): string {
  if (t < 0) return 'behind';
  const x = at(ray, t);
  const q = quadricOf(shape);
  if (q) return ['inside', 'on it', 'outside'][Math.sign(f(q, x)) + 1] ?? '';
  const { N, P } = flatOf(shape) ?? { N: [0, 0, 0], P: [0, 0, 0] };
  const side = dot(N, less(x, P));
  if (side !== 0) return side > 0 ? 'side of N' : 'other side';
  return figurePlace(shape, x).off === 0 ? 'on it' : 'outside';
}

/**
 * A number in the middle of an interval with as few digits as there is room for, so that f of it is
 * exact.
 */
function within(from: number, to: number): number {
  for (let step = 4; step > 2 ** -12; step /= 2) {
    const t = Math.round((from + to) / 2 / step) * step;
    if (t > from && t < to) return t;
  }
  return (from + to) / 2;
}

describe.each(Object.keys(DRAWS))('%s', (kind) => {
  test('each stretch of the graph is called what the ray is there (400 rays, seed 6)', () => {
    const random = seeded(6);
    const faults: string[] = [];
    for (let i = 0; i < 400; i++) {
      const shape = DRAWS[kind]?.(random) as Shape;
      const ray = drawRay(random, shape);
      const { stretches } = graphOf(intersect(shape, ray), shape, ray, null);
      for (const { from, to, place } of stretches) {
        const t = within(from, to);
        const name = nameAt(shape, ray, t);
        if (name !== place)
          faults.push(`${JSON.stringify({ shape, ray })} at ${t}: ${place}, ${name}`);
      }
      const twice = stretches.filter(({ place }, k) => place === 'behind' && k > 0);
      if (twice.length > 0) faults.push(`${JSON.stringify({ shape, ray })}: behind twice`);
    }
    expect(faults.slice(0, 5)).toEqual([]);
  });
});

test('a method that cannot tell names no stretch', () => {
  const shape: Shape = { kind: 'cylinder', center: [0, 0, 0], radius: 1e200 };
  const ray: Ray = { origin: [2e200, 0, 0], direction: [-1e200, 0, 0] };
  const { stretches } = graphOf(intersect(shape, ray, 'textbook'), shape, ray, null);
  expect(stretches.map(({ place }) => place)).toEqual(['behind', null]);
});

test.each([1, 1e-3, 1e-9, 1e-160, 1e9])(
  'in a world of size %s two roots are told apart',
  (size) => {
    const shape: Shape = { kind: 'cylinder', center: [0, 0, 0], radius: size };
    for (const start of [3, 1, 0.5]) {
      const ray: Ray = { origin: [start * size, 0, size / 4], direction: [-1, 0, 0] };
      const { from, to, note, roots } = graphOf(intersect(shape, ray), shape, ray, null);
      expect(note).toBeNull();
      const [first = 0, second = 0] = roots.map(({ t }) => t);
      expect((second - first) / (to - from)).toBeGreaterThan(0.05);
    }
  },
);
