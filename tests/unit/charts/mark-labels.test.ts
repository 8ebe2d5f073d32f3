import { describe, expect, test } from 'vitest';
import {
  type Box,
  type LabelRequest,
  labelMarks,
  overlap,
  spread,
} from '../../../src/charts/mark-labels.ts';
import { seeded } from '../../../src/math/rng.ts';
import { many } from '../many.ts';

const FRAME: Box = { left: 40, top: 10, width: 540, height: 280 };
const wish = (x: number, y: number, width = 80): LabelRequest => ({
  x,
  y,
  radius: 5,
  width,
  height: 16,
});

function collisions(wishes: readonly LabelRequest[], taken: readonly Box[] = []): string[] {
  const placed = labelMarks(wishes, FRAME, taken);
  const marks = wishes.map(({ x, y, radius: r }) => ({
    left: x - r,
    top: y - r,
    width: 2 * r,
    height: 2 * r,
  }));
  const found: string[] = [];
  placed.forEach((box, i) => {
    placed.slice(i + 1).forEach((other, k) => {
      if (overlap(box, other)) found.push(`labels ${i} and ${i + 1 + k}`);
    });
    marks.forEach((mark, k) => {
      if (overlap(box, mark)) found.push(`label ${i} on mark ${k}`);
    });
    taken.forEach((other, k) => {
      if (overlap(box, other)) found.push(`label ${i} on box ${k}`);
    });
    const outside = box.left < FRAME.left || box.left + box.width > FRAME.left + FRAME.width;
    if (outside || box.top < FRAME.top || box.top + box.height > FRAME.top + FRAME.height)
      found.push(`label ${i} outside`);
  });
  return found;
}

describe('labels', () => {
  test('a lonely mark has its name at its right, at the right edge at its left', () => {
    const [first] = labelMarks([wish(100, 100)], FRAME);
    expect(first).toEqual({ left: 111, top: 92, width: 80, height: 16, led: false });
    expect(labelMarks([wish(570, 100)], FRAME)[0]?.left).toBe(570 - 11 - 80);
  });

  test('between two others it stands above, clear of its mark', () => {
    const beside = [9, 111].map((left) => ({ left, top: 92, width: 80, height: 16 }));
    expect(labelMarks([wish(100, 100)], { ...FRAME, left: 0 }, beside)[0]).toEqual({
      left: 60,
      top: 100 - 11 - 16 + 2,
      width: 80,
      height: 16,
      led: false,
    });
  });

  test('eight marks on one point', () => {
    const all = Array.from({ length: 8 }, () => wish(300, 20, 120));
    expect(collisions(all)).toEqual([]);
    expect(labelMarks(all, FRAME).some(({ led }) => led)).toBe(true);
  });

  test('marks in the corners, and boxes that are taken', () => {
    const all = [wish(42, 12), wish(578, 12), wish(42, 288), wish(578, 288)];
    expect(collisions(all, [{ left: 400, top: 250, width: 180, height: 30 }])).toEqual([]);
  });

  test(`${many(200)} crowds of eight, seed 21`, () => {
    const random = seeded(21);
    for (let k = 0; k < many(200); k++) {
      const x = 60 + 480 * random();
      const y = 20 + 260 * random();
      const all = Array.from({ length: 8 }, () =>
        wish(
          Math.min(575, x + 60 * random()),
          Math.min(285, y + 30 * random()),
          40 + 110 * random(),
        ),
      );
      expect(collisions(all)).toEqual([]);
    }
  });
});

describe('names under each other', () => {
  test('stay where they want to be if there is room', () => {
    expect(spread([10, 100, 50], 16, 0, 200)).toEqual([10, 100, 50]);
  });

  test('are moved apart and kept within', () => {
    const at = spread([100, 100, 101, 199, 200], 16, 0, 200);
    const sorted = [...at].sort((a, b) => a - b);
    for (let i = 1; i < sorted.length; i++) {
      expect((sorted[i] as number) - (sorted[i - 1] as number)).toBeGreaterThanOrEqual(16);
    }
    expect(Math.max(...at)).toBeLessThanOrEqual(200);
    expect(at[0] as number).toBeLessThan(at[1] as number);
  });
});
