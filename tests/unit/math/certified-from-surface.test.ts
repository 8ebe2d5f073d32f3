import { describe, expect, test } from 'vitest';
import { createAnswers, packRays } from '../../../src/math/batch/batch.ts';
import { type Quadric, quadricOf } from '../../../src/math/batch/quadric.ts';
import * as dy from '../../../src/math/exact/dyadic.ts';
import { findFamily, type Question } from '../../../src/math/families.ts';
import { intersect } from '../../../src/math/intersect.ts';
import {
  AT_SURFACE,
  AT_SURFACE_BOUND,
  CLOSE,
  LARGEST_P,
  OFF_A,
  OFF_B,
  OFF_C,
  OWN,
  SURFACE_BOUNDS,
  type SurfaceNumbers,
  surfaceAroundAxis,
  surfaceInSpace,
  surfaceNumbers,
} from '../../../src/math/methods/certified/from-surface.ts';
import {
  AT_LATTICE,
  certifiedQuadric,
  latticeOf,
  ROUND,
} from '../../../src/math/methods/certified/numbers.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { pick, type Random, randomSign, seeded, uniform } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { climbFromUnits } from './climb.ts';
import { flareOf, unfaithful } from './exact-quadratic.ts';
import { DOUBLES, known, type Off, running } from './running-error.ts';

/*
 * The stage for rays that start on a surface, alone, against exact arithmetic: what it settles is
 * right, and with any of its bounds weakened it is not.
 */

const U = 2 ** -53;
const n = dy.fromNumber;
const out = createAnswers(1);
const log = (random: Random, low: number, high: number): number => 2 ** uniform(random, low, high);
const around = (random: Random, size: number): Vec3 => [
  uniform(random, -size, size),
  uniform(random, -size, size),
  uniform(random, -size, size),
];

interface Asked {
  readonly q: Quadric;
  readonly ray: Ray;
  readonly numbers: SurfaceNumbers;
}

function asked({ shape, ray }: Question): Asked | null {
  const q = quadricOf(shape);
  if (!q || !latticeOf(q)) return null;
  return { q, ray, numbers: surfaceNumbers(q, certifiedQuadric(q)) };
}

/** NaN where the stage leaves the ray open. */
function rootsOf({ q, ray, numbers }: Asked): readonly [number, number] {
  const pass = q.hasY ? surfaceInSpace : surfaceAroundAxis;
  const left = pass(numbers, packRays([ray]), out, Int32Array.of(0), 1);
  return left > 0 ? [Number.NaN, Number.NaN] : [out.t0[0] as number, out.t1[0] as number];
}

type Make = (random: Random) => Question;

interface Tally {
  readonly asked: number;
  readonly settled: number;
  readonly wrong: number;
}

function tally(make: Make, seed: number, count: number, weaken: (a: Asked) => void): Tally {
  const random = seeded(seed);
  let [all, settled, wrong] = [0, 0, 0];
  for (let k = 0; k < count; k++) {
    const a = asked(make(random));
    if (!a) continue;
    const [numbers, bounds] = [a.numbers.slice(), SURFACE_BOUNDS.slice()];
    weaken(a);
    const [t0, t1] = rootsOf(a);
    a.numbers.set(numbers);
    Object.assign(SURFACE_BOUNDS, bounds);
    all += 1;
    if (Number.isNaN(t0)) continue;
    settled += 1;
    if (unfaithful(a.q, a.ray, t0, t1) !== null) wrong += 1;
  }
  return { asked: all, settled, wrong };
}
const asTheyAre = (): void => {};

const SHAPES: readonly [Make0, ...Make0[]] = [
  (random) => ({ kind: 'cylinder', center: [0, 0, 0], radius: uniform(random, 0.3, 2) }),
  (random) => ({ kind: 'cone', vertex: [0, 0, 0], slope: log(random, -2, 2) }),
  (random) => ({
    kind: 'hyperboloid',
    center: [0, 0, 0],
    flare: randomSign(random) * log(random, -3, 3),
    radius: uniform(random, 0.3, 2),
  }),
];
type Make0 = (random: Random) => Shape;
const [, cone, hyperboloid] = SHAPES as unknown as readonly [Make0, Make0, Make0];

/** The radius² of a shape at height h above its centre, exactly. */
const squareAt = (q: Quadric, h: number): dy.Dyadic =>
  dy.add(dy.sqr(n(q.r)), q.hasY ? dy.mul(flareOf(q), dy.sqr(n(h))) : dy.ZERO);

/**
 * A point whose C is far smaller than doubles of its size allow: z is nearly all of the radius, and
 * x, much smaller and so much finer, makes up for the rest.
 */
function verySmallC(random: Random, shape: Shape, height: number): Vec3 {
  const q = quadricOf(shape) as Quadric;
  const square = squareAt(q, height);
  const z = Math.sqrt(Math.max(dy.toNumber(square), 0)) * (1 - log(random, -50, -3));
  const rest = dy.toNumber(dy.sub(square, dy.sqr(n(z))));
  return [randomSign(random) * Math.sqrt(Math.max(rest, 0)), height, z];
}

const smallC: Make = (random) => {
  const shape = pick(random, SHAPES)(random);
  const origin = verySmallC(random, shape, uniform(random, -1, 1));
  return { shape, ray: { origin, direction: around(random, log(random, -20, 20)) } };
};

/** The outward normal at a point about the origin. */
const normalAt = (q: Quadric, [x, y, z]: Vec3): Vec3 => [x, -dy.toNumber(flareOf(q)) * y, z];

/** From a point of the surface, rounded, in a direction that is all but along it. */
const grazing: Make = (random) => {
  const shape = pick(random, SHAPES)(random);
  const q = quadricOf(shape) as Quadric;
  const origin = verySmallC(random, shape, uniform(random, -1, 1));
  const normal = q.hasY ? normalAt(q, origin) : ([origin[0], 0, origin[2]] as const);
  const v = around(random, 1);
  const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const by = dot(v, normal) / dot(normal, normal) - randomSign(random) * log(random, -24, -6);
  const direction = v.map((x, k) => x - by * (normal[k] as number)) as unknown as Vec3;
  return { shape, ray: { origin, direction } };
};

/** From a point of the surface along an asymptote, nearly. */
const steep: Make = (random) => {
  const shape = pick(random, [cone, hyperboloid])(random);
  const q = quadricOf(shape) as Quadric;
  const k =
    Math.sqrt(Math.abs(dy.toNumber(flareOf(q)))) * (1 + randomSign(random) * log(random, -36, -8));
  const phi = uniform(random, 0, 6.3);
  const origin = verySmallC(random, shape, uniform(random, 0.2, 1));
  return { shape, ray: { origin, direction: [k * Math.cos(phi), 1, k * Math.sin(phi)] } };
};

/** From beside the surface, by up to a twentieth of a size. */
const besides = (random: Random, shape: Shape, height: number, bits: number): Question => {
  const [x, y, z] = verySmallC(random, shape, height);
  const origin: Vec3 = [x, y, z * (1 + randomSign(random) * log(random, -bits, -4))];
  return { shape, ray: { origin, direction: around(random, 1) } };
};
const beside: Make = (random) =>
  besides(random, pick(random, SHAPES)(random), uniform(random, -1, 1), 13);

/** On a cone that far up, in sizes; beside it, that near its vertex. */
const farUp: Make = (random) => {
  const shape = cone(random);
  const origin = verySmallC(random, shape, log(random, 4, 14));
  return { shape, ray: { origin, direction: around(random, 1) } };
};
const atVertex: Make = (random) => besides(random, cone(random), log(random, -45, -10), 30);

const family =
  (id: string): Make =>
  (random) => {
    const found = findFamily(id);
    if (!found) throw new Error(`no family ${id}`);
    return found.make(random);
  };

const MAKES: readonly (readonly [string, Make])[] = [
  ['C far below its rounding', smallC],
  ['along the surface', grazing],
  ['along an asymptote', steep],
  ['beside the surface', beside],
  ['far up a cone', farUp],
  ['at a vertex', atVertex],
  ...['near-surface', 'cancellation', 'on-surface', 'typical', 'near-axis', 'near-generator'].map(
    (id) => [id, family(id)] as const,
  ),
  ...['vertex', 'extreme-parameter', 'degenerate', 'scale-ray', 'scale-world', 'generator'].map(
    (id) => [id, family(id)] as const,
  ),
];

describe('what it settles is the right class with faithful roots (seed 71)', () => {
  test.each(MAKES)('%s', (_, make) => {
    expect(tally(make, 71, 3000, asTheyAre).wrong).toBe(0);
  });
  test.each(['near-surface', 'cancellation'])('and 98 of 100 rays of %s', (id) => {
    const found = tally(family(id), 72, 3000, asTheyAre);
    expect(found.settled).toBeGreaterThan(0.98 * found.asked);
  });
});

test('rays in turn, each with a shape of its own: no shape’s numbers serve another one', () => {
  const random = seeded(76);
  for (let k = 0; k < 2000; k++) {
    const { shape, ray } = family('near-surface')(random);
    const [near, far] = intersect(shape, ray).hits;
    const q = quadricOf(shape) as Quadric;
    expect(unfaithful(q, ray, near?.t ?? Number.NaN, far?.t ?? Number.NaN)).toBeNull();
  }
});

const bound = (name: keyof typeof AT_SURFACE_BOUND, by: number) => (): void => {
  const at = AT_SURFACE_BOUND[name];
  Object.assign(SURFACE_BOUNDS, { [at]: by * (SURFACE_BOUNDS[at] as number) });
};
const number =
  (name: keyof typeof AT_SURFACE, by: number) =>
  ({ numbers }: Asked): void => {
    numbers[AT_SURFACE[name]] = by * (numbers[AT_SURFACE[name]] as number);
  };

describe('each bound is needed: with it weakened, what is settled is not always right', () => {
  const weak: readonly (readonly [string, Make, (a: Asked) => void])[] = [
    ['a part in 2^10 of C’s', smallC, number('offC', 2 ** -10)],
    ['of b’s', grazing, number('offB', 2 ** -10)],
    ['of A’s', steep, bound('offOfA', 2 ** -10)],
    ['AC/b² up to 2^-6', beside, bound('close', 2 ** 5)],
    ['P up to 2^31 units', farUp, number('largest', 2 ** 8)],
  ];
  test.each(weak)('%s (seed 73)', (_, make, weaken) => {
    expect(tally(make, 73, 6000, asTheyAre).wrong).toBe(0);
    expect(tally(make, 73, 6000, weaken).wrong).toBeGreaterThan(0);
  });
});

describe('the parts of a shape’s numbers (seed 74)', () => {
  const random = seeded(74);
  const questions = Array.from({ length: 300 }, (): Question => {
    const center = around(random, log(random, -30, 20));
    const shapes: readonly [Shape, ...Shape[]] = [
      { kind: 'cylinder', center, radius: log(random, -20, 20) },
      { kind: 'cone', vertex: center, slope: randomSign(random) * log(random, -20, 20) },
      {
        kind: 'hyperboloid',
        center,
        flare: randomSign(random) * log(random, -20, 20),
        radius: log(random, -20, 20),
      },
    ];
    return { shape: pick(random, shapes), ray: { origin: center, direction: center } };
  });
  const all = questions.map(asked).filter((a): a is Asked => a !== null);
  const sum = (a: Asked, ...names: readonly (keyof typeof AT_SURFACE)[]): dy.Dyadic =>
    names.map((name) => n(a.numbers[AT_SURFACE[name]] as number)).reduce(dy.add);
  const isWhole = (x: number, unit: number): boolean => Number.isInteger(x / unit);

  test('C and r² are told exactly, and on their grids', () => {
    expect(all.length).toBeGreaterThan(200);
    for (const a of all) {
      const { q, numbers } = a;
      const unit = (numbers[AT_SURFACE.cut0] as number) / ROUND;
      expect(dy.compare(sum(a, 'x0', 'x1', 'x2', 'x3'), n(q.Cx))).toBe(0);
      expect(dy.compare(sum(a, 'y0', 'y1', 'y2', 'y3'), n(q.Cy))).toBe(0);
      expect(dy.compare(sum(a, 'z0', 'z1', 'z2', 'z3'), n(q.Cz))).toBe(0);
      expect(dy.compare(sum(a, 'rho0', 'rho1', 'rho2', 'rho3'), dy.sqr(n(q.r)))).toBe(0);
      const at = (name: keyof typeof AT_SURFACE): number => numbers[AT_SURFACE[name]] as number;
      expect(isWhole(at('x0'), unit) && isWhole(at('z0'), unit)).toBe(true);
      expect(isWhole(at('x1'), unit * 2 ** -25) && isWhole(at('x2'), unit * 2 ** -50)).toBe(true);
      expect(isWhole(at('rho0'), unit ** 2)).toBe(true);
      expect(isWhole(at('rho1'), unit ** 2 * 2 ** -24)).toBe(true);
      expect(isWhole(at('rho2'), unit ** 2 * 2 ** -50)).toBe(true);
      expect(isWhole(at('rho3'), unit ** 2 * 2 ** -104)).toBe(true);
    }
  });

  test('√|a| to 2^-130, on its grids', () => {
    for (const a of all) {
      const lattice = latticeOf(a.q);
      const up = lattice?.[AT_LATTICE.up] ?? Number.NaN;
      const k = sum(a, 'k1', 'k2', 'k3', 'k4');
      const size = Math.abs(dy.toNumber(a.q.hasY ? flareOf(a.q) : n(a.q.flare)));
      const square = dy.abs(a.q.hasY ? flareOf(a.q) : n(a.q.flare));
      const off = Math.abs(dy.toNumber(dy.sub(dy.sqr(k), square)));
      expect(off).toBeLessThanOrEqual(2 * size * 2 ** -130);
      const at = (name: keyof typeof AT_SURFACE): number => a.numbers[AT_SURFACE[name]] as number;
      expect(isWhole(at('k1'), up * 2 ** -26) && isWhole(at('k2'), up * 2 ** -52)).toBe(true);
      expect(isWhole(at('k3'), up * 2 ** -77)).toBe(true);
    }
  });
});

describe('what the bounds have to cover', () => {
  const { add, mul } = running(DOUBLES);
  const off = (x: number, by: number): Off => ({ x, off: by });
  const total = (...xs: readonly Off[]): Off => xs.reduce(add);
  const tight = (worst: number, least: number): void => {
    expect(worst).toBeLessThan(1);
    expect(worst).toBeGreaterThan(least);
  };
  /** Lengths in units; P from 32 on, all of them with the signs that make the most of it. */
  const GRID = 2 ** -50;

  test('C, of P', () => {
    const worst = climbFromUnits(seeded(75), 4, (at) => {
      const [x = 0, y = 0, z = 0, up = 0] = at.map(Math.abs);
      const P = 32 * (1 + 2 ** (20 * up));
      const sizes = [x, y, z].map((s) => (P * s) / (x + y + z));
      const [px = 0, K = 0, pz = 0] = sizes;
      const p3 = known(GRID, U);
      const lower = add(
        mul(known(2 ** -27), known(2 * 2 ** -26 + GRID, U)),
        add(mul(known(2 ** -53), known(1)), mul(known(2 ** -78, U), known(2 ** 24, U))),
      );
      const K3 = add(known(GRID / 2), add(mul(known(1), p3), lower));
      // k3p3 and k4p2.
      const rise = off(K3.x, K3.off + 2 * 2 ** -103);
      const round = add(mul(known(px, U), p3), mul(known(pz, U), p3));
      const fifths = add(round, mul(known(K, U), rise));
      const squares = 2 * GRID + 2 ** -48 + GRID / 2;
      const Cl = add(add(fifths, fifths), known(squares));
      const left = 2 * GRID ** 2 + (2 * GRID) ** 2;
      return (total(Cl, known(2 * U)).off + left + 2 * U * Cl.x) / (OFF_C * P);
    });
    tight(worst, 0.75);
  });

  test('b, of S', () => {
    const P = LARGEST_P;
    const h = 2 ** -26;
    const product = (rest: number, xl: Off): Off =>
      add(mul(known(1), known(rest)), mul(xl, known(P, U)));
    // All of d along y, and p3 left out.
    const worst = product(1.63, off(3 * h, 8 * U * h)).off + 2 * GRID + 2 * U * (1.63 + 3 * h * P);
    tight(worst / OFF_B, 0.75);
  });

  test('A, of S²', () => {
    tight((37 * U * 2 ** -26) / OFF_A, 0.9);
  });

  test('what is left out of η', () => {
    const next = ((7 / 256) * CLOSE ** 5 * (1 + CLOSE)) / 2;
    const rounded = (CLOSE / 4) * 20 * U;
    tight((next + rounded) / OWN, 0.6);
  });
});
