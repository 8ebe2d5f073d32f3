import { describe, expect, test } from 'vitest';
import { packRays } from '../../../src/math/batch/batch.ts';
import type { Planar } from '../../../src/math/batch/planar.ts';
import { DIRECT_ERROR, momentError } from '../../../src/math/methods/certified/class.ts';
import { FAITHFUL, GRID_25, GRID_26 } from '../../../src/math/methods/certified/numbers.ts';
import * as figure from '../../../src/math/methods/certified/planar.ts';
import * as flat from '../../../src/math/methods/certified/planar.ts';
import { createTwice, rootInTwice } from '../../../src/math/methods/certified/planar.ts';
import { seeded } from '../../../src/math/rng.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { ERROR as DEPARTS } from '../../../src/tracer/departs.ts';
import { climbFromUnits } from './climb.ts';
import {
  type Arithmetic,
  DOUBLES,
  known,
  type Off,
  running,
  size,
  TWICE,
} from './running-error.ts';

/*
 * Each bound of the certified stages against what its operations may add up to: a directed search
 * for the rays where that is most stays below it, and comes nearer than half. So a bound that is
 * cut by half is seen here, even where no ray is known that breaks it.
 */
const SEED = 61;
const U = 2 ** -53;
const UU = U * U;
const { abs } = Math;
const doubles = running(DOUBLES);
const twice = running(TWICE);

/** The greatest share of a bound is below 1, and above `least`. */
function tight(
  length: number,
  share: (at: readonly number[]) => number,
  least = 0.5,
  starts = 20,
): void {
  const worst = climbFromUnits(seeded(SEED), length, share, starts);
  expect(worst).toBeLessThan(1);
  expect(worst).toBeGreaterThan(least);
}

const n = (at: readonly number[], k: number): number => at[k] as number;
type Three = readonly [Off, Off, Off];
const three = (at: readonly number[], k: number, off = 0): Three => [
  known(n(at, k), off),
  known(n(at, k + 1), off),
  known(n(at, k + 2), off),
];
const sum = (v: Three): number => abs(v[0].x) + abs(v[1].x) + abs(v[2].x);
const cross = ({ sub, mul }: Arithmetic, [a, b, c]: Three, [x, y, z]: Three): Three => [
  sub(mul(b, z), mul(c, y)),
  sub(mul(c, x), mul(a, z)),
  sub(mul(a, y), mul(b, x)),
];

/** A, b, C and the sizes that their errors are measured by. */
function quadratic(ops: Arithmetic, d: Three, p: Three, a: Off, rho: Off) {
  const { add, sub, mul } = ops;
  const form = ([x, y, z]: Three, [u, v, w]: Three): Off =>
    sub(add(mul(x, u), mul(z, w)), mul(mul(a, y), v));
  const amount = (u: Three, v: Three): number =>
    abs(u[0].x * v[0].x) + abs(u[2].x * v[2].x) + abs(a.x * u[1].x * v[1].x);
  return {
    A: form(d, d),
    b: form(d, p),
    C: sub(form(p, p), rho),
    Am: amount(d, d),
    bm: amount(d, p),
    Cm: amount(p, p) + rho.x,
  };
}

describe(`in doubles, a bound and what its operations may add up to (seed ${SEED})`, () => {
  const { add, sub, mul, sqr } = doubles;

  test('A and D/4 directly: of Am and AmCm', () => {
    const of = (at: readonly number[]) => {
      const rho = known(n(at, 7) ** 2, U);
      return quadratic(doubles, three(at, 0), three(at, 3, U), known(4 * n(at, 6), U), rho);
    };
    tight(8, (at) => {
      const { A, b, C, Am, Cm } = of(at);
      return sub(sqr(b), mul(A, C)).off / (DIRECT_ERROR * Am * Cm);
    });
    // A has a share in that; whether it may be 0 is asked with the same constant.
    tight(8, (at) => of(at).A.off / (DIRECT_ERROR * of(at).Am), 0.1);
  });

  test('which way a ray departs: b and A', () => {
    const ay = (at: readonly number[]): Off => mul(known(4 * n(at, 6), U), known(n(at, 1)));
    tight(7, (at) => {
      const [d, p] = [three(at, 0), three(at, 3, U)];
      const rest = mul(ay(at), p[1]);
      const b = sub(add(mul(d[0], p[0]), mul(d[2], p[2])), rest);
      return b.off / (DEPARTS * (abs(d[0].x * p[0].x) + abs(d[2].x * p[2].x) + abs(rest.x)));
    });
    tight(7, (at) => {
      const d = three(at, 0);
      const rest = mul(ay(at), d[1]);
      const A = sub(add(sqr(d[0]), sqr(d[2])), rest);
      return A.off / (DEPARTS * (d[0].x ** 2 + d[2].x ** 2 + abs(rest.x)));
    });
  });

  /** D/4 by the moment, in units in which |a| = 1. */
  const byMoment = (d: Three, p: Three, sign: number, rho: Off): number => {
    const k = known(1, U);
    const [x, y, z] = [d[0], mul(k, d[1]), d[2]];
    const m = cross(doubles, [x, y, z], [p[0], mul(k, p[1]), p[2]]);
    const A = sub(add(sqr(x), sqr(z)), mul(known(sign), sqr(y)));
    const round = add(sqr(m[0]), sqr(m[2]));
    const D = sub(add(mul(rho, A), { ...round, x: sign * round.x }), sqr(m[1]));
    return (
      D.off /
      momentError(sum(d) * sum(p), sum(m), rho.x * (d[0].x ** 2 + d[1].x ** 2 + d[2].x ** 2))
    );
  };
  test('D/4 by the moment: of what m is', () => {
    tight(7, (at) => byMoment(three(at, 0), three(at, 3, U), n(at, 6) > 0 ? 1 : -1, known(0)));
  });
  test('of ρA', () => {
    tight(4, (at) =>
      byMoment(three(at, 0), three([0, 0, 0], 0), n(at, 3) > 0 ? 1 : -1, known(1, U)),
    );
  });
  test('of S² where the line meets the centre and m cancels', () => {
    tight(4, (at) => {
      const d = three(at, 0);
      const p: Three = [known(2 * d[0].x, U), known(2 * d[1].x, U), known(2 * d[2].x, U)];
      return byMoment(d, p, n(at, 3) > 0 ? 1 : -1, known(0));
    });
  });

  test('how far inside a circle: w, and the squares', () => {
    tight(
      9,
      (at) => {
        const [d, p, N] = [three(at, 0), three(at, 3, U), three(at, 6)];
        const m = cross(doubles, d, p);
        const w = cross(doubles, m, N);
        const e = sum(N) * (figure.CIRCLE_S * sum(d) * sum(p) + figure.CIRCLE_M * sum(m));
        return Math.max(w[0].off, w[1].off, w[2].off) / e;
      },
      0.8,
    );
    tight(
      9,
      (at) => {
        const [d, p, N] = [three(at, 0), three(at, 3, U), three(at, 6)];
        const m = cross(doubles, d, p);
        const M = sum(m) / (sum(d) * sum(p));
        const w = cross(doubles, m, N);
        const e = sum(N) * (figure.CIRCLE_S * sum(d) * sum(p) + figure.CIRCLE_M * sum(m));
        return M > 0.1 ? 0.1 - M / 100 : Math.max(w[0].off, w[1].off, w[2].off) / e;
      },
      0.55,
    );
    tight(4, (at) => {
      const reach = mul(known(1), known(n(at, 0), 2 * U));
      const w = three(at, 1);
      const D = sub(sqr(reach), add(add(sqr(w[0]), sqr(w[1])), sqr(w[2])));
      return (
        D.off / (figure.CIRCLE_SQUARES * (reach.x ** 2 + w[0].x ** 2 + w[1].x ** 2 + w[2].x ** 2))
      );
    });
  });

  test('how far inside a square', () => {
    tight(5, (at) => {
      const [dn, du, L] = [known(n(at, 0)), known(n(at, 1)), known(4 * abs(n(at, 4)))];
      const [pn, pu] = [known(n(at, 2), U), known(n(at, 3), U)];
      const [a, b] = [mul(dn, pu), mul(du, pn)];
      const w = sub(a, b);
      const turned = dn.x < 0 ? { ...w, x: -w.x } : w;
      const inside = sub(mul(L, { ...dn, x: abs(dn.x) }), turned);
      const asked = inside.x < turned.x ? inside : turned;
      return asked.off / (figure.SQUARE_S * (abs(a.x) + abs(b.x)));
    });
  });
});

describe(`a flat shape's root on grids, before it is rounded (seed ${SEED})`, () => {
  const { add, mul } = doubles;
  const onGrid = (x: number, grid: number): number => x + grid - grid;
  const all = ([x, y, z]: Vec3): number => abs(x) + abs(y) + abs(z);
  /**
   * v but for its last component, which lets N·v cancel to LEAST_SHARE of its terms, or a little
   * more.
   */
  const level = (N: Vec3, v: Vec3, by: number): Vec3 => {
    const rest = N[0] * v[0] + N[1] * v[1];
    return [v[0], v[1], (-rest / N[2]) * (1 + 99 * by * flat.LEAST_SHARE)];
  };

  /** N·v in two parts, the first of them exact. */
  function dot(N: Vec3, v: Vec3, lost: number) {
    const n = N.map((x) => onGrid(x, GRID_25 * all(N)));
    const h = v.map((x) => onGrid(x, GRID_26 * all(v)));
    // What the grids leave over is half a unit of theirs at most, whatever these vectors leave.
    const lower = known(U * GRID_26 * all(v), lost);
    const rest = known(U * GRID_25 * all(N));
    const high = (k: 0 | 1 | 2): Off => known(abs(n[k] as number));
    const of = (k: 0 | 1 | 2): Off => known(abs(v[k]), lost);
    const first = add(add(mul(high(0), lower), mul(high(1), lower)), mul(high(2), lower));
    const second = add(add(mul(rest, of(0)), mul(rest, of(1))), mul(rest, of(2)));
    const exact = [0, 1, 2].reduce((sum, k) => sum + (n[k] as number) * (h[k] as number), 0);
    const value = N[0] * v[0] + N[1] * v[1] + N[2] * v[2];
    return { high: exact, low: add(first, second), value };
  }

  function share(N: Vec3, d: Vec3, p: Vec3): number {
    const [r, o] = [dot(N, d, 0), dot(N, p, U)];
    const [rate, offset] = [r.value, o.value];
    const kept =
      abs(rate) > flat.LEAST_SHARE * all(N) * all(d) &&
      abs(offset) > flat.LEAST_SHARE * all(N) * all(p);
    if (!kept) return 0;
    const coarse = -offset / rate;
    const th = onGrid(coarse, GRID_25 * coarse);
    const rh = onGrid(r.high, GRID_26 * rate);
    const half = known(U * GRID_26 * abs(rate));
    const lower = add(o.low, mul(known(abs(th)), add(half, r.low)));
    const rest = add(known(abs(o.high + th * rh)), lower);
    const step = mul(rest, known(1 / rate, 2 * U + r.low.off / abs(rate)));
    return step.off / (FAITHFUL * abs(coarse));
  }

  const vectors = (at: readonly number[]): readonly [Vec3, Vec3, Vec3] => [
    [n(at, 0), n(at, 1), n(at, 2)],
    [n(at, 3), n(at, 4), n(at, 5)],
    [n(at, 6), n(at, 7), n(at, 8)],
  ];
  test('where N·d cancels', () => {
    tight(
      10,
      (at) => {
        const [N, d, p] = vectors(at);
        return share(N, level(N, d, n(at, 9)), p);
      },
      0.4,
    );
  });
  test('where N·p cancels', () => {
    tight(
      10,
      (at) => {
        const [N, d, p] = vectors(at);
        return share(N, d, level(N, p, n(at, 9)));
      },
      0.4,
    );
  });
  test('where both do', () => {
    tight(10, (at) => {
      const [N, d, p] = vectors(at);
      return share(N, level(N, d, n(at, 9)), level(N, p, n(at, 9)));
    });
  });
});

describe(`in twice the digits (seed ${SEED})`, () => {
  const { mul, add, exactly } = twice;

  test('N·p / N·d of the second stage: where neither cancels, and where one of them does', () => {
    const share = (N: Three, d: Three, p: Three): number => {
      const dot = (v: Three, times: typeof mul): Off =>
        add(add(times(N[0], v[0]), times(N[1], v[1])), times(N[2], v[2]));
      const [rate, offset] = [dot(d, exactly), dot(p, mul)];
      const off = rate.off / abs(rate.x) + offset.off / abs(offset.x) + 9.8 * UU;
      const s = {
        N: N.map(({ x }) => x),
        P: [0, 0, 0],
        bound: 'none',
        size: 0,
      } as unknown as Planar;
      const numbers = (v: Three) => v.map(({ x }) => x) as unknown as Vec3;
      const rays = packRays([{ origin: numbers(p), direction: numbers(d) }]);
      return off / rootInTwice(s, rays, 0, createTwice());
    };
    const level = (N: Three, v: Three, by: number): Three => [
      v[0],
      v[1],
      known((-(N[0].x * v[0].x + N[1].x * v[1].x) / N[2].x) * (1 + by)),
    ];
    const vectors = (at: readonly number[]) => [three(at, 0), three(at, 3), three(at, 6)] as const;
    tight(9, (at) => share(...vectors(at)), 0.8);
    tight(
      9,
      (at) => {
        const [N, d, p] = vectors(at);
        return share(N, level(N, d, 2 ** -20), p);
      },
      0.7,
    );
    tight(
      9,
      (at) => {
        const [N, d, p] = vectors(at);
        return share(N, d, level(N, p, 2 ** -20));
      },
      0.7,
    );
  });
});

test('size counts what a number is off', () => {
  expect(size(known(-2, 0.5))).toBe(3);
});
