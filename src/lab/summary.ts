import type { Question } from '../math/families.ts';
import { type Batch, rayAt } from './plan.ts';
import type { Quality } from './quality.ts';
import { quantile } from './stats.ts';

/** A quality that can be posted to another thread: no lists, and the worst ray as numbers. */
export interface Summary extends Omit<Quality, 'ulps' | 'worst'> {
  /**
   * Error in ulps that 999 of 1000 right roots do not exceed, and the largest; NaN without roots.
   */
  readonly ulps: number;
  readonly mostUlps: number;
  /** Absent if no ray has a root and every verdict is right. */
  readonly worst?: Question;
}

const NEARLY_ALL = 0.999;

export function summaryOf({ ulps, worst, ...rest }: Quality, batches: readonly Batch[]): Summary {
  const batch = worst && batches[worst.batch];
  return {
    ...rest,
    ulps: quantile(ulps, NEARLY_ALL),
    mostUlps: ulps.at(-1) ?? Number.NaN,
    ...(batch && { worst: { shape: batch.shape, ray: rayAt(batch, worst.ray) } }),
  };
}
