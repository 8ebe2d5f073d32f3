import { integer, type Random, randomSign } from '../../../src/math/rng.ts';

export interface Search {
  /** Where a search begins. */
  readonly start: () => number[];
  /** What is to be as large as can be; 0 where the question does not arise. */
  readonly score: (x: readonly number[]) => number;
  readonly starts: number;
  readonly steps: number;
}

/** The largest score that is found by changing one number or two at a time, from a bit to a half, and keeping what is better. */
export function climb(random: Random, { start, score, starts, steps }: Search): number {
  let most = 0;
  for (let k = 0; k < starts; k++) {
    let x = start();
    let best = score(x);
    for (let step = 0; step < steps; step++) {
      const y = [...x];
      for (let n = integer(random, 1, 2); n > 0; n--) {
        const i = integer(random, 0, y.length - 1);
        y[i] =
          (y[i] as number) * (1 + randomSign(random) * 2 ** -integer(random, 1, 52) * random());
      }
      const found = score(y);
      if (found >= best) [x, best] = [y, found];
    }
    most = Math.max(most, best);
  }
  return most;
}
