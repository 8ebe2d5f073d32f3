import { quantile, sorted } from './stats.ts';

/*
 * Every price on the page, measured here or at the build, is the lower quartile of many interleaved
 * rounds. Other work of the machine only adds to a time, so the quartile is right even if three
 * rounds in four are disturbed, and does not depend on a single round.
 */

/** A measured cost. */
export interface Price {
  /** Rounded to `figures`; this number is shown, and multiples are computed from it. */
  readonly value: number;
  readonly figures: Figures;
  /** The quartiles of the rounds, not rounded. */
  readonly low: number;
  readonly most: number;
}

type Figures = 1 | 2 | 3;

/** Least number of rounds from which a spread is estimated. */
const ENOUGH = 4;
/** Figures to show, by the largest relative distance of the quartile from the best round. */
const LETS_STAND = [
  [0.01, 3],
  [0.3, 2],
] as const satisfies readonly (readonly [spread: number, figures: Figures])[];

/** The price from the times of some rounds, multiplied by `scale`. NaN without rounds. */
export function priceOf(rounds: readonly number[], scale = 1): Price {
  const all = sorted(rounds);
  const quarter = quantile(all, 0.25);
  const low = quarter * scale;
  const spread = quarter / (all[0] ?? Number.NaN) - 1;
  const stands = LETS_STAND.find(([limit]) => spread <= limit)?.[1] ?? 1;
  const figures = all.length < ENOUGH ? (Math.min(2, stands) as Figures) : stands;
  return { value: rounded(low, figures), figures, low, most: quantile(all, 0.75) * scale };
}

/** One price as a multiple of another, from the figures that are shown. */
export function multipleOf(price: Price, base: Price): Price {
  if (price === base) return { value: 1, figures: 3, low: 1, most: price.most / price.low };
  const figures = Math.min(price.figures, base.figures) as Figures;
  return {
    value: rounded(price.value / base.value, figures),
    figures,
    low: price.low / base.value,
    most: price.most / base.value,
  };
}

export const rounded = (x: number, figures: number): number => Number(x.toPrecision(figures));

/** Relative distance of the price's `most` from its `low`. */
export const spreadOf = ({ low, most }: Price): number => most / low - 1;

/** Spread above which the page says that the machine was busy. */
export const BUSY = 0.2;
