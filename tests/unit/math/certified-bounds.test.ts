import { describe, expect, test } from 'vitest';
import { exact } from '../../../src/math/arithmetic/exact.ts';
import { packRays } from '../../../src/math/batch/batch.ts';
import { planarOf } from '../../../src/math/batch/planar.ts';
import { quadricOf } from '../../../src/math/batch/quadric.ts';
import type { Surd } from '../../../src/math/exact/surd.ts';
import { findFamily } from '../../../src/math/families.ts';
import { evaluateTriple } from '../../../src/math/formula/evaluate.ts';
import {
  AT_A as A,
  AT_B as B,
  AT_C as C,
  createAlgebra,
  AT_D as D,
  AT_OFF_A as OFF,
  putAlgebra,
} from '../../../src/math/methods/certified/algebra.ts';
import {
  createTwice,
  marginsOf,
  rootInTwice,
  TWICE_T,
  TWICE_T_LOW,
} from '../../../src/math/methods/certified/planar.ts';
import { valuesOf } from '../../../src/math/methods/tree-method.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { integer, type Random, seeded, uniform } from '../../../src/math/rng.ts';
import type { CurvedFormula } from '../../../src/math/shapes/axial-quadric.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';

/*
 * The bounds that certify, against the true errors in exact arithmetic: the error never exceeds its
 * bound, and for some rays it is a stated share of it at least, so that a bound does not grow
 * unnoticed. The figure's is so sharp that cutting it to an eighth breaks it.
 */

const { add, sub, mul, sqr, sign, of } = exact;
const size = (x: Surd): Surd => (sign(x) < 0 ? exact.neg(x) : x);
/** |got − truth| / bound; the sum of `got` is exact. */
const share = (got: readonly number[], truth: Surd, bound: number): number =>
  exact.toNumber(exact.div(size(sub(got.map(of).reduce(add), truth)), of(bound)));

const vector = (random: Random, scale = 1): Vec3 => [
  uniform(random, -scale, scale),
  uniform(random, -scale, scale),
  uniform(random, -scale, scale),
];
const lean = (random: Random, by: number): Vec3 => {
  const k = integer(random, 0, 2);
  return [0, 1, 2].map((i) => (i === k ? 1 : by) * uniform(random, -1, 1)) as unknown as Vec3;
};
const along = (random: Random, d: Vec3, t: number, off: number): Vec3 =>
  d.map((x) => -t * x + off * uniform(random, -1, 1)) as unknown as Vec3;

const dot = (a: readonly Surd[], b: readonly Surd[]): Surd =>
  a.map((x, i) => mul(x, b[i] as Surd)).reduce(add);
const cross = (a: readonly Surd[], b: readonly Surd[]): [Surd, Surd, Surd] => {
  const minor = (i: number, j: number): Surd =>
    sub(mul(a[i] as Surd, b[j] as Surd), mul(a[j] as Surd, b[i] as Surd));
  return [minor(1, 2), minor(2, 0), minor(0, 1)];
};

interface Flat {
  readonly shape: Shape;
  readonly ray: Ray;
}

/**
 * Lines through circles and squares, from near and far, straight and slanted, most of them beside
 * the rim.
 */
function figures(random: Random, kind: 'circle' | 'square', count: number): Flat[] {
  return Array.from({ length: count }, (_, i) => {
    const direction = i % 3 === 0 ? lean(random, 2 ** -30) : vector(random);
    const far = i % 2 === 0 ? uniform(random, 0.1, 2) : 2 ** uniform(random, 1, 40);
    const at = vector(random);
    const origin = along(random, direction, far, i % 2).map(
      (x, k) => x + (at[k] ?? 0),
    ) as unknown as Vec3;
    const normal = i % 5 === 0 ? lean(random, 2 ** -30) : vector(random);
    return {
      shape:
        kind === 'circle'
          ? { kind, normal, center: at, radius: uniform(random, 0, 2) }
          : {
              kind,
              corner: at,
              side: 2 ** (i % 4 ? uniform(random, -2, 1) : uniform(random, 1, 50)),
              axis: (['x', 'y', 'z'] as const)[i % 3] ?? 'x',
            },
      ray: { origin, direction },
    };
  });
}

/** The greatest share of its bound that the error of the margin has. */
function worstMargin(questions: readonly Flat[]): number {
  let worst = 0;
  for (const { shape, ray } of questions) {
    const s = planarOf(shape);
    if (!s) throw new Error(`a flat shape is needed, got ${shape.kind}`);
    const { origin: E, direction: d } = ray;
    const N = s.N.map(of);
    const p = E.map((x, i) => sub(of(x), of(s.P[i] as number)));
    const rate = dot(N, d.map(of));
    if (sign(rate) === 0) continue;
    const w = cross(cross(d.map(of), p), N);
    const margin = Float64Array.of(exact.toNumber(rate));
    const bound = new Float64Array(1);
    marginsOf(s)(s, packRays([ray]), 0, 1, margin, bound);
    const reach = mul(of(s.size), size(rate));
    const turned = w.map((x) => (sign(rate) < 0 ? exact.neg(x) : x));
    const [u, v] = [turned[s.u] as Surd, turned[s.v] as Surd];
    const least = (a: Surd, b: Surd): Surd => (sign(sub(a, b)) < 0 ? a : b);
    const truth =
      s.bound === 'circle'
        ? sub(sqr(reach), dot(w, w))
        : [u, sub(reach, u), v, sub(reach, v)].reduce(least);
    worst = Math.max(worst, share([...margin], truth, bound[0] as number));
  }
  return worst;
}

describe('how far inside a figure', () => {
  test.each(['circle', 'square'] as const)('%s (seed 51)', (kind) => {
    const worst = worstMargin(figures(seeded(51), kind, 6000));
    expect(worst).toBeLessThan(1);
    expect(worst).toBeGreaterThan(1 / 7);
  });
});

test('a square of which a product falls below the doubles', () => {
  const shape: Shape = { kind: 'square', corner: [0, 0, 0], side: 1, axis: 'x' };
  const direction: Vec3 = [2 ** -500 * 1.1, 0, 0];
  const low = Array.from({ length: 50 }, (_, k) => 2 ** -560 * (1 + k / 7));
  expect(
    worstMargin(low.map((y) => ({ shape, ray: { origin: [1, y, y], direction } }))),
  ).toBeLessThan(1);
});

test('N·p / N·d in double-double, however much of both cancels (seed 52)', () => {
  const random = seeded(52);
  let worst = 0;
  const twice = createTwice();
  for (let k = 0; k < 6000; k++) {
    const normal = vector(random);
    // d and p nearly at right angles to N: two coordinates at random, the third one makes up for
    // them but for some bits.
    const level = (): Vec3 => {
      const [x, y] = [uniform(random, -1, 1), uniform(random, -1, 1)];
      const z = -(normal[0] * x + normal[1] * y) / normal[2];
      return [x, y, z * (1 + (random() < 0.3 ? 0 : 2 ** -uniform(random, 5, 52)))];
    };
    const [d, E] = [level(), level()];
    const P: Vec3 = k % 2 ? [0, 0, 0] : [2 ** -60, 0, 2 ** -57];
    const s = planarOf({ kind: 'plane', normal, point: P });
    if (!s) throw new Error('no plane');
    const off = rootInTwice(s, packRays([{ origin: E, direction: d }]), 0, twice);
    const N = normal.map(of);
    const rate = dot(N, d.map(of));
    const offset = dot(
      N,
      E.map((x, i) => sub(of(x), of(P[i] as number))),
    );
    if (!(off < 2 ** -20)) continue;
    const t = exact.neg(exact.div(offset, rate));
    const got = [twice[TWICE_T] as number, twice[TWICE_T_LOW] as number];
    worst = Math.max(worst, exact.toNumber(exact.div(of(share(got, t, 1)), size(t))) / off);
  }
  expect(worst).toBeLessThan(1);
  expect(worst).toBeGreaterThan(1 / 16);
});

test('A, b, C and D/4 of curved shapes in twice the digits (seed 53)', () => {
  const random = seeded(53);
  const algebra = createAlgebra();
  const worst = [0, 0, 0, 0];
  for (const id of [
    'typical',
    'near-axis',
    'far-origin',
    'near-tangent',
    'near-surface',
    'extreme-parameter',
  ]) {
    for (let k = 0; k < 600; k++) {
      const { shape, ray } = findFamily(id)?.make(random) ?? { shape: undefined, ray: undefined };
      const q = shape && quadricOf(shape);
      if (!q || !ray) continue;
      putAlgebra(q, ray, algebra);
      const values = valuesOf(shape, ray, exact);
      const formula = definitionOf(shape).formula(shape) as CurvedFormula;
      const [a, twoB, c] = evaluateTriple([formula.A, formula.B, formula.C], exact, values);
      const b = mul(twoB, of(0.5));
      [a, b, c, sub(sqr(b), mul(a, c))].forEach((truth, i) => {
        const at = [A, B, C, D][i] as number;
        const got = [algebra[at] as number, algebra[at + 1] as number];
        worst[i] = Math.max(worst[i] as number, share(got, truth, algebra[OFF + i] as number));
      });
    }
  }
  for (const most of worst) {
    expect(most).toBeLessThan(1);
    expect(most).toBeGreaterThan(1 / 32);
  }
});
