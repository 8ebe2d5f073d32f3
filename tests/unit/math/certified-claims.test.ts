import { describe, expect, test } from 'vitest';
import { createAnswers, packRays } from '../../../src/math/batch/batch.ts';
import { type Quadric, quadricOf } from '../../../src/math/batch/quadric.ts';
import * as dy from '../../../src/math/exact/dyadic.ts';
import * as surd from '../../../src/math/exact/surd.ts';
import {
  AT_LATTICE as AT,
  type Lattice,
  latticeOf,
} from '../../../src/math/methods/certified/numbers.ts';
import {
  BLOCK,
  CERTAIN,
  createScratch,
  ordinaryRootsWith,
} from '../../../src/math/methods/certified/units.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { pick, seeded, uniform } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { climb } from './climb.ts';
import { solved } from './exact-quadratic.ts';
import {
  about,
  exactA,
  grazing,
  KINDS,
  type Kind,
  log,
  type Numbers,
  quarter,
  questionOf,
} from './in-a-row.ts';
import { roughLike } from './stage-models.ts';

/*
 * What the comments of pass 1 say of its rough values, at those values themselves
 * (stage-models.ts): a search looks for the ray on which each is worst. So a limit that lets more
 * rays through than its derivation allows is seen, long before a root is wrong.
 */

const U = 2 ** -53;

interface Rough {
  readonly q: Quadric;
  readonly ray: Ray;
  readonly lattice: Lattice;
  readonly model: ReturnType<typeof roughLike>;
}

function roughly(kind: Kind, x: Numbers): Rough | null {
  const { shape, ray } = questionOf(kind, x);
  const q = quadricOf(shape) as Quadric;
  const lattice = latticeOf(q);
  if (!lattice || !x.every(Number.isFinite)) return null;
  return { q, ray, lattice, model: roughLike(q, lattice, ray) };
}

const n = dy.fromNumber;
/** |got − truth| / bound. */
const share = (got: number, truth: dy.Dyadic, bound: number): number =>
  Math.abs(dy.toNumber(dy.sub(n(got), truth))) / bound;

const at = (lattice: Lattice, name: keyof typeof AT): number => lattice[AT[name]] as number;

describe('pass 1 (seed 201)', () => {
  test.each(KINDS)('%s: D is known as well as a miss needs it, and not by much better', (kind) => {
    const random = seeded(201);
    const worst = climb(random, {
      start: () =>
        pick(random, [
          () => about(random),
          () => grazing(kind, random, log(random, -40, -4), uniform(random, -9, 9)),
        ])(),
      score: (x) => {
        const rough = roughly(kind, x);
        if (!rough?.model.fits) return 0;
        const { D, Q } = rough.model;
        return share(D, quarter(rough.q, rough.ray), -CERTAIN * Q);
      },
      starts: 100,
      steps: 300,
    });
    expect(worst).toBeLessThan(1);
    expect(worst).toBeGreaterThan(1 / 8);
  });

  test.each(KINDS)('%s: √D of a clear hit is known to 2^-29', (kind) => {
    const random = seeded(202);
    const worst = climb(random, {
      start: () => grazing(kind, random, log(random, -20, -6), log(random, -2, 6)),
      score: (x) => {
        const rough = roughly(kind, x);
        if (!rough?.model.clear) return 0;
        const { root } = rough.model;
        const exact = surd.surd(dy.ZERO, dy.ONE, dy.ONE, quarter(rough.q, rough.ray));
        const off = surd.toNumber(surd.sub(surd.fromNumber(root), exact));
        return Math.abs(off / root) / 2 ** -29;
      },
      starts: 25,
      steps: 300,
    });
    expect(worst).toBeLessThan(1);
    expect(worst).toBeGreaterThan(1 / 16);
  });

  test.each(KINDS)('%s: A of a clear hit is known to 200u', (kind) => {
    const random = seeded(203);
    const worst = climb(random, {
      start: () => {
        const x = about(random);
        const phi = uniform(random, 0, 6.3);
        const steep =
          (kind === 'cone' ? Math.abs(x[3] as number) : Math.sqrt(Math.abs(x[3] as number))) *
          (1 + 2 ** -uniform(random, 3, 12));
        return [...x.slice(0, 8), steep * Math.cos(phi), 1, steep * Math.sin(phi)];
      },
      score: (x) => {
        const rough = roughly(kind, x);
        if (!rough?.model.clear) return 0;
        const { A } = rough.model;
        return share(A, exactA(rough.q, rough.ray), 200 * U * Math.abs(A));
      },
      starts: 25,
      steps: 300,
    });
    expect(worst).toBeLessThan(1);
    expect(worst).toBeGreaterThan(kind === 'cylinder' ? 1 / 200 : 1 / 4);
  });
});

test.each(KINDS)(
  '%s: a rough root is off by less than 2^-7 units of t, however long the ray is inside (seed 204)',
  (kind) => {
    const random = seeded(204);
    const worst = climb(random, {
      start: () => {
        // From so far that D is hardly clear; high up, and about as slow as is allowed.
        const far = log(random, 0, 9.5);
        const off = Math.min(far * far * log(random, -21, -17), 0.9);
        const x = grazing(kind, random, off, far);
        const center = x.slice(0, 3);
        const high = kind === 'cylinder' ? 1 : log(random, 0, 7);
        const origin = x.slice(5, 8).map((e, k) => (e - (center[k] as number)) * high);
        const slow = log(random, -5, 0) / Math.hypot(...x.slice(8));
        return [0, 0, 0, ...x.slice(3, 5), ...origin, ...x.slice(8).map((d) => d * slow)];
      },
      score: (x) => {
        const rough = roughly(kind, x);
        if (!rough?.model.clear) return 0;
        const { q, ray, lattice, model } = rough;
        const unit = at(lattice, 'two') / 2;
        const roots = solved(q, ray).roots;
        const { near, far } = model;
        const size = at(lattice, 'largestSize');
        if (Math.hypot(...ray.direction) * (far - near) > 4 * size) return 0;
        const off = [near, far].map((t, k) =>
          Math.abs(surd.toNumber(surd.sub(surd.fromNumber(t), roots[k] as surd.Surd))),
        );
        return Math.max(...off) / unit / 2 ** -7;
      },
      starts: 30,
      steps: 200,
    });
    expect(worst).toBeLessThan(1);
    expect(worst).toBeGreaterThan(2 ** -14);
  },
);

test('a cone asked from close to its vertex: what underflows decides nothing (seed 205)', () => {
  const random = seeded(205);
  const wrong: unknown[] = [];
  let fits = 0;
  for (let k = 0; k < 6000; k++) {
    const tiny = 2 ** uniform(random, -545, -480);
    const x = about(random).map((v, i) => (i < 3 ? 0 : i > 4 && i < 8 ? v * tiny : v));
    const rough = roughly('cone', x);
    if (!rough?.model.fits) continue;
    fits += 1;
    const sign = dy.sign(quarter(rough.q, rough.ray));
    const { clear, missed } = rough.model;
    if ((clear && sign < 0) || (missed && sign >= 0)) wrong.push(x);
  }
  expect(fits).toBeGreaterThan(5000);
  expect(wrong).toEqual([]);
});

describe('the largest and the smallest shapes that are ordinary (seed 206)', () => {
  /** The power of two farthest from 0 in steps of `by` for which the shape is still ordinary. */
  const edge = (by: number, shape: (power: number) => Shape): number => {
    let k = 0;
    while (Math.abs(k) < 1000 && latticeOf(quadricOf(shape(2 ** (k + by))) as Quadric)) k += by;
    return k;
  };
  const center = [0, 0, 0] as const;
  const cylinder = (radius: number): Shape => ({ kind: 'cylinder', center, radius });
  const hyperboloid = (flare: number): Shape => ({ kind: 'hyperboloid', center, flare, radius: 1 });
  const sizes = [edge(1, cylinder), edge(-1, cylinder)];
  const flares = [edge(2, hyperboloid), edge(-2, hyperboloid)];

  const unit = latticeOf(quadricOf(cylinder(1)) as Quadric) as Lattice;
  const fastest = 2 ** (Math.log2(at(unit, 'largestDirection')) / 2 - 6);

  const out = createAnswers(BLOCK);
  const scratch = createScratch();
  const ordinaryRoots = ordinaryRootsWith(scratch);
  /** Roots, over `unit`, and what is left to others. */
  function answers(q: Quadric, rays: readonly Ray[], unit: number): number[] {
    out.t0.fill(-1);
    out.t1.fill(-1);
    ordinaryRoots(latticeOf(q) as Lattice, q.hasY, packRays(rays), out, 0, rays.length);
    return [...scratch.count, ...[...out.t0, ...out.t1].map((t) => (t === -1 ? t : t / unit))];
  }

  test.each(KINDS)(
    '%s: the same bits as in the middle, and in the middle many are settled',
    (kind) => {
      const random = seeded(206);
      for (let round = 0; round < 20; round++) {
        const fixed = about(random).slice(0, 5);
        const speed = round % 2 ? 1 : fastest;
        const drawn = Array.from({ length: BLOCK }, () => [
          ...[...fixed, ...about(random).slice(5, 8)],
          ...about(random)
            .slice(8)
            .map((d) => d * speed),
        ]);
        const rays = (scale: (x: Numbers) => Numbers) =>
          drawn.map((x) => questionOf(kind, scale(x)).ray);
        const shape = (scale: (x: Numbers) => Numbers) =>
          quadricOf(questionOf(kind, scale(drawn[0] as number[])).shape) as Quadric;
        const middle = answers(
          shape((x) => x),
          rays((x) => x),
          1,
        );
        if (speed === 1) {
          expect((middle[1] as number) + (middle[2] as number)).toBeLessThan((3 * BLOCK) / 4);
        }
        // A cone has no size of its own.
        for (const size of kind === 'cone' ? [0] : sizes) {
          for (const flare of kind === 'cylinder' ? [0] : flares) {
            // Exponents of the drawn numbers themselves are within these of 0.
            const length = 2 ** (size - 2 * Math.sign(size));
            const up = 2 ** (flare / 2 - 4 * Math.sign(flare));
            const lengths = [length, length / up, length];
            const flares = kind === 'cone' ? up : up * up;
            const factors = [...lengths, flares, length, ...lengths, 1, 1 / up, 1];
            const scale = (x: Numbers): Numbers => x.map((v, i) => v * (factors[i] as number));
            expect(answers(shape(scale), rays(scale), length)).toEqual(middle);
          }
        }
      }
    },
  );
});
