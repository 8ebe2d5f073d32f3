import { LEAST_EXACT_PRODUCT, productError, sumError } from './eft.ts';

/**
 * How many doubles a running sum is kept in; one more place tells what was lost, see `exactlyZero`.
 */
export const LEVELS = 4;

export const newLevels = (): Float64Array => new Float64Array(LEVELS + 1);

/**
 * Adds x to the sum held in `levels`: each level takes the rounding errors of the one above it. Of
 * n terms in all, only what falls out of the last level is lost: |error| ≤ (2n u)^4 Σ|x| (Ogita,
 * Rump, Oishi 2005, SumK with K = 4), that is 2^-184 Σ|x| for n ≤ 64.
 */
export function accumulate(levels: Float64Array, x: number): void {
  let rest = x;
  for (let k = 0; k < LEVELS; k++) {
    const old = levels[k] as number;
    const sum = old + rest;
    rest = sumError(old, rest, sum);
    levels[k] = sum;
  }
  levels[LEVELS] = (levels[LEVELS] as number) + Math.abs(rest);
}

/** Whether the sum is 0 and nothing was lost on the way: then it is 0 exactly. */
export const exactlyZero = (levels: Float64Array): boolean => levels.every((x) => x === 0);

/** Adds a·b, which is two doubles exactly (in the range of `productError`). */
export function accumulateProduct(levels: Float64Array, a: number, b: number): void {
  if (a === 0 || b === 0) return;
  const p = a * b;
  if (!(Math.abs(p) >= LEAST_EXACT_PRODUCT)) levels[LEVELS] = Number.POSITIVE_INFINITY;
  accumulate(levels, p);
  accumulate(levels, productError(a, b, p));
}
