import { describe, expect, test } from 'vitest';
import { frontier, steps } from '../../../src/lab/pareto.ts';
import { seeded } from '../../../src/math/rng.ts';

const at = (cost: number, worth: number) => ({ cost, worth });

describe('the frontier', () => {
  test('is what nothing beats, by rising cost', () => {
    const all = [at(3, 9), at(1, 2), at(2, 2), at(4, 8), at(2, 5), at(9, 9.5)];
    expect(frontier(all)).toEqual([at(1, 2), at(2, 5), at(3, 9), at(9, 9.5)]);
  });

  test('keeps equals, drops what is only as good for more or worse for as much', () => {
    expect(frontier([at(1, 5), at(1, 5), at(2, 5), at(1, 4)])).toEqual([at(1, 5), at(1, 5)]);
  });

  test('leaves out what is not measured', () => {
    expect(frontier([at(Number.NaN, 9), at(1, Number.NaN), at(2, 1)])).toEqual([at(2, 1)]);
    expect(frontier([])).toEqual([]);
  });

  test('by its definition, on 300 sets of random points with many ties, seed 5', () => {
    const random = seeded(5);
    for (let k = 0; k < 300; k++) {
      const all = Array.from({ length: 12 }, () =>
        at(Math.floor(random() * 6), Math.floor(random() * 6)),
      );
      const front = frontier(all);
      for (const one of all) {
        const beaten = all.some(
          (o) =>
            (o.cost < one.cost && o.worth >= one.worth) ||
            (o.cost <= one.cost && o.worth > one.worth),
        );
        expect(front.includes(one)).toBe(!beaten);
      }
      for (let i = 1; i < front.length; i++) {
        expect(front[i]?.cost).toBeGreaterThanOrEqual(front[i - 1]?.cost ?? 0);
        expect(front[i]?.worth).toBeGreaterThanOrEqual(front[i - 1]?.worth ?? 0);
      }
    }
  });
});

test('the step line keeps the old worth until the next cost', () => {
  expect(steps([at(1, 2), at(3, 9)])).toEqual([
    [1, 2],
    [3, 2],
    [3, 9],
  ]);
});
