import type { Vec3 } from '../math/index.ts';
import { display } from '../text/format.ts';

/** Heights between which a shape is kept: low ≤ y ≤ high. */
export type Between = readonly [low: number, high: number];

/** "y = 1.774 > 1": why a root that a method has found to be cut off is beyond the ends. */
export function whyCut([, y]: Vec3, [low, high]: Between): string {
  const above = y >= high;
  const limit = above ? high : low;
  const sign = above ? '>' : '<';
  // The distance from a root to the end may be less than half an ulp.
  if (y === limit) return `y rounds to ${display(limit)}, exactly it is ${sign} ${display(limit)}`;
  const [own, end] = distinctTexts(y, limit);
  return `y = ${own} ${sign} ${end}`;
}

/** Both numbers with as many digits as it takes to tell them apart, at least four. */
export function distinctTexts(y: number, limit: number): readonly [string, string] {
  for (let digits = 4; digits < 17; digits++) {
    const [a, b] = [display(y, digits), display(limit, digits)];
    if (a !== b) return [a, b];
  }
  return [display(y, 17), display(limit, 17)];
}

/** "heights −1 and 2" */
export const heightsText = ([low, high]: Between): string =>
  `heights ${display(low)} and ${display(high)}`;
