import { describe, expect, test } from 'vitest';
import { TWO } from '../../../src/math/batch/batch.ts';
import { type Quadric, quadricOf } from '../../../src/math/batch/quadric.ts';
import { intersect } from '../../../src/math/intersect.ts';
import * as bounds from '../../../src/math/methods/certified/slow-bounds.ts';
import { certifiedSlot, solveSlowly } from '../../../src/math/methods/certified/slow-quadric.ts';
import { BOUND, R } from '../../../src/math/methods/certified/slow-registers.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { seeded } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { disagreement } from './against-exact.ts';
import { climbFromUnits } from './climb.ts';
import { unfaithful } from './exact-quadratic.ts';
import {
  known,
  type Off,
  pairOfProducts,
  QUOTIENT,
  ROOT,
  running,
  TWICE,
} from './running-error.ts';

/* The second stage of curved shapes by itself: its roots' bounds, and what each of its doubts is for. */

const SEED = 91;
const { abs } = Math;
const slot = certifiedSlot();

function solve(shape: Shape, { origin: E, direction: d }: Ray): { q: Quadric; verdict: number } {
  const q = quadricOf(shape) as Quadric;
  return { q, verdict: solveSlowly(q, E[0], E[1], E[2], d[0], d[1], d[2], slot) };
}

describe(`a root's bound, and what its operations may add up to (seed ${SEED})`, () => {
  const { add, sub, mul, exactly, sqr } = running(TWICE);

  /**
   * The shares of both roots' bounds, 0 where the stage does not answer; x, y, z of d and of p, a and r. `charged`: A, C and D are off by all that their own
   * bounds allow them, and b by what its operations may add up to.
   */
  function shares(at: readonly number[], charged: boolean): readonly [number, number] {
    const n = (k: number): number => at[k] ?? 0;
    const flare = 2 * n(6);
    const r = abs(n(7));
    const origin: Vec3 = [n(3), n(4), n(5)];
    const direction: Vec3 = [n(0), n(1), n(2)];
    const shape: Shape = { kind: 'hyperboloid', center: [0, 0, 0], flare, radius: r };
    if (solve(shape, { origin, direction }).verdict !== TWO || slot.exact) return [0, 0];
    const [x, y, z] = direction.map((c) => known(c)) as [Off, Off, Off];
    const [px, py, pz] = origin.map((c) => known(c)) as [Off, Off, Off];
    const [a, rho] = [known(flare), known(r * r)];
    const Am = x.x ** 2 + z.x ** 2 + abs(flare) * y.x ** 2;
    const Cm = px.x ** 2 + pz.x ** 2 + abs(flare) * py.x ** 2 + rho.x;
    const allowed = (value: Off, bound: number): Off =>
      charged ? { ...value, off: bound } : value;
    const A = allowed(
      sub(pairOfProducts([x, x], [z, z], 1, false), mul(a, exactly(y, y))),
      bounds.ERROR_A * Am,
    );
    const b = sub(pairOfProducts([x, px], [z, pz], 1), mul(a, mul(y, py)));
    const C = allowed(sub(sub(add(sqr(px), sqr(pz)), mul(a, sqr(py))), rho), bounds.ERROR_C * Cm);
    const minor = (u: Off, v: Off, s: Off, t: Off): Off => sqr(pairOfProducts([u, t], [v, s], -1));
    const round = add(minor(y, z, py, pz), minor(x, y, px, py));
    const D = allowed(
      add(sub(mul(rho, A), minor(z, x, pz, px)), mul(a, round)),
      bounds.DISCRIMINANT_ERROR * Am * Cm,
    );
    const s = Math.sqrt(D.x);
    const q = add(known(abs(b.x)), { x: s, off: D.off / s + ROOT * s });
    const off = (b.off + q.off) / q.x + QUOTIENT;
    return [
      (off + A.off / abs(A.x)) / (R[BOUND] ?? 0),
      (off + C.off / abs(C.x)) / (R[BOUND + 1] ?? 0),
    ];
  }

  test.each([
    [0, false, 0.6],
    [1, false, 0.6],
    [0, true, 0.95],
    [1, true, 0.95],
  ] as const)('root %i (A, C and D off by all of their bounds: %s)', (k, charged, least) => {
    const most = climbFromUnits(seeded(SEED), 8, (at) => shares(at, charged)[k], 12);
    expect(most).toBeLessThan(1);
    expect(most).toBeGreaterThan(least);
  });

  test('of single operations', () => {
    for (const [bound, cost] of [
      [bounds.ERROR_SUM, TWICE.sum],
      [bounds.ERROR_QUOTIENT, QUOTIENT],
      [bounds.ERROR_ROOT, ROOT],
      [bounds.ERROR_LEVELS, 3 * TWICE.sum],
      [bounds.ACCUMULATED_ERROR, (2 * 38 * 2 ** -53) ** 4 * 2],
    ] as const) {
      expect(cost / bound).toBeLessThanOrEqual(1);
      expect(cost / bound).toBeGreaterThan(0.75);
    }
  });
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

test('what a component of d loses by the scale does not matter', () => {
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
