import { describe, expect, test } from 'vitest';
import { NONE, TWO } from '../../../src/math/batch/batch.ts';
import { solveExactly } from '../../../src/math/batch/exact-quadric.ts';
import { type Quadric, quadricOf } from '../../../src/math/batch/quadric.ts';
import { type Family, findFamily } from '../../../src/math/families.ts';
import { createWork, plainRoots, UNKNOWN } from '../../../src/math/methods/certified/doubled.ts';
import { certifiedSlot } from '../../../src/math/methods/certified/numbers.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { integer, type Random, seeded, uniform } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { unfaithful } from './exact-quadratic.ts';

/*
 * Roots of two doubles each in plain numbers (doubled.ts), asked directly, for rays that the
 * filters would and would not have answered.
 */

const SEED = 93;
const slot = certifiedSlot();
const work = createWork();
const truth = { t0: 0, t1: 0 };

/** The verdict; throws at one that is wrong, and at roots that are not faithful, or −0. */
function checked(shape: Shape, ray: Ray): number {
  const q = quadricOf(shape) as Quadric;
  const verdict = plainRoots(q, ray, slot, work);
  const { origin: E, direction: d } = ray;
  if (verdict === NONE) {
    expect(solveExactly(q, E[0], E[1], E[2], d[0], d[1], d[2], truth)).toBe(NONE);
  } else if (verdict === TWO) {
    expect(unfaithful(q, ray, slot.t0, slot.t1)).toBeNull();
    expect([slot.t0, slot.t1].some((t) => Object.is(t, -0))).toBe(false);
  }
  return verdict;
}

describe(`what it answers is right, and it answers most (seed ${SEED})`, () => {
  test.each([
    ['typical', 0.99],
    ['far-origin', 0.99],
    ['near-tangent', 0.99],
    ['near-axis', 0.95],
    ['cancellation', 0.99],
    ['near-surface', 0.99],
  ])('%s', (id, least) => {
    const random = seeded(SEED);
    const family = findFamily(id) as Family;
    let answered = 0;
    const count = 400;
    for (let n = 0; n < count; n++) {
      const { shape, ray } = family.make(random);
      if (checked(shape, ray) !== UNKNOWN) answered++;
    }
    expect(answered / count).toBeGreaterThan(least);
  });
});

describe(`where it must doubt (seed ${SEED})`, () => {
  const doubts = (make: (random: Random) => { shape: Shape; ray: Ray }, count = 600): number => {
    const random = seeded(SEED);
    let unknown = 0;
    for (let n = 0; n < count; n++) {
      const { shape, ray } = make(random);
      if (checked(shape, ray) === UNKNOWN) unknown++;
    }
    return unknown;
  };

  test('tangents but for a few units of twice the digits', () => {
    const share = doubts((r) => {
      // Touches at (3, 0, 4)/5 of the radius; the distance along the ray is kept short, so that D
      // is all that is hard.
      const [c, s] = [3 / 8, 1 / 2];
      const off = 2 ** -uniform(r, 95, 112) * (r() < 0.5 ? -1 : 1);
      const back = integer(r, 1, 64) / 64;
      const radius = 5 / 8;
      return {
        shape: { kind: 'hyperboloid', center: [0, 0, 0], flare: off, radius },
        ray: { origin: [c + s * back, 1, s - c * back], direction: [-s, 0, c] },
      };
    });
    expect(share).toBeGreaterThan(100);
    expect(share).toBeLessThan(560);
  });

  test('E on the surface: 0 where that is certain', () => {
    const shape: Shape = { kind: 'cylinder', center: [0, 0, 0], radius: 5 };
    for (const direction of [
      [1, 0.3, 0.2],
      [-1, 0.3, 0.2],
      [0.1, 1, -3],
    ] as Vec3[]) {
      expect(checked(shape, { origin: [3, 0, 4], direction })).toBe(TWO);
      expect(Math.min(Math.abs(slot.t0), Math.abs(slot.t1))).toBe(0);
    }
    const cone: Shape = { kind: 'cone', vertex: [0, 0, 0], slope: 1 };
    for (const y of [2, -2])
      expect(checked(cone, { origin: [3, 5, 4], direction: [0.5, y, 0.25] })).toBe(TWO);
    const beside: Shape = { kind: 'cylinder', center: [0, 0, 2 ** -1000], radius: 5 };
    expect(checked(beside, { origin: [5, 0, 0], direction: [1, 0, 0.5] })).toBe(UNKNOWN);
  });

  test('E beside the surface by more than is left out of the sum', () => {
    const radius = 2 ** 20;
    const shape: Shape = { kind: 'cylinder', center: [-radius, 0, 0], radius };
    const beside = (x: number) => checked(shape, { origin: [x, 0, 0], direction: [-1, 1, 0.5] });
    expect(beside(2 ** -105)).toBe(TWO);
    expect(beside(2 ** -118)).toBe(UNKNOWN);
  });

  test('E beside the surface by any part of its size', () => {
    const share = doubts((r) => {
      const radius = 2 ** 20;
      const x = 2 ** -uniform(r, 0, 120);
      const direction: Vec3 = [uniform(r, -1, 1), uniform(r, -1, 1), uniform(r, -1, 1)];
      return {
        shape: { kind: 'cylinder', center: [-radius, 0, 0], radius },
        ray: { origin: [x, 0, 0], direction },
      };
    });
    expect(share).toBeLessThan(60);
  });

  test('numbers for which its bounds mean nothing', () => {
    const share = doubts((r) => {
      const radius = 2 ** integer(r, 90, 110);
      const direction: Vec3 = [-1, uniform(r, -1, 1), uniform(r, -0.1, 0.1)];
      return {
        shape: { kind: 'cone', vertex: [0, 0, 0], slope: 2 ** integer(r, 90, 110) },
        ray: { origin: [2 * radius, uniform(r, -1, 1), 0], direction },
      };
    });
    expect(share).toBeGreaterThan(300);
  });
});
