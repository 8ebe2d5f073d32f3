import fc from 'fast-check';
import { expect, test } from 'vitest';
import { frameOf } from '../../../src/charts/graph-frame.ts';
import { scalesOf } from '../../../src/charts/graph-scales.ts';
import type { GraphModel } from '../../../src/state/graph-model.ts';

const frame = frameOf({ width: 640, height: 260, em: 12.5, mark: 1 });

/** A range about a centre of any size, of a width between a few doubles and many centres. */
const range = fc
  .record({
    sign: fc.constantFrom(-1, 0, 1),
    mantissa: fc.double({ min: 1, max: 10, noNaN: true }),
    power: fc.integer({ min: -285, max: 295 }),
    share: fc.integer({ min: -19, max: 2 }),
    digits: fc.double({ min: 1, max: 10, noNaN: true }),
    at: fc.constantFrom(0, 0.5, 1, 2 ** -20),
  })
  .map(({ sign, mantissa, power, share, digits, at }): [number, number] => {
    const size = Number(`${mantissa}e${power}`);
    const width = size * Number(`${digits}e${share}`);
    const centre = sign * size;
    return [centre - at * width, centre + (1 - at) * width];
  })
  .filter(([from, to]) => to - from > 1e-290 && to - from < 1e300);

test('labels of any range are few, within it, in order, and no two read the same', () => {
  fc.assert(
    fc.property(range, range, ([from, to], [low, high]) => {
      const scales = scalesOf({ from, to, low, high } as GraphModel, frame);
      if (!scales) throw new Error('no scales');
      for (const [ticks, [least, most]] of [
        [scales.tTicks, [from, to]],
        [scales.fTicks, [low, high]],
      ] as const) {
        expect(ticks.length).toBeLessThanOrEqual(15);
        const isWide = most - least > 1e-9 * Math.max(Math.abs(least), Math.abs(most));
        if (isWide) expect(ticks.length).toBeGreaterThan(0);
        for (const [k, { value, at }] of ticks.entries()) {
          expect(value).toBeGreaterThanOrEqual(least);
          expect(value).toBeLessThanOrEqual(most);
          expect(Number.isFinite(at)).toBe(true);
          if (k > 0) expect(value).toBeGreaterThan(ticks[k - 1]?.value as number);
        }
        expect(new Set(ticks.map(({ label }) => label)).size).toBe(ticks.length);
      }
    }),
    { numRuns: 3000 },
  );
});
