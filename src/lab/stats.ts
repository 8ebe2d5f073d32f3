/** Quartiles of a measurement, which outliers by other load on the machine hardly change. */
export interface Quartiles {
  readonly low: number;
  readonly median: number;
  readonly high: number;
}

/**
 * The q-th quantile (0 ≤ q ≤ 1) of numbers in ascending order, between neighbours by proportion.
 */
export function quantile(ascending: readonly number[], q: number): number {
  const place = q * (ascending.length - 1);
  const below = ascending[Math.floor(place)];
  const above = ascending[Math.ceil(place)];
  if (below === undefined || above === undefined) return Number.NaN;
  // Equal neighbours may be infinite, and ∞ − ∞ is NaN.
  return below === above ? below : below + (above - below) * (place - Math.floor(place));
}

export const sorted = (values: Iterable<number>): number[] => [...values].sort((a, b) => a - b);

export function quartiles(values: Iterable<number>): Quartiles {
  const all = sorted(values);
  return { low: quantile(all, 0.25), median: quantile(all, 0.5), high: quantile(all, 0.75) };
}
