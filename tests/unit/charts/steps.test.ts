import { scaleLinear } from 'd3-scale';
import * as fc from 'fast-check';
import { expect, test } from 'vitest';
import { niceTicks } from '../../../src/charts/axis-steps.ts';

test('ticks are multiples of a nice step, and those of d3', () => {
  const size = fc.double({ min: -12, max: 12, noNaN: true }).map((power) => 10 ** power);
  const start = fc.double({ min: -100, max: 100, noNaN: true });
  fc.assert(
    fc.property(start, size, fc.integer({ min: 2, max: 12 }), (share, extent, count) => {
      const [from, to] = [share * extent, (share + 1) * extent];
      const ticks = niceTicks(from, to, count);
      const theirs = scaleLinear([from, to], [0, 1]).ticks(count);
      expect(ticks.length).toBe(theirs.length);
      ticks.forEach((tick, i) => {
        expect(Math.abs(tick - (theirs[i] ?? Number.NaN))).toBeLessThanOrEqual(1e-12 * extent);
        // No digits beside its own: 0.3, and not 0.30000000000000004.
        expect(tick).toBe(Number(tick.toPrecision(7)));
      });
    }),
  );
});

test('far from 0, where fifteen digits still tell multiples apart', () => {
  expect(niceTicks(1e14, 1e14 + 4, 4)).toEqual([0, 1, 2, 3, 4].map((k) => 1e14 + k));
  expect(niceTicks(4e15, 4e15 + 4, 4)).toEqual([4e15]);
  expect(niceTicks(0, 1e-280, 5)).toEqual([0, 2e-281, 4e-281, 6e-281, 8e-281, 1e-280]);
});
