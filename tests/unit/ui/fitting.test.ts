import * as fc from 'fast-check';
import { expect, test } from 'vitest';
import { MINUS } from '../../../src/text/format.ts';
import { parseNumber } from '../../../src/text/parse.ts';
import { plainPowers } from '../../../src/text/scripts.ts';
import { shortened } from '../../../src/ui/fitting.ts';

/* A box never shows another number without ≈, and never more than it has room for. */

const readBack = (text: string): number => {
  const parsed = parseNumber(
    plainPowers(text.replace('≈', '').replace('·', '*')).replaceAll(MINUS, '-'),
  );
  return parsed.ok ? parsed.value : Number.NaN;
};

test.each([
  [-0.500000001, 6, '≈−0.50'],
  [3e-9, 7, '3·10⁻⁹'],
  [2.9483721, 6, '≈2.948'],
  [1 / 3, 6, '≈0.333'],
  [-8.7654321e-10, 7, '≈−9e−10'],
  [0.1 + 0.2, 6, '0.3'],
  [-123456.789, 3, '≈…'],
])('%d in %d characters: %s', (x, room, text) => {
  expect(shortened(x, ({ length }) => length <= room)).toBe(text);
});

test('any number in any room', () => {
  const double = fc.double({ noNaN: true, noDefaultInfinity: true });
  fc.assert(
    fc.property(
      fc.oneof(double, fc.integer(), fc.double({ min: -10, max: 10, noNaN: true })),
      fc.integer({ min: 2, max: 14 }),
      (x, room) => {
        const text = shortened(x, ({ length }) => length <= room);
        expect(text.length).toBeLessThanOrEqual(room);
        if (text.startsWith('≈')) return;
        // Doubles are shown to 15 digits at most.
        expect(Math.abs(readBack(text) - x)).toBeLessThanOrEqual(5e-15 * Math.abs(x));
      },
    ),
    { numRuns: 2000 },
  );
});
