import {
  accumulate,
  accumulateProduct,
  exactlyZero,
  LEVELS,
  newLevels,
} from '../../float/accumulate.ts';
import * as dd from '../../float/double-double.ts';
import { LEAST_EXACT_PRODUCT, productError, squareError } from '../../float/eft.ts';
import { ABSOLUTE_ERROR, ACCUMULATED_ERROR, ERROR_LEVELS } from './slow-bounds.ts';
import { C, FLARE, get, PX, PY, PZ, R, RADIUS, RHO, S } from './slow-registers.ts';

const levels = newLevels();

/**
 * E so near to the surface that C cancels beyond twice the digits: puts C once more, from the exact terms of its expansion, and returns the bound on its
 * relative error. A C that is 0 exactly is off by nothing, and gives the root 0 exactly.
 */
export function nearSurface(Cm: number): number {
  levels.fill(0);
  squareOf(PX, 1, 0);
  squareOf(PZ, 1, 0);
  if (get(FLARE) !== 0) squareOf(PY, -get(FLARE), -get(FLARE + 1));
  // r² underflowed, and its error with it.
  if (get(RADIUS) !== 0 && get(RHO) < LEAST_EXACT_PRODUCT)
    levels[LEVELS] = Number.POSITIVE_INFINITY;
  accumulate(levels, -get(RHO));
  accumulate(levels, -get(RHO + 1));
  R[C] = levels[0] as number;
  R[C + 1] = 0;
  if (exactlyZero(levels)) return 0;
  for (let k = 1; k < LEVELS; k++) {
    dd.set(R, S, levels[k] as number);
    dd.add(R, C, C, S);
  }
  return (ACCUMULATED_ERROR * Cm + ABSOLUTE_ERROR) / Math.abs(get(C)) + ERROR_LEVELS;
}

/** Adds (hi + lo)²·(a + aLow) for the double-double at `at`. */
function squareOf(at: number, a: number, aLow: number): void {
  const hi = get(at);
  const lo = get(at + 1);
  if (hi === 0) return;
  scaledSquare(hi * hi, squareError(hi, hi * hi), a, aLow);
  if (lo === 0) return;
  const cross = 2 * hi * lo;
  scaledSquare(cross, productError(2 * hi, lo, cross), a, aLow);
  scaledSquare(lo * lo, squareError(lo, lo * lo), a, aLow);
}

function scaledSquare(p: number, e: number, a: number, aLow: number): void {
  // Below that the square, of something that is not 0, has lost bits or vanished, and a zero would prove nothing.
  if (!(Math.abs(p) >= LEAST_EXACT_PRODUCT)) levels[LEVELS] = Number.POSITIVE_INFINITY;
  accumulateProduct(levels, p, a);
  accumulateProduct(levels, e, a);
  accumulateProduct(levels, p, aLow);
  accumulateProduct(levels, e, aLow);
}
