import { describe, expect, test } from 'vitest';
import type { Sign } from '../../../src/math/intersection.ts';
import {
  chooseTarget,
  ENTER,
  finestStep,
  gridUnit,
  LEAVE,
  nearestOn,
  onGrid,
  type SnapTarget,
  type Tangency,
  tangentTarget,
  type Value,
} from '../../../src/state/snap.ts';

const offer = (key: string, gap: number): SnapTarget => ({ key, value: 0, reason: key, gap });

describe('what a drag is taken by', () => {
  test('nothing beyond the first distance, the nearest within it', () => {
    expect(chooseTarget([], null)).toBeNull();
    expect(chooseTarget([offer('a', ENTER + 0.01)], null)).toBeNull();
    expect(chooseTarget([offer('a', ENTER)], null)?.key).toBe('a');
    expect(chooseTarget([offer('a', 5), offer('b', 3), offer('c', 7)], null)?.key).toBe('b');
  });

  test('what holds it goes on to hold it until the second distance, whatever is nearer', () => {
    const offers = [offer('a', LEAVE), offer('b', 1)];
    expect(chooseTarget(offers, 'a')?.key).toBe('a');
    expect(chooseTarget([offer('a', LEAVE + 0.01), offer('b', 1)], 'a')?.key).toBe('b');
    expect(chooseTarget([offer('a', LEAVE + 0.01)], 'a')).toBeNull();
  });

  test('a slow way across is one stretch, not a flicker', () => {
    let held: string | null = null;
    const seen = Array.from({ length: 41 }, (_, k) => {
      held = chooseTarget([offer('a', Math.abs(k - 20))], held)?.key ?? null;
      return held ? 'x' : '.';
    }).join('');
    expect(seen).toBe(`${'.'.repeat(12)}${'x'.repeat(22)}${'.'.repeat(7)}`);
  });
});

describe('the grid', () => {
  test('is the sliders’ step on their stage, coarser in a large world, finer from near', () => {
    expect(gridUnit(5, 1 / 85)).toBe(1);
    expect(gridUnit(500, 100 / 85)).toBe(100);
    expect(gridUnit(5, 1 / 850)).toBe(0.1);
    expect(gridUnit(5e-9, 1e-9 / 85)).toBeCloseTo(1e-9, 20);
  });

  test('leaves alone what the drag has not changed, to the bit', () => {
    const odd = 0.1 + 0.2;
    expect(onGrid([1.26, odd, -0.01], [1, odd, 0], 0.1)).toEqual([1.3, odd, 0]);
    expect(onGrid(odd, odd, 0.1)).toBe(odd);
    expect(onGrid(0.31, odd, 0.1)).toBe(0.3);
  });

  test('gives decimals as they are written, no −0, and stays finite at every scale', () => {
    expect(nearestOn(0.2999, 0.1)).toBe(0.3);
    expect(Object.is(nearestOn(-0.01, 0.1), 0)).toBe(true);
    for (const x of [0, 5e-324, 1e-300, 1, 1e300, -1e308]) {
      for (const step of [1e-320, 1e-9, 0.1, 1e200]) {
        expect(Number.isFinite(nearestOn(x, step)), `${x} on ${step}`).toBe(true);
      }
    }
    expect(nearestOn(1e300, 0.1), 'a grid that is finer than the doubles').toBe(1e300);
  });

  test('a finestStep is a power of ten below a tenth of a pixel', () => {
    expect(finestStep(1 / 85)).toBe(0.001);
    expect(finestStep(1)).toBe(0.1);
  });
});

/** D = f(value), exactly. */
const where = (f: (x: number) => number): Tangency => ({
  quick: (value) => f(value as number),
  exact: (value: Value) => {
    const D = f(value as number);
    return { sign: Math.sign(D) as Sign, size: D, isTangent: D === 0 };
  },
});
const line = (from: number, perPixel: number) =>
  [1, -1].map((sign) => (pixels: number) => from + sign * pixels * perPixel);

describe('tangency', () => {
  test('is found on either side, with its distance in pixels', () => {
    const found = tangentTarget(
      line(1, 0.01),
      where((x) => x - 1.04),
      [],
    );
    expect(found?.gap).toBeCloseTo(4, 3);
    expect(found?.value).toBeCloseTo(1.04, 15);
    const below = tangentTarget(
      line(1, 0.01),
      where((x) => x - 0.97),
      [],
    );
    expect(below?.gap).toBeCloseTo(3, 3);
  });

  test('beyond the second distance there is none', () => {
    expect(
      tangentTarget(
        line(1, 0.01),
        where((x) => x - 1.14),
        [],
      ),
    ).toBeNull();
    expect(
      tangentTarget(
        line(1, 0.01),
        where(() => 1),
        [],
      ),
    ).toBeNull();
    expect(
      tangentTarget(
        line(1, 0.01),
        where(() => Number.NaN),
        [],
      ),
    ).toBeNull();
    expect(
      tangentTarget(
        [],
        where((x) => x),
        [],
      ),
    ).toBeNull();
  });

  test('where it is no double, the neighbour with the smaller D is taken, said to be near', () => {
    // D = x² − 2 in exact arithmetic is never 0; in doubles its sign changes between two
    // neighbours.
    const tangency: Tangency = {
      quick: (value) => (value as number) ** 2 - 2,
      exact(value) {
        const x = value as number;
        const D = Number(BigInt(Math.round(x * 2 ** 52)) ** 2n - 2n * 2n ** 104n);
        return { sign: Math.sign(D) as Sign, size: D, isTangent: false };
      },
    };
    const found = tangentTarget(line(1.4, 0.01), tangency, [
      (value) => nearestOn(value as number, 0.1),
    ]);
    expect(found?.value).toBe(Math.SQRT2);
    expect(found?.reason).toBe('snapped: as near tangent as doubles come');
  });

  test('a value on the grid that is exactly tangent is preferred', () => {
    const tangency = where((x) => (x === 1.1 ? 0 : x - 1.1));
    const found = tangentTarget(line(1.07, 0.01), tangency, [
      (value) => nearestOn(value as number, 0.1),
    ]);
    expect(found).toMatchObject({ value: 1.1, reason: 'snapped: tangent', key: 'tangent' });
  });
});
