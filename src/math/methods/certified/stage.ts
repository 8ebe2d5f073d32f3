import type { RootSlot } from '../../batch/exact-quadric.ts';

/* What all stages share. u = 2^-53. */

/**
 * hi + lo, off by η of itself, may be rounded to hi as long as η < u/2, u = 2^-53: hi is off by
 * half a place at most, and a place is at least u of the number (just below a power of two), so
 * that the other half, u/2, is left for the truth to stay between hi's neighbours. Half of that is
 * room for η being worked out in doubles. A root of 0 must be 0 exactly.
 *
 * Comparisons are written so that NaN fails them. But a quotient that serves as a test, as η does,
 * needs a finite denominator: x/∞ is 0 and passes any. So each of them asks for one, or has it by
 * what was asked before: doubled.ts by LARGE, planar.ts and the passes of recentred.ts,
 * refined.ts and planar.ts by the box (products of five of its numbers, with a, are below
 * 2^700), grid-quadric.ts by its splitting of A, units-rough.ts by the gap of the roots (see
 * there).
 */
export const FAITHFUL = 2 ** -55;

/** Half a place of a number just below 1: u, and its square. */
export const U = 2 ** -53;
export const UU = 2 ** -106;

/**
 * A root that is rounded once is faithful if it was off by less than u|t|/2 before: neighbours are
 * at least u|t| apart. A tenth is left for evaluating the bound.
 */
export const FAITHFUL_ONCE = 0.9 * 2 ** -54;

/** Multiples of a size that cut numbers to 25 or 26 bits of it, and p to a grid for both roots. */
export const GRID_25 = 2 ** 29;
export const GRID_26 = 2 ** 28;
export const GRID_P = 2 ** 6;

/** Rays that the fast stages leave open, in `open[0 … count − 1]`. */
export interface OpenRays {
  count: number;
  open: Int32Array;
}

/** Roots and the stage that stood for them. */
export interface CertifiedSlot extends RootSlot {
  exact: boolean;
}

export const certifiedSlot = (): CertifiedSlot => ({
  t0: Number.NaN,
  t1: Number.NaN,
  exact: false,
});
