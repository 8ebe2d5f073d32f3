import { quantile, sorted } from './stats.ts';

/*
 * One statistic for every price on the page, its own in table, plot and sentence and the
 * reference that stands there before: the lower quartile of many interleaved rounds. Whatever else
 * the machine does only adds to a time, so it may disturb three rounds in four and change nothing;
 * and no single round decides.
 */

/** What something costs. */
export interface Price {
  /** Rounded to so many figures: what is shown, and what multiples are computed from. */
  readonly value: number;
  readonly figures: Figures;
  /** The quartiles of the rounds, not rounded. */
  readonly low: number;
  readonly most: number;
}

type Figures = 1 | 2 | 3;

/** Fewer rounds than this say nothing of how far they spread. */
const ENOUGH = 4;
/** Up to which distance of the quartile from the best round, as a share, so many figures stand. */
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

/** How much longer than the best quarter one round in four took or more, as a share. */
export const spreadOf = ({ low, most }: Price): number => most / low - 1;

/** Above this something else was running. */
export const BUSY = 0.2;
