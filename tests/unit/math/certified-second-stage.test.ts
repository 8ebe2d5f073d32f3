import { describe, expect, test } from 'vitest';
import { TWO } from '../../../src/math/batch/batch.ts';
import { type Quadric, quadricOf } from '../../../src/math/batch/quadric.ts';
import { intersect } from '../../../src/math/intersect.ts';
import * as algebra from '../../../src/math/methods/certified/algebra.ts';
import { solveSlowly } from '../../../src/math/methods/certified/doubled.ts';
import { certifiedSlot } from '../../../src/math/methods/certified/numbers.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { disagreement } from './against-exact.ts';
import { unfaithful } from './exact-quadratic.ts';
import { TWICE } from './running-error.ts';

/* What comes after the filters, by itself: what each of its doubts is for. */

const slot = certifiedSlot();

function solve(shape: Shape, ray: Ray): { q: Quadric; verdict: number } {
  const q = quadricOf(shape) as Quadric;
  return { q, verdict: solveSlowly(q, ray, slot) };
}

test('C from its exact terms: what it may be off', () => {
  for (const [bound, cost] of [
    [algebra.ERROR_LEVELS, 3 * TWICE.sum],
    [algebra.ACCUMULATED_ERROR, (2 * 38 * 2 ** -53) ** 4 * 2],
  ] as const) {
    expect(cost / bound).toBeLessThanOrEqual(1);
    expect(cost / bound).toBeGreaterThan(0.75);
  }
});

test('C is not called 0 where a = c² lost bits, nor certain where products are lost', () => {
  const numbers = algebra.createAlgebra();
  const put = (shape: Shape, ray: Ray): void => {
    algebra.putAlgebra(quadricOf(shape) as Quadric, ray, numbers);
    algebra.sharpenC(numbers, 0);
  };
  const off = (): number => numbers[algebra.AT_OFF_C] as number;
  // 9/4 of the least double is rounded to 2 of them, and then C looks like 1 + 1 − 2.
  const cone: Shape = { kind: 'cone', vertex: [0, 0, 0], slope: 3 * 2 ** -538 };
  put(cone, { origin: [2 ** -438, 2 ** 99, 2 ** -438], direction: [1, 0, 0] });
  expect(numbers[algebra.AT_C]).toBe(0);
  expect(off()).toBeGreaterThanOrEqual(algebra.SMALLEST_ALGEBRA);
  put(cone, { origin: [2 ** -500, 1, 2 ** -500], direction: [1, 0, 0] });
  expect(off()).toBeGreaterThanOrEqual(algebra.SMALLEST_ALGEBRA);
});

/** Solved by this stage, right, and as it says. */
function solved(shape: Shape, ray: Ray): void {
  const { q, verdict } = solve(shape, ray);
  expect([verdict, slot.exact]).toEqual([TWO, false]);
  expect(unfaithful(q, ray, slot.t0, slot.t1)).toBeNull();
}

describe('E on the surface, or as near as can be', () => {
  const sphere: Shape = { kind: 'hyperboloid', center: [0, 0, 0], flare: -1, radius: 5 };
  const direction: Vec3 = [-1, 0.25, 0.1];
  test('on it: the root is 0', () => {
    solved(sphere, { origin: [3, 4, 0], direction });
    expect(slot.t0 * slot.t1).toBe(0);
  });
  test.each([20, 40, 50, 60, 80, 120])(
    'off by 2^-%i of its size, which twice the digits cannot tell',
    (k) => {
      const radius = 2 ** 30;
      const shape: Shape = { kind: 'cylinder', center: [-radius, 0, 0], radius };
      for (const rest of [1, 1.25, 5 / 3]) {
        solved(shape, { origin: [rest * 2 ** (30 - k), 0, 0], direction });
        solved(shape, { origin: [-rest * 2 ** (30 - k), 7, 0], direction });
      }
    },
  );
  test('up a cone, whose c² has two parts', () => {
    const slope = 1 + 2 ** -52;
    const shape: Shape = { kind: 'cone', vertex: [0, 0, 0], slope };
    for (const up of [1, 3, 2 ** 20])
      solved(shape, { origin: [slope * up, up, up * 2 ** -60], direction: [1, 0.3, 0.2] });
  });
});

describe('a length that the scale loses leaves E beside the surface', () => {
  const tiny = 2 ** -1000;
  const far = 2 ** 100;
  const slow = 2 ** -500;
  const cylinder = (center: Vec3): Shape => ({ kind: 'cylinder', center, radius: far });
  const cone = (vertex: Vec3): Shape => ({ kind: 'cone', vertex, slope: 1 });
  test.each<[string, Shape, Ray]>([
    ['Ex', cylinder([far, 0, 0]), { origin: [tiny, 0, 0], direction: [slow, 0, slow / 3] }],
    ['Ey', cone([0, -far, 0]), { origin: [far, tiny, 0], direction: [slow / 3, slow, slow] }],
    ['Ez', cylinder([0, 0, far]), { origin: [0, 0, tiny], direction: [slow / 3, 0, slow] }],
    ['Cx', cylinder([tiny, 0, 0]), { origin: [far, 0, 0], direction: [slow, 0, slow / 3] }],
    ['Cy', cone([0, tiny, 0]), { origin: [far, far, 0], direction: [slow / 3, slow, slow] }],
    ['Cz', cylinder([0, 0, tiny]), { origin: [0, 0, far], direction: [slow / 3, 0, slow] }],
    [
      'r',
      { kind: 'hyperboloid', center: [0, 0, 0], flare: 1, radius: 2 ** -600 },
      { origin: [2 ** 500, 2 ** 500, 0], direction: [tiny, 0, tiny] },
    ],
    [
      'r², which is not scaled',
      { kind: 'hyperboloid', center: [0, 0, 0], flare: 1, radius: 2 ** -600 },
      { origin: [1, 1, 0], direction: [slow, 0, slow] },
    ],
  ])('%s', (_, shape, ray) => {
    const { q } = solve(shape, ray);
    expect(unfaithful(q, ray, slot.t0, slot.t1)).toBeNull();
    expect(disagreement(shape, ray)).toBeNull();
  });
});

test('a plane nearly along the ray, whose t is beyond the doubles', () => {
  const shape: Shape = { kind: 'plane', normal: [1, 0, 1], point: [0, 0, 0] };
  for (const z of [2 ** -958, -(2 ** -958), 2 ** -1000, 2 ** -900]) {
    const up: Ray = { origin: [2 ** 80, 0, 0], direction: [0, 1, z] };
    const down: Ray = { origin: [z, 0, 0], direction: [2 ** 80, 1, 0] };
    for (const ray of [up, down]) expect(disagreement(shape, ray)).toBeNull();
  }
});

describe('what it leaves to whole numbers', () => {
  const ray: Ray = { origin: [-7, 1, 0.5], direction: [3, 0.5, 0.25] };
  const still: Vec3 = [0, 0, 0];
  test.each<[string, Shape, Ray]>([
    [
      'a flare beyond what its absolute error is for',
      { kind: 'hyperboloid', center: [0, 0, 0], flare: 2 ** 201, radius: 3 },
      { origin: [-7, 2 ** -150, 0.5], direction: [3, 2 ** -150, 0.25] },
    ],
    [
      'a direction of zeros',
      { kind: 'cylinder', center: [0, 0, 0], radius: 3 },
      { ...ray, direction: still },
    ],
    ['lengths of zeros', { kind: 'cone', vertex: [0, 0, 0], slope: 1 }, { ...ray, origin: still }],
  ])('%s', (_, shape, asked) => {
    solve(shape, asked);
    expect(slot.exact).toBe(true);
  });
});

test('a component of d that other units would lose is left to whole numbers', () => {
  const shape: Shape = { kind: 'hyperboloid', center: [0, 0, 0], flare: -0.5, radius: 3 };
  solved(shape, { origin: [-7, 1, 0.5], direction: [2 ** 60, 2 ** -1040 / 3, 2 ** -1050 / 3] });
});

describe('the stage that answers', () => {
  test.each<[string, Shape, Ray]>([
    [
      'far outside the box of the fast ones',
      { kind: 'cylinder', center: [0, 0, 0], radius: 2 ** 150 },
      { origin: [2 ** 151, 0, 2 ** 140], direction: [-1, 0.5, 0.25] },
    ],
    [
      'nearly along a plane',
      { kind: 'plane', normal: [1, 1, 1], point: [0, 0, 0] },
      { origin: [1, 0.3, 0.7], direction: [1, -1, 2 ** -20] },
    ],
    [
      'grazing there',
      { kind: 'cylinder', center: [0, 0, 0], radius: 2 ** 150 },
      { origin: [2 ** 151, 0, 2 ** 150 * (1 - 2 ** -40)], direction: [-1, 0.5, 0] },
    ],
  ])('%s: twice the digits', (_, shape, ray) => {
    expect(intersect(shape, ray, 'certified').decidedBy).toBe('double-double');
    expect(disagreement(shape, ray)).toBeNull();
  });
});
