import { describe, expect, test } from 'vitest';
import { createFound, T0, T1 } from '../../../src/math/methods/certified/found.ts';
import {
  CUT,
  CUT_ORIGIN,
  CUT_TIME,
  coefficientsPass,
  createGrid,
  ERROR,
  GRID_A,
  GRID_B,
  GRID_C,
  GRID_D,
  GRID_DX,
  GRID_DY,
  GRID_DZ,
  GRID_OFF_D,
  GRID_OFF_X,
  GRID_OFF_Y,
  GRID_OFF_Z,
  GRID_REACH_D,
  GRID_REACH_P,
  POINT,
  rootsPass,
} from '../../../src/math/methods/certified/grids.ts';
import { AT_SCALED } from '../../../src/math/methods/certified/numbers.ts';
import { seeded } from '../../../src/math/rng.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { climbFromUnits } from './climb.ts';
import { DOUBLES, known, type Off, running } from './running-error.ts';

/*
 * As certified-derived.test.ts, for the parts on grids. What is exact there is so by the grids,
 * which is asserted first; of the rest only sizes count, all of them with the signs that make the
 * most of it. |dx|, k|dy|, |dz| are D = 1 together, and so are those of p, for P.
 */
const SEED = 63;
const U = 2 ** -53;
/** What is left of a number of 1 beside its upper half, of 26 bits. */
const HALF = 2 ** -26;
const { abs } = Math;
const { add, mul } = running(DOUBLES);
const total = (...xs: readonly Off[]): Off => xs.reduce(add);
/** What a grid leaves over: half of its step, next to σ + 1. */
const left = (cut: number): number => (cut + 1) * U;
const beside = left(CUT);

type Sizes = readonly [number, number, number];

/**
 * How many of the grid's steps 1 is at most: with three roundings, and what k1 y1 is more than k y.
 */
const steps = (cut: number): number => 1 / ((cut - 1) * U) + 4;

describe('what the grids make exact, and no finer or coarser than that', () => {
  test('sums of three products of parts of d and E − C', () => {
    expect(steps(CUT) ** 2).toBeLessThan(2 ** 53);
    expect(steps(CUT / 2) ** 2).toBeGreaterThan(2 ** 53);
  });
  test('26 bits of A times the part of t', () => {
    expect(2 ** 26 * steps(CUT_TIME)).toBeLessThan(2 ** 53);
    expect(2 ** 26 * steps(CUT_TIME / 2)).toBeGreaterThan(2 ** 53);
  });
  test('E + t d', () => {
    expect(steps(CUT) * steps(CUT_TIME)).toBeLessThan(2 ** 53);
    expect(steps(CUT_ORIGIN)).toBeLessThan(2 ** 53);
    expect(steps(CUT_ORIGIN / 2)).toBeGreaterThan(2 ** 53);
    // And what is left of E is nothing beside what is left of d and t.
    expect(left(CUT_ORIGIN)).toBeLessThan(2 ** -24 * beside);
  });
});

/** What is left of k y beside the grid: what y itself lacks is `lost`. k2 is rounded once. */
function rise(y: number, lost = known(0)): Off {
  const [k1, k2] = [known(1), known(HALF, U)];
  return add(known(beside), add(mul(k1, add(known(HALF * y), lost)), mul(k2, known(y))));
}
/** The same of x − Cx, whose rounding is added. */
const from = (x: number): Off => add(known(beside), known(U * x));

const parts = {
  A: ([x, y, z]: Sizes): number => {
    const flat = (v: number): Off => mul(known(beside), add(known(v), known(v)));
    const yl = rise(y);
    return total(flat(x), flat(z), mul(yl, total(known(y), yl, known(y)))).off;
  },
  b: (d: Sizes, p: Sizes): number => {
    const flat = (v: number, w: number): Off =>
      add(mul(known(v), from(w)), mul(known(beside), known(w, U)));
    const pl = rise(p[1], known(U * p[1]));
    const y = add(mul(known(d[1]), pl), mul(rise(d[1]), add(known(p[1]), pl)));
    return add(add(flat(d[0], p[0]), flat(d[2], p[2])), y).off;
  },
  /** ρ up to 2P²: beyond that it is C itself that is large. */
  C: ([x, y, z]: Sizes): number => {
    const flat = (v: number): Off => mul(from(v), add(known(v, U), known(v)));
    const pl = rise(y, known(U * y));
    const high = mul(pl, total(known(y), pl, known(y)));
    return total(flat(x), flat(z), high, add(known(3 * U), known(2 * U))).off;
  },
};

/** What D/4 is off by itself, and by what the others are. */
function offD(A: number, b: number, C: number, offs: Sizes): number {
  const rest = (x: number): Off => add(known(HALF * x), known(U * x));
  const square = mul(rest(b), add(known(b), known(b)));
  const product = add(mul(known(A), rest(C)), mul(rest(A), known(C)));
  const own = add(known(U * (b * b + A * C)), add(square, product)).off;
  // The factors of the rests are doubles without theirs.
  const without = HALF * U * (b * b + A * C);
  return own + without + 2 * b * offs[1] + A * offs[2] + C * offs[0];
}

/** Three sizes that are 1 together. */
function three(at: readonly number[], first: number): Sizes {
  const [x = 0, y = 0, z = 0] = at.slice(first, first + 3).map(abs);
  const all = x + y + z;
  return [x / all, y / all, z / all];
}

function tight(length: number, share: (at: readonly number[]) => number, least = 0.75): void {
  const worst = climbFromUnits(seeded(SEED), length, share);
  expect(worst).toBeLessThan(1);
  expect(worst).toBeGreaterThan(least);
}

describe(`what the coefficients may be off by (seed ${SEED})`, () => {
  test('A, of D²', () => tight(3, (at) => parts.A(three(at, 0)) / ERROR));
  test('b, of DP', () => tight(6, (at) => parts.b(three(at, 0), three(at, 3)) / ERROR));
  test('C, of P²', () => tight(3, (at) => parts.C(three(at, 0)) / ERROR, 0.9));
  test('D/4, of 2|b|DP + |A|P² + |C|D²', () => {
    tight(
      9,
      (at) => {
        const [A, b, C] = [6, 7, 8].map((k) => Math.min(1, abs(at[k] ?? 0))) as unknown as Sizes;
        const [d, p] = [three(at, 0), three(at, 3)];
        const offs: Sizes = [parts.A(d), parts.b(d, p), parts.C(p)];
        return offD(A, b, C, offs) / (ERROR * (2 * b + A + C));
      },
      0.9,
    );
  });
  test('A where it cancels: half of it', () => {
    const worst = climbFromUnits(seeded(SEED), 2, ([x = 0, z = 0]) =>
      parts.A(three([x, Math.hypot(x, z), z], 0)),
    );
    expect(worst).toBeLessThan(ERROR / 2);
  });
});

describe(`what a point may be off by (seed ${SEED})`, () => {
  /** √ of 1: D − s² is exact but for two roundings of (s − sh)(s + sh), and halved. */
  const root = mul(known(HALF), add(known(1), known(1))).off / 2;

  /**
   * E + t d and what is left of it, of L, where A = 1 and d has one component; a normal's component
   * adds the rounding of C.
   */
  function own(): number {
    const [A, t, one] = [known(1), known(left(CUT_TIME)), known(1)];
    const restOfA = add(known(HALF), known(U));
    const lower = add(known(U), add(mul(A, t), mul(restOfA, one)));
    // At th + b ± √, of which only what follows is left.
    const upper = U * (lower.x + 2 * U);
    const residual = add(lower, known(2 * U)).off + upper + root;
    const rest = add(t, known(2 * U, 2 * U));
    const along = add(mul(one, known(beside)), mul({ x: rest.x, off: rest.off + residual }, one));
    const low = add(known(left(CUT_ORIGIN)), along);
    return add(known(U), low).off;
  }

  const grid = createGrid();
  const found = createFound();
  const putRoots = rootsPass(grid, found);
  /** OFF_X and the like of d = (x, y, z) and A = b = D/4 = 1, |d| = 1. */
  function offs(E: Vec3, t: readonly [number, number], P: number, off = 0, d: Vec3 = [1, 1, 1]) {
    grid.fill(0);
    for (const k of [GRID_A, GRID_D, GRID_REACH_D]) grid[k] = 1;
    [grid[GRID_DX], grid[GRID_DY], grid[GRID_DZ]] = d;
    grid[GRID_REACH_P] = P;
    grid[GRID_OFF_D] = off;
    [found[T0], found[T1]] = t;
    putRoots({ origin: E, direction: d });
    return [GRID_OFF_X, GRID_OFF_Y, GRID_OFF_Z].map((k) => grid[k] ?? 0);
  }
  const most = (length: number, share: (at: readonly number[]) => number): number =>
    climbFromUnits(seeded(SEED), length, share);
  const ofA = most(3, (at) => parts.A(three(at, 0)));
  const ofB = most(6, (at) => parts.b(three(at, 0), three(at, 3)));

  const near = (share: number, least = 0.75): void => {
    expect(share).toBeLessThan(1);
    expect(share).toBeGreaterThan(least);
  };

  test('by itself, of L', () => near(own() / POINT, 0.9));
  test.each<[string, Vec3, [number, number]]>([
    ['Ex', [-1, 0, 0], [0, 0]],
    ['Ey', [0, -1, 0], [0, 0]],
    ['Ez', [0, 0, -1], [0, 0]],
    ['the near t', [0, 0, 0], [-1, 0]],
    ['the far t', [0, 0, 0], [0, -1]],
  ])('with what A is off, where L is %s', (_, E, t) => {
    for (const off of offs(E, t, 0)) near((own() + ofA) / off);
  });
  test('by b and the rest of √, which is one of b at most', () => {
    for (const off of offs([0, 0, 0], [0, 0], 1)) near((ofB + root) / off);
  });
  test('by D/4', () => {
    for (const off of offs([0, 0, 0], [0, 0], 0, 1)) near(1 / 2 / (1.01 * off), 0.9);
  });
  test('over A, times d, and E itself where d is 0', () => {
    const [x = 0, y = 0, z = 0] = offs([1, 0, 0], [0, 0], 2 ** 40, 0, [-0.5, 1, 0]);
    expect(y / x).toBeCloseTo(2, 9);
    expect(z).toBe(0);
    expect(offs([1, 1, 1], [1, 1], 1, 1, [0, 0, 0])).toEqual([0, 0, 0]);
  });
});

describe(`D/4, where one of A, b and C is all there is`, () => {
  const grid = createGrid();
  const put = coefficientsPass(grid);
  /** ρ = 0 and k = 1. */
  const numbers = new Float64Array(Object.keys(AT_SCALED).length);
  for (const key of ['k', 'k1', 'sign', 'flare', 'wide'] as const) numbers[AT_SCALED[key]] = 1;
  test.each<[string, Vec3, Vec3, number]>([
    ['A', [0, 0, 1], [1, 1, 0], GRID_A],
    ['b', [1, 1, 0], [1, -1, 0], GRID_B],
    ['C', [1, 1, 0], [0, 0, 1], GRID_C],
  ])('%s', (_, d, p, which) => {
    put(numbers, { origin: p, direction: d });
    const values = [GRID_A, GRID_B, GRID_C].map((k) => abs(grid[k] ?? 0));
    expect(values.filter((x) => x !== 0)).toEqual([grid[which]]);
    const [A = 0, b = 0, C = 0] = values;
    const [D, P] = [grid[GRID_REACH_D] ?? 0, grid[GRID_REACH_P] ?? 0];
    const off = grid[GRID_OFF_D] ?? 0;
    expect(off).toBe(ERROR * (2 * b * D * P + A * P * P + C * D * D));
    expect(off).toBeGreaterThan(0);
  });
});
