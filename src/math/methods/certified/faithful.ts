/**
 * hi + lo, off by η of itself, may be rounded to hi as long as η < u/2, u = 2^-53: hi is off by half a place at most, and a place is at least u of
 * the number (just below a power of two), so that the other half, u/2, is left for the truth to stay between hi's neighbours. Half of that is room for η
 * being worked out in doubles. A root of 0 must be 0 exactly.
 *
 * Comparisons are written so that NaN fails them. But a quotient that serves as a test, as η does,
 * needs a finite denominator: x/∞ is 0 and passes any. So each of them asks for one, or has it by
 * what was asked before: plain-roots.ts by LARGE, slow-planar.ts and the passes of recentred.ts,
 * refined.ts and kernel-planar.ts by the box (products of five of its numbers, with a, are below
 * 2^700), grid-quadric.ts by its splitting of A, lattice-coarse.ts by the gap of the roots (see
 * there).
 */
export const FAITHFUL = 2 ** -55;
