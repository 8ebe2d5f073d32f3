import { describe, expect, test } from 'vitest';
import { quadricOf } from '../../../src/math/batch/quadric.ts';
import { SMALLEST_D } from '../../../src/math/methods/certified/class.ts';
import {
  AT_LATTICE as AT,
  GRID_P,
  latticeOf,
  UNIT_OF_DIRECTION,
} from '../../../src/math/methods/certified/numbers.ts';
import * as far from '../../../src/math/methods/certified/recentred.ts';
import * as root from '../../../src/math/methods/certified/refined.ts';
import { SLACK, SLACK_A } from '../../../src/math/methods/certified/units.ts';

/*
 * Constants that are far more cautious than any ray shows: each against the count of its own
 * derivation, step by step as the comment beside it has them. So none may be weakened without the
 * derivation, which no wrong answer would betray.
 */
const U = 2 ** -53;
const sum = (steps: readonly number[]): number => steps.reduce((a, b) => a + b, 0);

/**
 * What q is off, in reaches: t·dl, tl·d, their sum and pl for x and z; for y what k's lower half
 * and the larger sum add.
 */
const offQ = 2 ** -75 * sum([3, 3, 10]);
/**
 * What f is off, in widths and sizes: ql, the bracket, the product, three sums, k, fh; and q twice.
 */
const offF = 2 ** -73 * sum([1, 1, 1, 3, 1, 1]) + 2 * offQ;

describe('recentred', () => {
  /** ql·d and qh·dl at six operations, and δq·d. */
  const offB = 6 * 2 ** -74 + offQ;
  test('SLOPE_ERROR covers what b is off, CROSS_ERROR twice that and what f is off', () => {
    expect(far.SLOPE_ERROR).toBeGreaterThanOrEqual(offB);
    expect(far.CROSS_ERROR).toBeGreaterThanOrEqual(Math.max(2 * offB, offF));
  });
  test('with NARROW it covers 2|q||δq| where the leading parts are 0', () => {
    expect(far.CROSS_ERROR * far.NARROW_RECENTRED).toBeGreaterThanOrEqual(2 * offQ * 3 * 2 ** -23);
  });
  test('SQUARE_ERROR covers 2u of b and of its square, RESIDUAL_ERROR 2u of f, 9u of A', () => {
    expect(far.SLOPE_SQUARE_ERROR).toBeGreaterThanOrEqual(sum([2, 2]) * U);
    expect(far.RESIDUAL_SHARE).toBeGreaterThanOrEqual(sum([2, 9, 2]) * U);
  });
  test('GRID_P leaves of p 2^-46 of the reach', () => {
    expect(GRID_P * 2 ** -52).toBeLessThanOrEqual(2 ** -46);
  });
});

describe('root by root', () => {
  test('RESIDUAL_ERROR covers the error of f, with NARROW where the leading parts are 0', () => {
    expect(root.RESIDUAL_ERROR).toBeGreaterThanOrEqual(offF);
    expect(root.RESIDUAL_ERROR * root.NARROW_REFINED).toBeGreaterThanOrEqual(
      2 * offQ * 3 * (2 ** -22 + 2 ** -45),
    );
  });
  test('CLEAR makes √D known to 2^-18, and STEP keeps A f below 2^-17 of D', () => {
    expect(1 / (2 * root.CLEAR_REFINED)).toBeLessThanOrEqual(2 ** -18);
    expect(root.STEP_SHARE).toBeLessThanOrEqual(2 ** -17);
  });
  test('APART keeps what b is off, 8u of S, below 2^-7 of √D', () => {
    expect((8 * U) / Math.sqrt(root.APART)).toBeLessThanOrEqual(2 ** -7);
  });
  test('GRID_P and SPREAD keep the rounding of the rest of p below 1/16 of the unit', () => {
    expect(GRID_P * 2 ** -52 * U * root.SPREAD).toBeLessThanOrEqual(2 ** -75 / 16);
  });
});

test('SMALLEST_D is above what is lost to underflow', () => {
  expect(SMALLEST_D).toBeGreaterThanOrEqual(2 ** -1074 * 2 ** 600);
});

describe('ordinary rays', () => {
  const shape = (x: number, radius: number, flare: number) =>
    quadricOf({ kind: 'hyperboloid', center: [x, 0, 0], flare, radius });
  const lattice = (x: number, radius = 1, flare = 1) => {
    const q = shape(x, radius, flare);
    return q && latticeOf(q);
  };
  test('SLACK covers the larger step without Am/|A| and reach: divisor 6u, f 3u, 4u', () => {
    expect(SLACK).toBeGreaterThanOrEqual(sum([6, 3, 4]) * U);
    expect(SLACK_A).toBeGreaterThanOrEqual(3.5 * U);
  });
  test('|d| has 2^4 units at least: roots within 2^24 of the centre are below 2^21 apart', () => {
    const least = Math.sqrt(lattice(0)?.[AT.smallestDirection] ?? 0) / UNIT_OF_DIRECTION;
    expect((2 * 2 ** 24) / least).toBeLessThanOrEqual(2 ** 21);
  });
  test('centres over 2^45 units of 2^-17, stretches over 2^30, sizes over 2^60 are out', () => {
    expect(lattice(2 ** 27.9)).not.toBeNull();
    expect(lattice(2 ** 28)).toBeNull();
    expect(lattice(0, 1, 2 ** 58)).not.toBeNull();
    expect(lattice(0, 1, 2 ** 62)).toBeNull();
    expect(lattice(0, 2 ** 60)).not.toBeNull();
    expect(lattice(0, 2 ** 61)).toBeNull();
  });
});
