/**
 * hi + lo, off by η of itself, may be rounded to hi as long as η < u/2, u = 2^-53: hi is off by half a place at most, and a place is at least u of
 * the number (just below a power of two), so that the other half, u/2, is left for the truth to stay between hi's neighbours. Half of that is room for η
 * being worked out in doubles. A root of 0 must be 0 exactly.
 */
export const FAITHFUL = 2 ** -55;
