import { integer, type Random, randomSign, uniform } from '../../../src/math/rng.ts';

type Numbers = readonly number[];

interface Search {
  /** Where a search begins. */
  readonly start: () => number[];
  /** What is to be as large as can be; 0 where the question does not arise. */
  readonly score: (x: Numbers) => number;
  /** Another place to try; `oneOrTwo` unless it is given. */
  readonly change?: (random: Random, x: Numbers) => number[];
  readonly starts: number;
  readonly steps: number;
}

/**
 * The largest score that is found by changing a place again and again and keeping what is no worse.
 */
export function climb(random: Random, search: Search): number {
  const { start, score, change = oneOrTwo, starts, steps } = search;
  let most = 0;
  for (let k = 0; k < starts; k++) {
    let x = start();
    let best = score(x);
    for (let step = 0; step < steps; step++) {
      const y = change(random, x);
      const found = score(y);
      if (found >= best) [x, best] = [y, found];
    }
    most = Math.max(most, best);
  }
  return most;
}

/** The largest score of `length` numbers that begin in −1 … 1. */
export function climbFromUnits(
  random: Random,
  length: number,
  score: (at: Numbers) => number,
  starts = 20,
  steps = 400,
): number {
  const start = () => Array.from({ length }, () => uniform(random, -1, 1));
  return climb(random, { start, score, change: many, starts, steps });
}

/** One number or two, from by a bit to by half. */
function oneOrTwo(random: Random, x: Numbers): number[] {
  const y = [...x];
  for (let n = integer(random, 1, 2); n > 0; n--) {
    const i = integer(random, 0, y.length - 1);
    y[i] = (y[i] as number) * (1 + randomSign(random) * 2 ** -integer(random, 1, 52) * random());
  }
  return y;
}

/** Two of five, all by about as much, and one of 25 anew. */
function many(random: Random, x: Numbers): number[] {
  const by = 2 ** -uniform(random, 0, 12);
  return x.map((at) => {
    if (random() < 0.6) return at;
    return random() < 0.1 ? uniform(random, -1, 1) : at * (1 + uniform(random, -by, by));
  });
}
