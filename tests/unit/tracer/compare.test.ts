import { expect, test } from 'vitest';
import { decoded, encoded, level, linear } from '../../../src/tracer/colour.ts';
import {
  ALL_DIGITS,
  comparePictures,
  digitsLost,
  OTHER_COLOUR,
  OTHER_VERDICT,
  type Picture,
  SAME,
} from '../../../src/tracer/compare.ts';

const of = (pixels: readonly (readonly [grey: number, surface: number, t: number])[]): Picture => ({
  width: pixels.length,
  height: 1,
  rgba: Uint8ClampedArray.from(pixels.flatMap(([g]) => [g, g, g, 255])),
  surface: Int32Array.from(pixels.map(([, surface]) => surface)),
  t: Float64Array.from(pixels.map(([, , t]) => t)),
});

test('colours, verdicts, holes, ghosts and digits are told apart', () => {
  const right = of([
    [10, 0, 1],
    [20, 0, 1],
    [30, 0, 1],
    [40, 1, 2],
    [50, -1, Number.NaN],
    [60, 1, 4],
  ]);
  const wrong = of([
    [10, 0, 1],
    [23, 0, 1 + 2 ** -20],
    [31, -1, Number.NaN],
    [40, 2, 2],
    [50, 0, 9],
    [60, 1, 4 + 2 ** -50],
  ]);
  const found = comparePictures(wrong, right);
  expect([...found.map]).toEqual([
    SAME,
    OTHER_COLOUR,
    OTHER_VERDICT,
    OTHER_VERDICT,
    OTHER_VERDICT,
    SAME,
  ]);
  expect([...found.levels]).toEqual([0, 3, 1, 0, 0, 0]);
  expect(found).toMatchObject({ pixels: 6, differing: 2, verdicts: 3, holes: 1, ghosts: 1 });
  expect(found.largestLevel).toBe(3);
  expect(found.digits[0]).toBe(0);
  expect(found.digits[1]).toBeCloseTo(33 * Math.log10(2), 5);
  expect(found.digits[2]).toBeNaN();
  expect(found.digits[5]).toBeCloseTo(Math.log10(2), 5);
  expect(found.mostDigits).toBeCloseTo(33 * Math.log10(2), 5);
  expect(() => comparePictures(of([[1, 0, 1]]), right)).toThrow('1 × 1 cannot be laid on 6 × 1');
});

test('digits lost: none for neighbours, all for nonsense', () => {
  expect(digitsLost(1, 1)).toBe(0);
  expect(digitsLost(1 + 2 ** -53, 1)).toBe(0);
  expect(digitsLost(1 + 2 ** -52, 1)).toBeLessThan(0.31);
  expect(digitsLost(2, 1)).toBeCloseTo(ALL_DIGITS, 10);
  expect(digitsLost(-1e30, 1)).toBe(ALL_DIGITS);
  expect(digitsLost(Number.NaN, Number.NaN)).toBeNaN();
});

test('sRGB: there and back, its ends, and every level', () => {
  expect([encoded(0), encoded(1)]).toEqual([0, expect.closeTo(1, 12)]);
  for (let byte = 0; byte < 256; byte++) expect(level(decoded(byte / 255))).toBe(byte);
  expect(level(7)).toBe(255);
  expect(linear('#ff0080')[0]).toBe(1);
  expect(linear('#ff0080')[2]).toBeCloseTo(0.2158605, 6);
});
