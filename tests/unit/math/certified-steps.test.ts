import { describe, expect, test } from 'vitest';
import { createAnswers, packRays } from '../../../src/math/batch/batch.ts';
import { type Quadric, quadricOf } from '../../../src/math/batch/quadric.ts';
import * as dy from '../../../src/math/exact/dyadic.ts';
import { AT_LATTICE as AT, latticeOf } from '../../../src/math/methods/certified/numbers.ts';
import {
  coarseInSpace,
  createScratch,
  HITS,
  SHARE,
  SLACK,
  SLACK_A,
  SLACK_G,
  solvePass,
  UNSETTLED,
} from '../../../src/math/methods/certified/units.ts';
import { type Random, randomSign, seeded, uniform } from '../../../src/math/rng.ts';
import { climb } from './climb.ts';
import { form } from './exact-quadratic.ts';

/*
 * Pass 3 on quadratics whose roots are known: A(t − a − δa)(t − b − δb). With a = 0 the root is the
 * step itself, not rounded to a larger number, and shows the step's own error.
 */

const U = 2 ** -53;
const scratch = createScratch();
const solve = solvePass(scratch);
const out = createAnswers(1);
const lattice = new Float64Array(Object.keys(AT).length);
lattice[AT.two] = 2;
lattice[AT.largestSize] = Number.POSITIVE_INFINITY;
const ordinary = latticeOf(
  quadricOf({ kind: 'cylinder', center: [0, 0, 0], radius: 1 }) as Quadric,
) as Float64Array;
/** In units of t. */
const LEAST_GAP = (2 * (ordinary[AT.leastGap] as number)) / (ordinary[AT.two] as number);
lattice[AT.leastGap] = LEAST_GAP;

interface Known {
  readonly A: number;
  readonly a: number;
  readonly b: number;
  readonly stepA: number;
  readonly stepB: number;
  /** What pass 1 and 2 may have instead of A and g, as factors. */
  readonly ofA?: number;
  readonly ofG?: number;
  readonly ofSlope?: number;
  readonly slack?: number;
  readonly offNear?: number;
}

const n = dy.fromNumber;

/** f at t, rounded once. */
function valueAt({ A, a, b, stepA, stepB }: Known, t: number): number {
  const from = (root: number, step: number): dy.Dyadic => dy.sub(dy.sub(n(t), n(root)), n(step));
  return dy.toNumber(dy.mul(n(A), dy.mul(from(a, stepA), from(b, stepB))));
}

/** Half the slope at a, rounded once. */
function slopeAt({ A, a, b, stepA, stepB }: Known): number {
  const sum = dy.add(dy.add(n(stepA), n(b - a)), n(stepB));
  return dy.toNumber(dy.neg(dy.shift(dy.mul(n(A), sum), -1)));
}

/** The roots that pass 3 certifies; null if it does not. */
function solved(known: Known): readonly [number, number] | null {
  const { A, a, b, stepA, stepB, slack = 0, offNear = 0 } = known;
  const { ofA = 1, ofG = 1, ofSlope = 1 } = known;
  const slope = 0.5 * A * (b + stepB - a - stepA) * ofSlope;
  const put = (array: Float64Array, x: number): void => {
    array[0] = x;
  };
  put(scratch.A, A * ofA);
  put(scratch.slope, slope);
  put(scratch.half, 0.5 / slope);
  put(scratch.slack, slack);
  put(scratch.wholeNear, a);
  put(scratch.wholeFar, b);
  put(scratch.fNear, valueAt(known, a) + offNear);
  put(scratch.fFar, valueAt(known, b));
  put(scratch.g, slopeAt(known) * ofG);
  put(scratch.reach, 0);
  put(scratch.spread, 0);
  put(scratch.spreadFar, 0);
  scratch.count[HITS] = 1;
  scratch.count[UNSETTLED] = 0;
  solve(lattice, out);
  if (scratch.count[UNSETTLED] === 1) return null;
  return [out.t0[0] as number, out.t1[0] as number];
}

function anyKnown(random: Random): Known {
  const gap = Math.round(uniform(random, LEAST_GAP, 5000));
  const step = (): number => uniform(random, -0.5, 0.5);
  const A = randomSign(random) * uniform(random, 1, 4) * 2 ** 24;
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
      // A as pass 1 may have it, 4u; g 6u; √D as it is known there.
      const ofA = 1 + 4 * U * randomSign(random);
      const ofG = 1 + 6 * U * randomSign(random);
      const ofSlope = 1 + 2 ** -29.2 * randomSign(random);
      worst = Math.max(worst, stepError({ ...anyKnown(random), ofA, ofG, ofSlope }));
    }
    const charged = SLACK_A + SLACK + SLACK_G / 2;
    expect(worst).toBeLessThan(charged);
    expect(worst).toBeGreaterThan(charged / 3);
  });

  test("a step's own roundings are charged by SLACK, which is not much more", () => {
    const random = seeded(65);
    const worst = climb(random, {
      start: () => {
        const { A, a, b, stepA, stepB } = anyKnown(random);
        return [A, b - a, stepA, stepB];
      },
      score: ([A = 1, gap = 0, stepA = 0, stepB = 0]) => {
        const b = Math.round(gap);
        const allowed = b >= LEAST_GAP && Math.abs(stepA) <= 0.51 && Math.abs(stepB) <= 0.51;
        return allowed ? stepError({ A, a: 0, b, stepA, stepB }) : 0;
      },
      starts: 30,
      steps: 300,
    });
    expect(worst).toBeLessThan(SLACK);
    expect(worst).toBeGreaterThan(SLACK / 4);
  });

  test('an error of g alone moves a step by no more than is charged, and not by much less', () => {
    const random = seeded(64);
    let worst = 0;
    for (let k = 0; k < 20000; k++) {
      const known = anyKnown(random);
      const before = solved(known);
      const after = solved({ ...known, ofG: 1 + 2 ** -30 });
      if (!before || !after) continue;
      const [i, step] = known.a === 0 ? [0 as const, known.stepA] : [1 as const, known.stepB];
      worst = Math.max(worst, Math.abs((after[i] - before[i]) / step) / 2 ** -30);
    }
    // 6u of reach become SLACK_G/2 of the step.
    expect(worst).toBeLessThan(SLACK_G / 2 / (6 * U));
    expect(worst).toBeGreaterThan(0.9);
  });

  test('an error of f moves the steps by no more than is charged, and not by much less', () => {
    const random = seeded(62);
    let own = 0;
    let shared = 0;
    for (let k = 0; k < 20000; k++) {
      const known = {
        ...anyKnown(random),
        a: 0,
        b: Math.round(uniform(random, LEAST_GAP, 3 * LEAST_GAP)),
      };
      const off = 2 ** -26 * known.A;
      const before = solved(known);
      const after = solved({ ...known, offNear: off });
      if (!before || !after) continue;
      const charge = off / (known.A * (known.b + known.stepB - known.stepA));
      own = Math.max(own, Math.abs(after[0] - before[0]) / Math.abs(charge));
      shared = Math.max(shared, Math.abs(after[1] - before[1]) / Math.abs(charge));
    }
    expect(own).toBeLessThan(1.1);
    expect(own).toBeGreaterThan(1);
    expect(shared).toBeLessThan(SHARE);
    expect(shared).toBeGreaterThan(SHARE / 2);
  });

  const steady: Known = { A: 2 ** 30, a: 0, b: 1024, stepA: 0.25, stepB: 0.25 };
  test('an error of half the distance to the next double is too much, for either root', () => {
    expect(solved({ ...steady, slack: 0.8 * 2 ** -54 })).toEqual([0.25, 1024.25]);
    expect(solved({ ...steady, slack: 2 ** -54 })).toBeNull();
    const mirrored: Known = { ...steady, a: -1024, b: 0 };
    expect(solved({ ...mirrored, slack: 0.8 * 2 ** -54 })).toEqual([-1023.75, 0.25]);
    expect(solved({ ...mirrored, slack: 2 ** -54 })).toBeNull();
  });

  test('the gap must be much larger than a step can be', () => {
    expect(solved({ ...steady, b: LEAST_GAP })).not.toBeNull();
    expect(solved({ ...steady, b: LEAST_GAP - 1 })).toBeNull();
  });

  test('what is not a number is not certified', () => {
    expect(solved({ ...steady, slack: Number.NaN })).toBeNull();
    expect(solved({ ...steady, b: 0, stepB: -0.25 })).toBeNull();
    expect(solved({ ...steady, ofA: Number.POSITIVE_INFINITY })).toBeNull();
  });
});

test('A is known as well as pass 1 says, and not much better where A cancels (seed 63)', () => {
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
    const A = n(scratch.A[0] as number);
    const off = Math.abs(dy.toNumber(dy.sub(A, exact)) / dy.toNumber(exact));
    const charged = (scratch.slack[0] as number) - SLACK;
    worst = Math.max(worst, off / charged);
    seen += 1;
  }
  expect(seen).toBeGreaterThan(1000);
  expect(worst).toBeLessThan(1);
  expect(worst).toBeGreaterThan(1 / 8);
});
