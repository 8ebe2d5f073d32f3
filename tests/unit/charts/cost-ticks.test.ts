import { scaleLog } from 'd3-scale';
import * as fc from 'fast-check';
import { expect, test } from 'vitest';
import { costTicks } from '../../../src/charts/cost-ticks.ts';
import { labelSize } from '../../../src/charts/plot.ts';

test('labels of a cost axis stand in order and apart, and at least one is there', () => {
  fc.assert(
    fc.property(
      fc.integer({ min: 260, max: 1600 }),
      fc.integer({ min: 10, max: 26 }),
      fc.integer({ min: -3, max: 0 }),
      fc.integer({ min: 4, max: 14 }),
      fc.constantFrom(1, 0.8, 5, 6.3, 41),
      (width, em, low, octaves, unit) => {
        const x = scaleLog([2 ** low, 2 ** (low + octaves)], [3 * em, width - em]);
        const ticks = costTicks(x, unit, { width, em });
        const boxes = ticks.map(({ at, label }) => {
          const half = labelSize(label, em).width / 2;
          return [at - half, at + half] as const;
        });
        expect(ticks.length).toBeGreaterThan(0);
        for (const [i, [left, right]] of boxes.entries()) {
          expect(right).toBeLessThanOrEqual(width);
          if (i > 0) expect(left).toBeGreaterThan(boxes[i - 1]?.[1] ?? Number.NaN);
        }
      },
    ),
    { seed: 1202, numRuns: 500 },
  );
});
