import { describe, expect, test } from 'vitest';
import { createAnswers, packRays } from '../../../src/math/batch/batch.ts';
import { type Quadric, quadricOf } from '../../../src/math/batch/quadric.ts';
import * as dy from '../../../src/math/exact/dyadic.ts';
import { AT, latticeOf } from '../../../src/math/methods/certified/lattice.ts';
import { SLACK, SLACK_A } from '../../../src/math/methods/certified/lattice-bounds.ts';
import { coarseInSpace } from '../../../src/math/methods/certified/lattice-coarse.ts';
import {
  createScratch,
  HITS,
  UNSETTLED,
} from '../../../src/math/methods/certified/lattice-scratch.ts';
import { RESIDUAL_ERROR, solvePass } from '../../../src/math/methods/certified/lattice-solve.ts';
import { type Random, seeded, uniform } from '../../../src/math/rng.ts';
import { form } from './exact-quadratic.ts';

/*
 * Pass 3 on quadratics whose roots are known: A(t − a − δa)(t − b − δb). With a = 0 the root is the step itself, not rounded to a larger number, and
 * shows the step's own error.
 */

const U = 2 ** -53;
const scratch = createScratch();
const solve = solvePass(scratch);
const out = createAnswers(1);
const lattice = new Float64Array(Object.keys(AT).length);
lattice[AT.back] = 1;

interface Known {
  readonly A: number;
  readonly a: number;
  readonly b: number;
  readonly stepA: number;
  readonly stepB: number;
  readonly overA?: number;
  readonly slack?: number;
  readonly offNear?: number;
}

const n = dy.fromNumber;

/** f/2 at t, rounded once. */
function halfAt({ A, a, b, stepA, stepB }: Known, t: number): number {
  const from = (root: number, step: number): dy.Dyadic => dy.sub(dy.sub(n(t), n(root)), n(step));
  return dy.toNumber(dy.shift(dy.mul(n(A), dy.mul(from(a, stepA), from(b, stepB))), -1));
}

/** The roots that pass 3 certifies; null if it does not. */
function solved(known: Known): readonly [number, number] | null {
  const { A, a, b, stepA, stepB, overA = 1 / A, slack = 0, offNear = 0 } = known;
  const put = (array: Float64Array, x: number): void => {
    array[0] = x;
  };
  put(scratch.A, A);
  put(scratch.overA, overA);
  put(scratch.near, a + stepA);
  put(scratch.far, b + stepB);
  put(scratch.overGap, 1 / (2 * (b + stepB - a - stepA)));
  put(scratch.slack, slack);
  put(scratch.fNear, halfAt(known, a) + offNear);
  put(scratch.fFar, halfAt(known, b));
  put(scratch.overAH, 1 / (A * (b - a)));
  put(scratch.spread, 0);
  put(scratch.spreadFar, 0);
  scratch.count[HITS] = 1;
  solve(lattice, out);
  if (scratch.count[UNSETTLED] === 1) return null;
  return [out.t0[0] as number, out.t1[0] as number];
}

function anyKnown(random: Random): Known {
  const gap = Math.round(uniform(random, 64, 5000));
  const step = (): number => uniform(random, -0.5, 0.5);
  const A = (random() < 0.5 ? -1 : 1) * uniform(random, 1, 4) * 2 ** 24;
  return random() < 0.5
    ? { A, a: 0, b: gap, stepA: step(), stepB: step() }
    : { A, a: -gap, b: 0, stepA: step(), stepB: step() };
}

/** The unrounded root's error, relative to its step. */
function stepError(known: Known): number {
  const roots = solved(known);
  if (!roots) return 0;
  const [t, step] = known.a === 0 ? [roots[0], known.stepA] : [roots[1], known.stepB];
  return Math.abs(t - step) / Math.abs(step);
}

describe('pass 3 (seed 61)', () => {
  test('a step is off by less than its slack, and not by much less', () => {
    const random = seeded(61);
    let worst = 0;
    for (let k = 0; k < 20000; k++) {
      const known = anyKnown(random);
      // 1/A as pass 1 may have it: 3u, and 4u for A.
      const overA = (1 / known.A) * (1 + (random() < 0.5 ? -7 : 7) * U);
      worst = Math.max(worst, stepError({ ...known, overA }));
    }
    expect(worst).toBeLessThan(SLACK_A + SLACK);
    expect(worst).toBeGreaterThan((SLACK_A + SLACK) / 4);
  });

  test('an error of f moves the step by no more than is charged, and not by much less', () => {
    const random = seeded(62);
    let worst = 0;
    for (let k = 0; k < 20000; k++) {
      const known = { ...anyKnown(random), a: 0, b: Math.round(uniform(random, 33, 99)) };
      const off = 2 ** -26 * known.A;
      const before = solved(known);
      const after = solved({ ...known, offNear: off });
      if (!before || !after) continue;
      const charge = off / (known.A * known.b);
      worst = Math.max(worst, Math.abs(after[0] - before[0]) / charge);
    }
    expect(worst).toBeLessThan(RESIDUAL_ERROR / U);
    expect(worst).toBeGreaterThan(RESIDUAL_ERROR / U / 2);
  });

  const steady: Known = { A: 2 ** 30, a: 0, b: 999, stepA: 0.25, stepB: -0.25 };
  test('an error of half the distance to the next double is too much, for either root', () => {
    expect(solved({ ...steady, slack: 0.8 * 2 ** -54 })).toEqual([0.25, 998.75]);
    expect(solved({ ...steady, slack: 2 ** -54 })).toBeNull();
    const mirrored: Known = { ...steady, a: -999, b: 0 };
    expect(solved({ ...mirrored, slack: 0.8 * 2 ** -54 })).toEqual([-998.75, -0.25]);
    expect(solved({ ...mirrored, slack: 2 ** -54 })).toBeNull();
  });

  test('the gap must be much larger than the steps', () => {
    expect(solved({ ...steady, b: 20 })).not.toBeNull();
    expect(solved({ ...steady, b: 15 })).toBeNull();
  });

  test('what is not a number is not certified', () => {
    expect(solved({ ...steady, slack: Number.NaN })).toBeNull();
    expect(solved({ ...steady, b: 0, stepB: 0.25 })).toBeNull();
    expect(solved({ ...steady, overA: Number.POSITIVE_INFINITY })).toBeNull();
  });
});

test('1/A is known as well as pass 1 says, and not much better where A cancels (seed 63)', () => {
  const random = seeded(63);
  const coarse = coarseInSpace(scratch);
  let worst = 0;
  let seen = 0;
  for (let k = 0; k < 20000; k++) {
    const slope = uniform(random, 0.3, 3);
    const phi = uniform(random, 0, 6.3);
    const steep = slope * (1 + uniform(random, -0.1, 0.1));
    const direction = [steep * Math.cos(phi), 1, steep * Math.sin(phi)] as const;
    const q = quadricOf({ kind: 'cone', vertex: [0, 0, 0], slope }) as Quadric;
    const units = latticeOf(q) as Float64Array;
    const origin = [
      uniform(random, -9, 9),
      uniform(random, -9, 9),
      uniform(random, -9, 9),
    ] as const;
    coarse(units, packRays([{ origin, direction }]), out, 0, 1);
    if (scratch.count[HITS] !== 1) continue;
    const d = direction.map(n);
    const exact = form(dy.sqr(n(slope)), d, d);
    const scale = (units[AT.direction] as number) ** 2;
    const product = dy.mul(exact, n((scratch.overA[0] as number) * scale));
    const off = Math.abs(dy.toNumber(dy.sub(product, dy.ONE)));
    const charged = (scratch.slack[0] as number) - SLACK;
    worst = Math.max(worst, off / charged);
    seen += 1;
  }
  expect(seen).toBeGreaterThan(1000);
  expect(worst).toBeLessThan(1);
  expect(worst).toBeGreaterThan(1 / 8);
});
