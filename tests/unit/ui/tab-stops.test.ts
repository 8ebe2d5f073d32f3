import { describe, expect, test } from 'vitest';
import { type ItemBox, leavesBox, type Move, target } from '../../../src/ui/tab-stops.ts';

/** Items of 30 × 20 px in rows of these lengths, 10 px apart. */
const rows = (...lengths: readonly number[]): ItemBox[] =>
  lengths.flatMap((length, row) =>
    Array.from({ length }, (_, i) => ({
      left: 40 * i,
      right: 40 * i + 30,
      top: 30 * row,
      bottom: 30 * row + 20,
    })),
  );

const go = (move: Move, at: number, places: readonly ItemBox[]): number =>
  target(move, at, places.length, () => places);

describe('where a key leads to', () => {
  test.each([
    ['a row', rows(4)],
    ['a column', rows(1, 1, 1, 1)],
  ] as const)('in %s up and down go along it too, and round', (_, places) => {
    for (const at of [0, 1, 2, 3]) {
      expect(go('next', at, places)).toBe((at + 1) % 4);
      expect(go('below', at, places)).toBe((at + 1) % 4);
      expect(go('previous', at, places)).toBe((at + 3) % 4);
      expect(go('above', at, places)).toBe((at + 3) % 4);
      expect([go('first', at, places), go('last', at, places)]).toEqual([0, 3]);
    }
  });

  test('in rows up and down go to the nearest one of the next row, or stay', () => {
    const places = rows(3, 1, 3);
    expect(go('below', 2, places)).toBe(3);
    expect(go('below', 3, places)).toBe(4);
    expect(go('above', 6, places)).toBe(3);
    expect(go('above', 1, places)).toBe(1);
    expect(go('below', 5, places)).toBe(5);
    expect(go('next', 2, places)).toBe(3);
  });

  test('down and up again come back, where rows are equally long', () => {
    const places = rows(4, 4, 4);
    for (const at of [0, 1, 2, 3, 4, 5, 6, 7]) {
      expect(go('above', go('below', at, places), places)).toBe(at);
    }
  });
});

describe('an arrow leaves a box', () => {
  const box = (from: number, to: number) => ({
    value: '4.25',
    selectionStart: from,
    selectionEnd: to,
  });
  test('at the end that it points to, and while the whole text is selected', () => {
    const left = [0, 1, 2, 3, 4].filter((caret) => leavesBox('previous', box(caret, caret)));
    const right = [0, 1, 2, 3, 4].filter((caret) => leavesBox('next', box(caret, caret)));
    expect([left, right]).toEqual([[0], [4]]);
    expect(leavesBox('next', box(0, 4)) && leavesBox('previous', box(0, 4))).toBe(true);
    expect(leavesBox('next', box(2, 4)) || leavesBox('previous', box(0, 2))).toBe(false);
    for (const move of ['first', 'last', 'above', 'below'] as const) {
      expect(leavesBox(move, box(0, 4))).toBe(false);
    }
  });
});
