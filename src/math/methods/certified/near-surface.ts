import {
  accumulate,
  accumulateProduct,
  exactlyZero,
  LEVELS,
  newLevels,
} from '../../float/accumulate.ts';
import * as dd from '../../float/double-double.ts';
import { LEAST_EXACT_PRODUCT, productError, squareError } from '../../float/eft.ts';
import {
  type Algebra,
  AT_C,
  AT_C_LOW,
  AT_FLARE,
  AT_FLARE_LOW,
  AT_OFF_C,
  AT_PX,
  AT_PX_LOW,
  AT_PY,
  AT_PY_LOW,
  AT_PZ,
  AT_PZ_LOW,
  ERROR_C,
} from './algebra.ts';
import { UU } from './numbers.ts';

/*
 * C = px² + pz² − a·py² − r² where it cancels beyond twice the digits, E being nearly on the
 * surface: added up from the exact terms of its expansion.
 *
 *   quantity           bound              reason
 *   terms              38 of them, their  three squares for each coordinate of p, twice as many
 *                      sizes < 2Cm        products with a for the one along y, each of which is two
 *                                         doubles, and r²
 *   levels             (2n u)^4 of that   `accumulate`
 *   their sum          9u² of it          3u² in each of three sums
 *   a lost product     ≤ 2^-1073          those of the squares along y are multiplied by a, that of
 *                                         a = c² by py², both < 2^200
 */
const TERMS = 38;
export const ACCUMULATED_ERROR = 2 * (2 * TERMS * 2 ** -53) ** 4;
export const ERROR_LEVELS = 9 * UU;
export const SMALLEST_C = 2 ** -870;

const levels = newLevels();

/** The levels' sum, and one of them, as two doubles each. */
const sum = new Float64Array(4);
const TOTAL = 0;
const TOTAL_LOW = 1;
const LEVEL = 2;

/**
 * Puts C and its bound once more, from p and a in `algebra`, if that bound is the narrower one:
 * SMALLEST_C is wider than the SMALLEST_ALGEBRA of algebra.ts. A C that is 0 exactly is off by
 * nothing.
 */
export function sharpenC(algebra: Algebra, r: number): void {
  const a = algebra[AT_FLARE] as number;
  const rho = r * r;
  levels.fill(0);
  addSquare(levels, algebra[AT_PX] as number, algebra[AT_PX_LOW] as number, 1, 0);
  addSquare(levels, algebra[AT_PZ] as number, algebra[AT_PZ_LOW] as number, 1, 0);
  if (a !== 0) {
    const low = algebra[AT_FLARE_LOW] as number;
    addSquare(levels, algebra[AT_PY] as number, algebra[AT_PY_LOW] as number, -a, -low);
  }
  accumulate(levels, -rho);
  accumulate(levels, -squareError(r, rho));
  // r², or a = c², underflowed, and its error with it.
  if (lostBits(r, rho) || lostBits(a, a)) levels[LEVELS] = Number.POSITIVE_INFINITY;
  dd.set(sum, TOTAL, levels[0] as number);
  for (let k = 1; k < LEVELS; k++) {
    dd.set(sum, LEVEL, levels[k] as number);
    dd.add(sum, TOTAL, TOTAL, LEVEL);
  }
  const before = algebra[AT_OFF_C] as number;
  const Cm = before / ERROR_C;
  const off = exactlyZero(levels)
    ? 0
    : ACCUMULATED_ERROR * Cm + SMALLEST_C + ERROR_LEVELS * Math.abs(sum[TOTAL] as number);
  if (!(off < before)) return;
  algebra[AT_C] = sum[TOTAL] as number;
  algebra[AT_C_LOW] = sum[TOTAL_LOW] as number;
  algebra[AT_OFF_C] = off;
}

/**
 * Whether the product p of something that is not 0 is so small that bits of it, or all, are lost,
 * and a zero would prove nothing.
 */
const lostBits = (x: number, p: number): boolean =>
  x !== 0 && !(Math.abs(p) >= LEAST_EXACT_PRODUCT);

type Levels = ReturnType<typeof newLevels>;

/** Adds (hi + lo)²·(a + aLow). */
function addSquare(levels: Levels, hi: number, lo: number, a: number, aLow: number): void {
  if (hi === 0) return;
  addScaled(levels, hi * hi, squareError(hi, hi * hi), a, aLow);
  if (lo === 0) return;
  const cross = 2 * hi * lo;
  addScaled(levels, cross, productError(2 * hi, lo, cross), a, aLow);
  addScaled(levels, lo * lo, squareError(lo, lo * lo), a, aLow);
}

function addScaled(levels: Levels, p: number, e: number, a: number, aLow: number): void {
  if (lostBits(1, p)) levels[LEVELS] = Number.POSITIVE_INFINITY;
  accumulateProduct(levels, p, a);
  accumulateProduct(levels, e, a);
  accumulateProduct(levels, p, aLow);
  accumulateProduct(levels, e, aLow);
}
