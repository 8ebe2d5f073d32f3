import { expect, test } from 'vitest';
import { apart } from '../../../src/panels/picture-map.ts';
import { heatOf, placeOf } from '../../../src/state/picture/heat.ts';

const placed = (most: number, least: number) => {
  const heat = heatOf(Uint32Array.of(least, most));
  return [...apart(heat.ticks, (n) => 1 + placeOf(heat, n) * 242)];
};

test('numbers of the scale that would touch another one are left out, the ends never', () => {
  expect(placed(2658, 5)).toEqual([2658, 5, 100]);
  expect(placed(561, 1)).toEqual([561, 1, 10, 100]);
  expect(placed(12_000_000, 1).slice(0, 2)).toEqual([12_000_000, 1]);
});
