import { describe, expect, test } from 'vitest';
import * as dy from '../../../src/math/exact/dyadic.ts';
import { seeded, uniform } from '../../../src/math/rng.ts';
import {
  type Asked,
  any,
  asked,
  beside,
  farther,
  recentred,
  rootByRoot,
  type Share,
  type Start,
  shareOfD,
  shareOfRoot,
  shareOfSteps,
  steep,
  through,
  worst,
} from './far-stages.ts';
import { about, grazing, KINDS, log, quarter } from './in-a-row.ts';
import type { Off } from './running-error.ts';

interface Verdicts {
  readonly clear: boolean;
  readonly missed: boolean;
}

describe.each(KINDS)('%s (seed 216)', (kind) => {
  test('A of a clear hit is known to 2^-30', () => {
    const known = ({ model: { clear, A } }: Asked<{ clear: boolean; A: Off }>): number =>
      clear ? A.off / Math.abs(A.x) / 2 ** -30 : 0;
    for (const share of [
      worst(recentred, kind, steep, known, 216),
      worst(rootByRoot, kind, steep, known, 216),
    ]) {
      expect(share).toBeLessThan(1);
      expect(share).toBeGreaterThan(kind === 'cylinder' ? 2 ** -24 : 1 / 16);
    }
  });

  test('what is charged for a settled root is less than half an ulp', () => {
    const half = (t: number): number => 2 ** -54 * Math.abs(t);
    const recentredShare: Share<ReturnType<typeof recentred>> = ({ model }) => {
      const { clear, settled, off, near, far } = model;
      return clear && settled ? off / half(Math.min(Math.abs(near), Math.abs(far))) : 0;
    };
    const refinedShare: Share<ReturnType<typeof rootByRoot>> = ({ model }) => {
      const { clear, settled, a, b, ra, rb } = model;
      return clear && settled ? Math.max(a.error / half(ra), b.error / half(rb)) : 0;
    };
    for (const share of [
      worst(recentred, kind, any, recentredShare, 221),
      worst(rootByRoot, kind, beside, refinedShare, 222),
    ]) {
      expect(share).toBeLessThan(1);
      expect(share).toBeGreaterThan(1 / 16);
    }
  });

  test('what is settled was off by less than half of the distance to the next double', () => {
    const settled: Share<ReturnType<typeof recentred>> = ({ model }) => {
      const { clear, settled, around, near, far } = model;
      const place = 2 ** -54 * Math.min(Math.abs(near), Math.abs(far));
      return clear && settled ? around.off / place : 0;
    };
    const share = worst(recentred, kind, any, settled, 217);
    expect(share).toBeLessThan(1);
    expect(share).toBeGreaterThan(1 / 4);
  });
});

test('a cone asked from close to its vertex: what underflows decides nothing (seed 218)', () => {
  const random = seeded(218);
  const wrong: unknown[] = [];
  for (let k = 0; k < 3000; k++) {
    const tiny = 2 ** uniform(random, -545, -480);
    const drawn =
      k % 2 ? about(random) : grazing('cone', random, (k % 4 ? 1 : -1) * log(random, -50, -2), 1);
    const x = drawn.map((v, i) => {
      if (i < 3) return 0;
      return i > 4 && i < 8 ? (v - (k % 2 ? 0 : (drawn[i - 5] as number))) * tiny : v;
    });
    for (const stage of [recentred, rootByRoot]) {
      const { q, ray, model } = asked<Verdicts>(stage, 'cone', x) as Asked<Verdicts>;
      const sign = dy.sign(quarter(q, ray));
      if ((model.clear && sign < 0) || (model.missed && sign >= 0)) wrong.push(x);
    }
  }
  expect(wrong).toEqual([]);
});

describe.each(KINDS)('%s, root by root (seed 231)', (kind) => {
  test('√D of a clear hit is known to 2^-18', () => {
    const hardly: Start = (_, r) => grazing(kind, r, log(r, -34, -24), log(r, -2, 3));
    const share = worst(rootByRoot, kind, hardly, shareOfRoot, 231);
    expect(share).toBeLessThan(1);
    expect(share).toBeGreaterThan(kind === 'cone' ? 1 / 512 : 1 / 32);
  });

  test('D of lines nearly through the middle, from near and far', () => {
    const near = worst(rootByRoot, kind, through(-1, 6), shareOfD, 232);
    const far = worst(rootByRoot, kind, through(28, 44), shareOfD, 233);
    expect(Math.max(near, far)).toBeLessThan(1);
    expect(near).toBeGreaterThan(1 / 16);
    expect(far).toBeGreaterThan(1 / 64);
  });
});

test("Newton's step from as far as it is taken (seed 234)", () => {
  const shares = KINDS.map((kind) => worst(rootByRoot, kind, through(32, 40), shareOfSteps, 234));
  expect(Math.max(...shares)).toBeLessThan(1);
  expect(Math.max(...shares)).toBeGreaterThan(1 / 16);
});

test("Newton's step is the root's but for what is charged (seed 215)", () => {
  const shares = KINDS.map((kind) => worst(rootByRoot, kind, farther, shareOfSteps, 215));
  expect(Math.max(...shares)).toBeLessThan(1);
  expect(Math.max(...shares)).toBeGreaterThan(1 / 64);
});
