import { Decimal } from 'decimal.js';
import { describe, expect, test } from 'vitest';
import type { Ray } from '../../../src/math/ray.ts';
import { integer, pick, type Random, seeded, uniform, wide } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import {
  circle,
  cone,
  cylinder,
  exactCoefficients,
  exactly,
  flatDetails,
  hyperboloid,
  plane,
  ray,
  square,
} from './shorthand.ts';

/*
 * `exact` against decimal.js (MIT, the arbitrary-precision library that math.js and others stand
 * on), which shares nothing with it: decimal digits instead of dyadics, the course's formulas
 * written out here by hand (for the shapes of `shapesOf`; every shape is held to its own equation
 * in contract.ts), and so many digits that + − × are exact and a quotient or a root is off
 * by less than any double can notice.
 */

type D3 = [Decimal, Decimal, Decimal];

/** The answers of one ray, every number still a Decimal. */
interface Answer {
  readonly class: string;
  readonly hits: readonly { t: Decimal; point: D3; normal: D3 }[];
  readonly coefficients: readonly [Decimal, Decimal, Decimal];
}

/**
 * `digits`: enough for every sum and product to be exact. A double whose last bit is 2^−e has e
 * digits behind the point, the longest product (c²dy² · c²py² in D) has eight factors, and some
 * more are for the quotients.
 */
function reference(digits: number) {
  const Big = Decimal.clone({ precision: digits, minE: -9e15, maxE: 9e15 });
  /** The double itself: decimal.js would read a number as the shortest text that gives it. */
  function of(x: number): Decimal {
    let [whole, halvings] = [x, 0];
    for (; !Number.isInteger(whole); halvings++) whole *= 2;
    return new Big(BigInt(whole).toString()).div(new Big(2).pow(halvings));
  }
  const of3 = (v: Vec3): D3 => [of(v[0]), of(v[1]), of(v[2])];
  const sub3 = (a: D3, b: D3): D3 => [a[0].sub(b[0]), a[1].sub(b[1]), a[2].sub(b[2])];
  const dot = (a: D3, b: D3): Decimal => a[0].mul(b[0]).add(a[1].mul(b[1])).add(a[2].mul(b[2]));

  /**
   * What is left of a coordinate that should be exactly 0 lies this far below its terms; no double
   * does.
   */
  const noise = new Big(10).pow(-Math.floor(digits / 2));
  const cleaned = (value: Decimal, size: Decimal): Decimal =>
    value.abs().lt(size.mul(noise)) ? new Big(0) : value;

  /** E + t d, a sum that vanishes exactly taken for 0. */
  function pointAt(E: D3, d: D3, t: Decimal): D3 {
    const at = (i: 0 | 1 | 2): Decimal =>
      cleaned(E[i].add(t.mul(d[i])), E[i].abs().add(t.mul(d[i]).abs()));
    return [at(0), at(1), at(2)];
  }

  /** The surface (x−Cx)² + (z−Cz)² = a(y−Cy)² + k(y−Cy) + ρ. */
  function curved(center: Vec3, a: Decimal, rho: Decimal, r: Ray, k = of(0)): Answer {
    const [E, d, C3] = [of3(r.origin), of3(r.direction), of3(center)];
    const p = sub3(E, C3);
    const metric = (u: D3, v: D3): Decimal =>
      u[0].mul(v[0]).add(u[2].mul(v[2])).sub(a.mul(u[1]).mul(v[1]));
    const [A, B, C] = [
      metric(d, d),
      metric(d, p).mul(2).sub(k.mul(d[1])),
      metric(p, p).sub(k.mul(p[1])).sub(rho),
    ];
    const D = B.mul(B).sub(A.mul(C).mul(4));
    const hit = (t: Decimal) => {
      const point = pointAt(E, d, t);
      const n = (i: 0 | 1 | 2): Decimal =>
        cleaned(point[i].sub(C3[i]), point[i].abs().add(C3[i].abs()));
      return { t, point, normal: [n(0), a.neg().mul(n(1)).sub(k.div(2)), n(2)] as D3 };
    };
    const answer = (verdict: string, ts: Decimal[]): Answer => ({
      class: verdict,
      hits: ts.map(hit),
      coefficients: [A, B, C],
    });
    if (A.isZero()) {
      if (!B.isZero()) return answer('one', [C.neg().div(B)]);
      return answer(C.isZero() ? 'contained' : 'none', []);
    }
    if (D.isNegative() && !D.isZero()) return answer('none', []);
    if (D.isZero()) return answer('tangent', [B.neg().div(A.mul(2))]);
    const root = D.sqrt();
    // The root whose terms add, and C over it: no digit is lost even with few of them.
    const q = B.isNegative() ? root.sub(B).div(2) : B.add(root).div(-2);
    const pair = [q.div(A), C.div(q)].sort((s, t) => s.cmp(t));
    return answer('two', pair);
  }

  function flat(N: Vec3, P: Vec3, r: Ray, isInside: (x: D3) => boolean): Answer {
    const [E, d, n] = [of3(r.origin), of3(r.direction), of3(N)];
    const [offset, rate] = [dot(n, sub3(E, of3(P))), dot(n, d)];
    const coefficients = [of(0), rate, offset] as const;
    if (rate.isZero()) {
      return { class: offset.isZero() ? 'contained' : 'none', hits: [], coefficients };
    }
    // rate·X = rate·E − offset·d has no quotient in it, so rim and edge are decided exactly.
    const scaled: D3 = sub3(
      [E[0].mul(rate), E[1].mul(rate), E[2].mul(rate)],
      [d[0].mul(offset), d[1].mul(offset), d[2].mul(offset)],
    );
    const t = offset.neg().div(rate);
    if (!isInside([scaled[0], scaled[1], scaled[2]])) {
      return { class: 'none', hits: [], coefficients };
    }
    return { class: 'one', hits: [{ t, point: pointAt(E, d, t), normal: n }], coefficients };
  }

  function answerOf(shape: Shape, r: Ray): Answer {
    switch (shape.kind) {
      case 'cylinder':
        return curved(shape.center, of(0), of(shape.radius).pow(2), r);
      case 'cone':
        return curved(shape.vertex, of(shape.slope).pow(2), of(0), r);
      case 'hyperboloid':
        return curved(shape.center, of(shape.flare), of(shape.radius).pow(2), r);
      case 'sphere':
        return curved(shape.center, of(-1), of(shape.radius).pow(2), r);
      case 'paraboloid':
        return curved(shape.vertex, of(0), of(0), r, of(shape.width));
      case 'plane':
        return flat(shape.normal, shape.point, r, () => true);
      case 'circle': {
        const rate = dot(of3(shape.normal), of3(r.direction));
        return flat(shape.normal, shape.center, r, (scaled) => {
          const [x, y, z] = of3(shape.center);
          const off = sub3(scaled, [x.mul(rate), y.mul(rate), z.mul(rate)]);
          return dot(off, off).lte(of(shape.radius).mul(rate).pow(2));
        });
      }
      case 'square': {
        const k = 'xyz'.indexOf(shape.axis);
        const N: Vec3 = [k === 0 ? 1 : 0, k === 1 ? 1 : 0, k === 2 ? 1 : 0];
        const rate = dot(of3(N), of3(r.direction));
        const L = of(shape.side).mul(rate.abs());
        return flat(N, shape.corner, r, (scaled) => {
          const sign = rate.isNegative() ? -1 : 1;
          return [0, 1, 2].every((i) => {
            const over = (scaled[i] as Decimal).sub(of(shape.corner[i] ?? 0).mul(rate)).mul(sign);
            return i === k || (over.gte(0) && over.lte(L));
          });
        });
      }
      default:
        throw new RangeError('no formulas written out for this shape');
    }
  }
  return { answerOf, of };
}

/** Correctly rounded by the language: Number() of a decimal text is, however long. */
function double(x: Decimal): number {
  return x.isZero() ? 0 : Number(x.toString());
}

const doubles = ([x, y, z]: D3): number[] => [double(x), double(y), double(z)];

function compare(shape: Shape, r: Ray, answer: Answer): void {
  const found = exactly(shape, r);
  const { A, B, C } = exactCoefficients(shape, r);
  expect({
    shape,
    r,
    class: found.class,
    coefficients: [A, B, C],
    hits: found.hits.map(({ t, point, normal }) => ({ t, point, normal })),
  }).toEqual({
    shape,
    r,
    class: answer.class,
    coefficients: answer.coefficients.map(double),
    hits: answer.hits.map(({ t, point, normal }) => ({
      t: double(t),
      point: doubles(point),
      normal: doubles(normal),
    })),
  });
}

type Component = (random: Random) => number;

interface Range {
  readonly name: string;
  readonly seed: number;
  readonly count: number;
  readonly digits: number;
  readonly x: Component;
}

const RANGES: readonly Range[] = [
  // The last bit is at 2⁻⁵⁰ for most of them and rarely below 2⁻⁶⁵: at most 65 digits a factor,
  // eight factors in D.
  {
    name: 'ordinary numbers, all 53 bits random',
    seed: 271,
    count: 150,
    digits: 800,
    x: (random) => uniform(random, -5, 5),
  },
  {
    name: 'small whole numbers and halves, full of ties and zeros',
    seed: 828,
    count: 150,
    digits: 300,
    x: (random) => integer(random, -6, 6) / 2,
  },
  // The last bit is at 2⁻¹¹² at most: 112 digits a factor behind the point, eight factors in D, and
  // 145 in front.
  {
    name: 'from 1e-18 to 1e18',
    seed: 182,
    count: 40,
    digits: 1500,
    x: (random) => (random() < 0.3 ? integer(random, -1, 1) : wide(random, -60, 60)),
  },
];

function shapesOf(x: () => number, random: Random): Shape[] {
  const v = (): Vec3 => [x(), x(), x()];
  const nonZero = (): Vec3 => {
    const w = v();
    return w.every((c) => c === 0) ? [0, 1, 0] : w;
  };
  const size = () => Math.abs(x());
  return [
    cylinder(v(), size()),
    cone(v(), x()),
    hyperboloid(v(), x(), size()),
    plane(nonZero(), v()),
    circle(nonZero(), v(), size()),
    square(v(), size(), pick(random, ['x', 'y', 'z'])),
    { kind: 'sphere', center: v(), radius: size() },
    { kind: 'paraboloid', vertex: v(), width: x() },
  ];
}

describe.each(RANGES)('$name ($count rays at each shape, seed $seed)', (range) => {
  const { answerOf } = reference(range.digits);
  const random = seeded(range.seed);
  const x = (): number => range.x(random);
  const cases = Array.from({ length: range.count }, () => {
    const d: Vec3 = [x(), x(), x()];
    const r = ray([x(), x(), x()], d.every((c) => c === 0) ? [1, 0, 0] : d);
    return shapesOf(x, random).map((shape) => ({ shape, r, answer: answerOf(shape, r) }));
  }).flat();

  test.each([...new Set(cases.map(({ shape }) => shape.kind))])(
    '%s: class, coefficients, roots, points and normals, bit for bit',
    (kind) => {
      const own = cases.filter(({ shape }) => shape.kind === kind);
      expect(own).toHaveLength(range.count);
      for (const { shape, r, answer } of own) compare(shape, r, answer);
    },
  );

  test('among them are hits and misses of every shape', () => {
    const seen = new Set(cases.map(({ shape, answer }) => `${shape.kind} ${answer.class}`));
    const flat = ['plane one', 'circle one', 'circle none', 'square none'];
    const curved = cases
      .map(({ shape: { kind } }) => kind)
      .filter((kind) => !flat.some((one) => one.startsWith(kind)))
      .flatMap((kind) => [`${kind} two`, `${kind} none`]);
    expect([...seen]).toEqual(expect.arrayContaining([...curved, ...flat]));
  });
});

const NEAR = 314;

test(`rays aimed at the rim, the edge and the silhouette, seed ${NEAR}`, () => {
  const { answerOf } = reference(900);
  const random = seeded(NEAR);
  const seen = new Set<string>();
  for (let i = 0; i < 120; i++) {
    const angle = uniform(random, 0, 2 * Math.PI);
    const r = uniform(random, 0.5, 3);
    const target: Vec3 = [r * Math.cos(angle), uniform(random, -2, 2), r * Math.sin(angle)];
    const E: Vec3 = [uniform(random, 5, 9), uniform(random, 5, 9), uniform(random, 5, 9)];
    const along: Vec3 = [-Math.sin(angle), uniform(random, -1, 1), Math.cos(angle)];
    const towards: Vec3 = [target[0] - E[0], -E[1], target[2] - E[2]];
    const cases: [Shape, Ray][] = [
      [cylinder([0, 0, 0], r), ray(target, along)],
      [circle([0, 1, 0], [0, 0, 0], r), ray(E, towards)],
      [square([target[0], 0, target[2]], r, 'y'), ray(E, towards)],
    ];
    for (const [shape, aimed] of cases) {
      const answer = answerOf(shape, aimed);
      compare(shape, aimed, answer);
      seen.add(`${shape.kind} ${answer.class}`);
    }
  }
  expect([...seen].sort()).toEqual([
    'circle none',
    'circle one',
    'cylinder none',
    'cylinder two',
    'square none',
    'square one',
  ]);
});

test('how far outside: √ of the squares, minus r, to the last bit', () => {
  const { of } = reference(400);
  const random = seeded(NEAR);
  for (let i = 0; i < 200; i++) {
    const [x, z, r] = [uniform(random, -5, 5), uniform(random, -5, 5), uniform(random, 0, 4)];
    const down = ray([x, 3, z], [0, -1, 0]);
    const found = exactly(circle([0, 2, 0], [0, 0, 0], r), down);
    const far = of(x).pow(2).add(of(z).pow(2)).sqrt().sub(of(r));
    expect(flatDetails(found).plane?.distance).toBe(far.gt(0) ? double(far) : 0);
    const beside = exactly(square([0, 0, 0], r, 'y'), down);
    const over = (u: number) =>
      [of(0), of(u).neg(), of(u).sub(of(r))].reduce((a, b) => (b.gt(a) ? b : a));
    const corner = over(x).pow(2).add(over(z).pow(2)).sqrt();
    expect(flatDetails(beside).plane?.distance).toBe(double(corner));
  }
});
