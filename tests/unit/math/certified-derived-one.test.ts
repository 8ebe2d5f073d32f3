import { describe, expect, test } from 'vitest';
import { type Quadric, quadricOf } from '../../../src/math/batch/quadric.ts';
import * as algebra from '../../../src/math/methods/certified/algebra.ts';
import { putRoots, QUOTIENT, ROUNDED_Q } from '../../../src/math/methods/certified/doubled.ts';
import * as places from '../../../src/math/methods/certified/hits.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { seeded, uniform } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { climbFromUnits } from './climb.ts';
import { DOUBLES, known, negative, type Off, running, TWICE } from './running-error.ts';

/*
 * As certified-derived.test.ts, for the one ray that is answered with points and normals: upper
 * halves are exact with what they lost, so only sizes count. A lower half is u of its upper one at
 * most, and the products of two lower halves are left out.
 */
const SEED = 62;
const U = 2 ** -53;
const UU = U * U;
const { abs } = Math;
const { add, sub, mul } = running(DOUBLES);
const total = (...xs: readonly Off[]): Off => xs.reduce(add);
/** What a rounded x lost. */
const low = (x: number): Off => known(U * abs(x));

/**
 * The greatest share of a bound is below 1 and above 3/4, for `length` sizes that are 1 together.
 */
function tight(length: number, bound: number, off: (...at: readonly number[]) => number): void {
  const worst = climbFromUnits(seeded(SEED), length, (at) => {
    const all = at.reduce((sum, x) => sum + abs(x), 0);
    return off(...at.map((x) => abs(x) / all));
  });
  expect(worst / bound).toBeLessThan(1);
  expect(worst / bound).toBeGreaterThan(0.75);
}

describe(`lower halves, and what adding them up may cost (seed ${SEED})`, () => {
  /** a·(y·y') of size y, where the lower half of y·y' is `inner`. */
  const flared = (y: number, inner: Off): Off =>
    add(low(y), add(mul(known(1), inner), mul(known(U), known(y))));

  test('A, of Am', () => {
    tight(3, algebra.ERROR_A, (x = 0, y = 0, z = 0) => {
      const A = total(low(x + z), low(x + y + z), add(low(x), low(z)), flared(y, low(y)));
      return A.off + UU * y;
    });
  });

  test('b, of bm', () => {
    /** x·p: its own lower half, and x times p's. */
    const product = (x: number): Off => add(low(x), mul(known(1), low(x)));
    tight(3, algebra.ERROR_B, (x = 0, y = 0, z = 0) => {
      const round = add(product(x), product(z));
      const b = total(low(x + z), low(x + y + z), round, flared(y, product(y)));
      return b.off + 3 * UU * y;
    });
  });

  test('C, of Cm', () => {
    const square = (x: number): Off => add(low(x), mul(known(1), low(2 * x)));
    tight(4, algebra.ERROR_C, (x = 0, y = 0, z = 0, rho = 0) => {
      const sums = total(low(x + z), low(x + y + z), low(x + y + z + rho), low(rho));
      const C = total(sums, add(square(x), square(z)), flared(y, square(y)));
      return C.off + UU * (x + z) + 4 * UU * y;
    });
  });

  test('D/4, of AmCm: the most where b² and |AC| are both of that size', () => {
    const { ERROR_A, ERROR_B, ERROR_C, ERROR_D } = algebra;
    const squared = add(low(1), mul(known(2), low(1)));
    const product = add(low(1), add(mul(known(1), low(1)), low(1)));
    const own = total(low(2), squared, product).off + 2 * UU;
    const share = (own + 2 * ERROR_B + ERROR_A + ERROR_C) / ERROR_D;
    expect(share).toBeLessThan(1);
    expect(share).toBeGreaterThan(0.75);
  });
});

describe(`a Newton step from a faithful root (seed ${SEED})`, () => {
  const twice = running(TWICE);
  const share = (length: number, of: (at: readonly number[]) => number): void => {
    const most = climbFromUnits(seeded(SEED), length, of);
    expect(most).toBeLessThan(1);
    expect(most).toBeGreaterThan(0.6);
  };
  type Three = readonly [Off, Off, Off];
  const three = (at: readonly number[], k: number, relative: number): Three => [
    known(at[k] ?? 0, relative),
    known(at[k + 1] ?? 0, relative),
    known(at[k + 2] ?? 0, relative),
  ];

  test('F of a curved shape', () => {
    share(5, (at) => {
      const [x, y, z] = three(at, 0, 3 * UU);
      const [a, rho] = [known(at[3] ?? 0), known((at[4] ?? 0) ** 2)];
      const round = twice.add(twice.sqr(x), twice.sqr(z));
      const F = twice.sub(twice.sub(round, twice.mul(twice.sqr(y), a)), rho);
      const size = x.x ** 2 + z.x ** 2 + abs(a.x) * y.x ** 2 + rho.x;
      return F.off / (places.ERROR_CURVED * size);
    });
  });

  test("F' of a curved shape", () => {
    share(7, (at) => {
      const [x, y, z] = three(at, 0, U);
      const [dx, dy, dz] = three(at, 3, 0);
      const a = known(at[6] ?? 0, U);
      const rest = mul(a, mul(y, dy));
      const h = sub(add(mul(x, dx), mul(z, dz)), rest);
      const size = abs(x.x * dx.x) + abs(z.x * dz.x) + abs(rest.x);
      // F' is up to a quarter more than 2h, and rounded when A·F/2h is taken away.
      return (2 * h.off + 2.5 * U * abs(h.x)) / (places.ERROR_SLOPE * size);
    });
  });

  test("F and F' of a flat one", () => {
    const dot = (ops: ReturnType<typeof running>, u: Three, v: Three): Off =>
      ops.add(ops.add(ops.mul(u[0], v[0]), ops.mul(u[1], v[1])), ops.mul(u[2], v[2]));
    const size = (u: Three, v: Three): number =>
      abs(u[0].x * v[0].x) + abs(u[1].x * v[1].x) + abs(u[2].x * v[2].x);
    share(6, (at) => {
      const [N, g] = [three(at, 0, 0), three(at, 3, 3 * UU)];
      return dot(twice, N, g).off / (places.ERROR_FLAT * size(N, g));
    });
    share(6, (at) => {
      const [N, d] = [three(at, 0, 0), three(at, 3, 0)];
      return dot(running(DOUBLES), N, d).off / (places.ERROR_FLAT_RATE * size(N, d));
    });
  });

  const taken = places.createStep();
  const { roots } = taken;
  /**
   * t = 1 and a slope of about 1: how much of its bound the step takes if F and F' are off by as
   * much as they may be.
   */
  function step(F: number, offF: number, eta: number): number {
    expect(places.putStep(roots, algebra.NEAR, 1, F, offF, 1, eta)).toBe(eta <= 0.25);
    const [, delta = 0, off = 0] = roots;
    return Math.max(
      ...[-1, 1].flatMap((s) =>
        [-1, 1].map((r) => abs((F + s * offF) / (1 + r * eta) + delta) / off),
      ),
    );
  }
  test.each([
    ['F', 0, 2 ** -54, 0],
    ["F'", 2 * U * 0.75, 0, 0.25],
  ])('off by what %s is, and by no more', (_, F, offF, eta) => {
    const most = step(F, offF, eta);
    expect(most).toBeLessThan(1);
    expect(most).toBeGreaterThan(0.6);
  });
  test('and by rounding it, and the point', () => {
    step(0, 0, 0);
    const covered = (roots[algebra.NEAR + algebra.ROOT_OFF] ?? 0) - places.TINY;
    const onPoint = add(low(0), add(low(1), mul(known(2 * U), known(1)))).off;
    const first = low(1).x + 2 * U;
    const share = (onPoint + U * first + 4 * UU) / covered;
    expect(share).toBeLessThan(1);
    expect(share).toBeGreaterThan(0.75);
  });
  test('where d is nearly along the surface, and the step bends: charged with each part', () => {
    const q = quadricOf({ kind: 'cylinder', center: [0, 0, 0], radius: 1 }) as Quadric;
    const shares = [30, 34, 38, 42].map((k) => {
      // Touches but for 2^-k of the radius; E is on the tangent's side, t = 3.
      const high = Math.sqrt(1 - 2 ** -k);
      const ray: Ray = { origin: [-3 - Math.sqrt(1 - high * high), 0, high], direction: [1, 0, 0] };
      places.stepOnQuadric(taken, q, ray, algebra.NEAR, 3);
      const x = ray.origin[0] + 3;
      const slope = abs(2 * x);
      const offF = places.ERROR_CURVED * (x * x + high * high + 1);
      const bend = 2 * U * 3;
      const offSlope = places.ERROR_SLOPE * abs(x);
      const off = offSlope + (bend * (offSlope + bend)) / slope + offF / slope;
      const bent = abs(2 * x - (taken.place[places.PLACE_F] ?? 0) / (2 * x));
      return (
        (roots[algebra.NEAR + algebra.ROOT_OFF] ?? 0) /
        (offF / bent + 3 * ((2 * U * off) / bent + places.ROUNDED))
      );
    });
    for (const share of shares) expect(share).toBeCloseTo(1, 13);
  });
  test('none where the slope is not known', () => {
    step(U, 0, 0.26);
  });
});

describe(`roots with lower halves, of 1 each (seed ${SEED})`, () => {
  const near = (cost: number, bound: number): void => {
    expect(cost / bound).toBeLessThan(1);
    expect(cost / bound).toBeGreaterThan(0.75);
  };
  const times = (x: Off, relative: number): Off => ({ x: x.x, off: x.off + relative * abs(x.x) });

  test('q = b + √D', () => {
    const worst = climbFromUnits(seeded(SEED), 1, ([at = 0]) => {
      const s = abs(at) % 1;
      // Half of D − s² and of D's lower half over s; the step itself leaves its square over 2s.
      const rest = add(known(2 * U), low(1));
      const step = times({ x: rest.x / 2, off: rest.off / 2 }, U);
      const root = { x: s * step.x, off: s * (step.off + step.x ** 2 / 2) };
      return add(low(1), add(root, low(1 - s))).off;
    });
    near(worst, ROUNDED_Q);
  });

  test('n/m, and the point at that', () => {
    // n − t m is exact, and t = n·(1/m) off by 2u.
    const lower = sub(low(1), negative(mul(known(1), low(1))));
    const rest = add(known(2 * U), lower);
    const step = times(times(rest, 2 * U), U);
    const point = add(low(0), add(low(1), mul(low(1), known(1))));
    near(step.off + U * 2 * U + point.off, QUOTIENT);
  });

  test('each root is charged with what A, b, C and D are off, once', () => {
    const random = seeded(SEED);
    const some = () => uniform(random, -1, 1);
    const numbers = algebra.createAlgebra();
    const roots = algebra.createRoots();
    let asked = 0;
    for (let n = 0; n < 900; n++) {
      const shape: Shape = {
        kind: 'hyperboloid',
        center: [some(), some(), some()],
        flare: some(),
        radius: some() ** 2,
      };
      const ray: Ray = { origin: [3, some(), some()], direction: [-1, some(), some()] };
      algebra.putAlgebra(quadricOf(shape) as Quadric, ray, numbers);
      if (!((numbers[algebra.AT_D] ?? 0) > 0 && putRoots(numbers, roots))) continue;
      asked++;
      const [A, b, C, D] = [algebra.AT_A, algebra.AT_B, algebra.AT_C, algebra.AT_D].map((k) =>
        abs(numbers[k] ?? 0),
      ) as [number, number, number, number];
      const [offA, offB, offC, offD] = numbers.slice(algebra.AT_OFF_A) as unknown as number[];
      const s = Math.sqrt(D);
      const offQ = ((offB ?? 0) + (offD ?? 0) / s) / (b + s);
      const charged = [offQ + (offA ?? 0) / A, offQ + (offC ?? 0) / C];
      const own = ROUNDED_Q + QUOTIENT;
      const shares = [2, 5].map((k) => (roots[k] ?? 0) / abs(roots[k - 2] ?? 0) - own);
      const signs = (numbers[algebra.AT_A] ?? 0) > 0 === (numbers[algebra.AT_B] ?? 0) > 0;
      for (const [k, share] of shares.entries()) {
        const by = charged[signs ? k : 1 - k] as number;
        expect(share / by).toBeCloseTo(1, 6);
      }
    }
    expect(asked).toBeGreaterThan(100);
  });
});
