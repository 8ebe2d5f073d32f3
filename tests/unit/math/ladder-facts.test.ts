import { describe, expect, test } from 'vitest';
import { exact as exactly } from '../../../src/math/arithmetic/exact.ts';
import { DISCRIMINANT } from '../../../src/math/formula/common.ts';
import { evaluate } from '../../../src/math/formula/evaluate.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { type Random, seeded, uniform } from '../../../src/math/rng.ts';
import { drawJudged, judged, medianBits, method, score, wrongShare } from './measure.ts';

/*
 * What the methods get wrong, measured: the failures that the ladder is there to show. If one of
 * them goes away, or grows, a formula has changed.
 */

const share = (id: string, family: string, difficulty?: number, count = 200): number =>
  wrongShare(score(id, drawJudged(family, count, 81, difficulty)));
const bits = (id: string, family: string, difficulty?: number): number =>
  medianBits(score(id, drawJudged(family, 120, 82, difficulty)));

/**
 * At right angles to the axis of the unit cylinder, from 1e8 radii, aimed within 0.95 of the
 * radius: all clear hits.
 */
function levelRay(random: Random): Ray {
  const angle = uniform(random, 0, 2 * Math.PI);
  const [x, z] = [Math.cos(angle), Math.sin(angle)];
  const beside = uniform(random, -0.95, 0.95);
  return { origin: [-1e8 * x - beside * z, 0.5, -1e8 * z + beside * x], direction: [x, 0, z] };
}

describe('clear hits on a cylinder from 1e8 radii, d ⟂ axis, aimed within 0.95 r (seed 83)', () => {
  const random = seeded(83);
  const shape = { kind: 'cylinder', center: [0, 0, 0], radius: 1 } as const;
  const rays = Array.from({ length: 800 }, () => levelRay(random));
  const questions = judged(rays.map((ray) => ({ shape, ray })));

  test('all are hits', () => {
    expect(questions.every(({ truth }) => truth.class === 'two')).toBe(true);
  });

  test.each([
    ['textbook', 0.63],
    ['stable', 0.63],
    ['moment', 0],
    ['compensated', 0],
    ['interval', 0],
  ])('%s misjudges about %d of them', (id, expected) => {
    const wrong = wrongShare(score(id, questions));
    if (expected === 0) expect(wrong).toBe(0);
    else expect(Math.abs(wrong - expected)).toBeLessThan(0.05);
  });

  test('the exact discriminant of the rounded A, B, C still about 0.61', () => {
    const tested = method('textbook');
    const wrong = questions.filter(({ ray }) => {
      const { A, B, C } = tested.coefficients(shape, ray);
      const scalars = { A: exactly.of(A), B: exactly.of(B), C: exactly.of(C) };
      return exactly.sign(evaluate(DISCRIMINANT, exactly, { scalars, vectors: {} })) <= 0;
    });
    expect(Math.abs(wrong.length / questions.length - 0.61)).toBeLessThan(0.05);
  });
});

describe('far away', () => {
  test('float32 is lost at 1e4 radii, float64 at 1e8, the moment form never', () => {
    expect(share('textbook32', 'far-origin', 4)).toBeGreaterThan(0.5);
    expect(share('textbook', 'far-origin', 6)).toBe(0);
    expect(share('textbook', 'far-origin', 9)).toBeGreaterThan(0.5);
    for (const k of [6, 9, 12]) expect(share('moment', 'far-origin', k)).toBe(0);
  });

  test('and bits: 3 for each power of ten in the textbook form, none in the moment form', () => {
    expect(bits('textbook', 'far-origin', 2)).toBeLessThan(8);
    expect(bits('textbook', 'far-origin', 6)).toBeGreaterThan(16);
    expect(bits('stable', 'far-origin', 6)).toBeCloseTo(bits('textbook', 'far-origin', 6), 2);
    expect(bits('moment', 'far-origin', 6)).toBeLessThan(2);
  });
});

describe('nearly along a generator', () => {
  test('stable cures the root formula, but not a far origin', () => {
    expect(bits('textbook', 'near-axis', 10)).toBeGreaterThan(20);
    expect(bits('stable', 'near-axis', 10)).toBeLessThan(2);
  });
  test('double-double is not exact either', () => {
    const wrong = share('compensated', 'near-generator');
    expect(wrong).toBeGreaterThan(0.05);
    expect(wrong).toBeLessThan(0.25);
  });
  test('and the interval method says so', () => {
    const { wrong, undecided, count } = score('interval', drawJudged('near-generator', 300, 81));
    expect(wrong).toBe(0);
    expect(undecided / count).toBeGreaterThan(0.3);
  });
});

describe('the ladder is not monotone', () => {
  test('at a cone’s vertex the moment form in doubles beats B² − 4AC in twice the digits', () => {
    expect(share('textbook', 'vertex')).toBeGreaterThan(0.3);
    expect(share('compensated', 'vertex')).toBeGreaterThan(0.05);
    expect(share('moment', 'vertex')).toBeLessThan(0.02);
  });
  test('near a generator moment is no better than textbook', () => {
    expect(share('moment', 'near-generator')).toBeGreaterThan(
      share('textbook', 'near-generator') - 0.02,
    );
  });
});

describe('near the surface C is lost before any of the float64 solvers sees it', () => {
  test.each(['textbook', 'stable', 'moment'])('%s loses 20 bits at 1e-10 radii', (id) => {
    expect(bits(id, 'cancellation', 10)).toBeGreaterThan(20);
  });
  test('compensated none', () => {
    expect(bits('compensated', 'cancellation', 10)).toBe(0);
  });
});

describe('grazing', () => {
  test('half of the digits of the root are gone when the gap is 1e-14', () => {
    for (const id of ['textbook', 'stable', 'moment']) {
      expect(bits(id, 'near-tangent', 14)).toBeGreaterThan(19);
    }
    expect(bits('compensated', 'near-tangent', 14)).toBe(0);
  });
});

describe('scale', () => {
  test('d of 1e±150 is nothing to doubles, and beyond float32', () => {
    expect(share('textbook', 'scale-ray')).toBe(0);
    const { undecided, wrong, count } = score('textbook32', drawJudged('scale-ray', 300, 81));
    expect(undecided / count).toBeGreaterThan(0.3);
    expect(wrong / count).toBeGreaterThan(0.2);
  });
  test('a world of 1e±140 overflows into undecided, and underflows into wrong answers', () => {
    for (const id of ['textbook', 'moment', 'compensated']) {
      expect(score(id, drawJudged('scale-world', 100, 81, 140)).undecided).toBe(100);
      expect(score(id, drawJudged('scale-world', 100, 81, -140)).wrong).toBeGreaterThan(80);
    }
    const { wrong, undecided } = score('interval', drawJudged('scale-world', 100, 81, -140));
    expect([wrong, undecided]).toEqual([0, 100]);
  });
});

describe('rims', () => {
  test('float64 errs on one in ten, and interval abstains there', () => {
    expect(share('textbook', 'circle-rim')).toBeGreaterThan(0.05);
    expect(share('moment', 'circle-rim')).toBeGreaterThan(0.03);
    expect(share('compensated', 'circle-rim')).toBe(0);
    const { wrong, undecided, count } = score('interval', drawJudged('circle-rim', 300, 81));
    expect(wrong).toBe(0);
    expect(undecided / count).toBeLessThan(0.35);
  });
});

describe('B = 0: −d turns the roots around', () => {
  /**
   * Rays past the axis of a cylinder at right angles to E − C, and how many change a root's size
   * with the sign of d.
   */
  const turned = (id: string): number => {
    const random = seeded(84);
    let changed = 0;
    for (let k = 0; k < 400; k++) {
      const shape = { kind: 'cylinder', center: [0, 0, 0], radius: uniform(random, 1, 2) } as const;
      const origin = [0, 1, uniform(random, -1, 1)] as const;
      const [x, y] = [uniform(random, 0.1, 2), uniform(random, -1, 1)];
      const ts = (direction: Ray['direction']) =>
        method(id)
          .intersect(shape, { origin, direction })
          .hits.map(({ t }) => t);
      const back = ts([-x, -y, 0])
        .map((t) => -t)
        .reverse();
      if (ts([x, y, 0]).some((t, i) => t !== back[i])) changed += 1;
    }
    return changed / 400;
  };

  test.each(['textbook', 'compensated', 'certified', 'exact'])('%s: to the last bit', (id) => {
    expect(turned(id)).toBe(0);
  });
  // q = −√D/2 for both, so one root is q/A and the other one C/q, whichever way d points.
  test.each(['stable', 'moment', 'interval'])('%s: but for a bit on some rays', (id) => {
    expect(turned(id)).toBeGreaterThan(0.2);
  });
});
