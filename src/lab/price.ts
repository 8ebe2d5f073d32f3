import { quantile, sorted } from './stats.ts';

/*
 * One estimator for every time that the page measures, in table, plot and sentence: the least of
 * many interleaved rounds. Whatever else the machine does only adds to a time, so that the least is
 * nearest to what the work itself takes, and a stalled round changes nothing. The bench's prices
 * are medians with quartiles.
 */

/** What something costs. */
export interface Price {
  /** Rounded to so many figures: what is shown, and what multiples are computed from. */
  readonly value: number;
  readonly figures: Figures;
  /** The least of the rounds, not rounded, and what three rounds in four stay below. */
  readonly least: number;
  readonly most: number;
}

type Figures = 1 | 2 | 3;

/** Fewer rounds than this say nothing of how far they spread. */
const ENOUGH = 4;
/**
 * Up to which spread above the least, as a share of it, a quarter of the rounds lets so many
 * figures stand.
 */
const LETS_STAND = [
  [0.01, 3],
  [0.3, 2],
] as const satisfies readonly (readonly [spread: number, figures: Figures])[];

/**
 * From the times of some rounds, each of which may be a multiple of what is wanted. NaN without
 * rounds.
 */
export function priceOf(rounds: readonly number[], scale = 1): Price {
  const all = sorted(rounds);
  const least = (all[0] ?? Number.NaN) * scale;
  const spread = (quantile(all, 0.25) * scale) / least - 1;
  const stands = LETS_STAND.find(([limit]) => spread <= limit)?.[1] ?? 1;
  const figures = all.length < ENOUGH ? (Math.min(2, stands) as Figures) : stands;
  return { value: rounded(least, figures), figures, least, most: quantile(all, 0.75) * scale };
}

/** One price as a multiple of another, from the figures that are shown. */
export function multipleOf(price: Price, base: Price): Price {
  if (price === base) return { value: 1, figures: 3, least: 1, most: price.most / price.least };
  const figures = Math.min(price.figures, base.figures) as Figures;
  return {
    value: rounded(price.value / base.value, figures),
    figures,
    least: price.least / base.value,
    most: price.most / base.value,
  };
}

export const rounded = (x: number, figures: number): number => Number(x.toPrecision(figures));

/** How much longer than the least one round in four took or more, as a share of it. */
export const spreadOf = ({ least, most }: Price): number => most / least - 1;

/** Above this something else was running. */
export const BUSY = 0.2;
