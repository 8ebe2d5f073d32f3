import { NONE, TWO } from '../../batch/batch.ts';
import { type RootSlot, solveExactly } from '../../batch/exact-quadric.ts';
import type { Quadric } from '../../batch/quadric.ts';
import {
  accumulate,
  accumulateProduct,
  exactlyZero,
  LEVELS,
  newLevels,
} from '../../float/accumulate.ts';
import { exponentOf, scale } from '../../float/bits.ts';
import * as dd from '../../float/double-double.ts';
import { LEAST_EXACT_PRODUCT, productError, squareError, sumError } from '../../float/eft.ts';

/** Roots and the stage that stood for them. */
export interface CertifiedSlot extends RootSlot {
  exact: boolean;
}

export const certifiedSlot = (): CertifiedSlot => ({
  t0: Number.NaN,
  t1: Number.NaN,
  exact: false,
});

/*
 * The second stage: everything once more in double-double, on a ray whose max |d| and largest
 * length lie in 2^-40 … 2^40, or are scaled by powers of two into [1, 2). Errors, in ε = 5u² < 2^-103, a bound for every sum and product of float/double-double.ts;
 * products of two doubles are exact, and so are p = E − C (a sum of two doubles), c² and r².
 *
 *   A = dx² + dz² − a·dy²     the last product ε, two sums ε each:                        |δA| ≤ 3ε Am (1 + ε)² < 4ε Am
 *   b = dx px + dz pz − a·dy·py   products ε (the last 2ε), two sums:                     |δb| < 5ε bm ≤ 5ε √(Am Cm)
 *   C = px² + pz² − a·py² − ρ     products ε (the last 2ε), three sums:                   |δC| < 6ε Cm
 *   m = d × p                 products ε, one sum:                                        |δmi| < 3ε Si
 *   mi²                       2|mi|·3ε Si + 9ε² Si² + ε mi²:                              < 8ε Si²
 *   D/4 = ρA + a(mx² + mz²) − my²   (4 + 1)ε of ρAm; (8 + 1 + 1)ε of a(Sx² + Sz²), 8ε of Sy², two sums: < 13ε S
 *
 * where Am = dx² + dz² + |a|dy², Pm = px² + pz² + |a|py², Cm = Pm + ρ, Si = |dj pk| + |dk pj|,
 * bm = |dx px| + |dz pz| + |a dy py| ≤ √(Am Pm) (Cauchy–Schwarz), and
 * S = ρAm + |a|(Sx² + Sz²) + Sy² ≤ ρAm + 2AmPm ≤ 2AmCm, since (|α| + |β|)² ≤ 2α² + 2β² and every dj²pk² of the three
 * sums appears in AmPm. Hence |δ(D/4)| < 26ε AmCm < 2^-98 AmCm. Am and Cm, evaluated in doubles, are off by a few u;
 * DISCRIMINANT_ERROR has room for it (26 · 2^-103 = 2^-98.3).
 *
 * Underflow: a product that leaves the doubles is off by 2^-1073 at most, and what multiplies it afterwards is at most
 * |a|² |d|² |p|² < 2^400 · 2^82 · 2^84; with fewer than 2^10 operations this is below ABSOLUTE_ERROR.
 */
const EPSILON = 2 ** -103;
const DISCRIMINANT_ERROR = 2 ** -98;
const ABSOLUTE_ERROR = 2 ** -440;
/** max |d| and the largest length between 2^-40 and 2^40 need no scale. */
const ORDINARY = 2 ** 40;
/** Beyond this a·dy² and the absolute term above lose their meaning: such shapes go to the exact stage at once. */
const LARGEST_FLARE = 2 ** 200;
const SMALLEST_SQUARED = 2 ** -400;

/**
 * A result hi + lo with relative error η is faithful when rounded to hi if η < u/2: neighbours of x are at least u|x| away.
 * Half of that is left to the double-precision evaluation of η itself.
 */
const FAITHFUL = 2 ** -55;

/** Places of double-doubles in the register file. */
const R = new Float64Array(32);
const X = 0;
const Y = 2;
const Z = 4;
const PX = 6;
const PY = 8;
const PZ = 10;
const FLARE = 12;
const RHO = 14;
const A = 16;
const B = 18;
const C = 20;
const D = 22;
const S = 24;
const T = 26;
const U = 28;
const RADIUS = 30;

const get = (i: number): number => R[i] as number;

/** Puts a − b, exactly: a sum of two doubles is a double-double. */
function setDifference(out: number, a: number, b: number): void {
  const s = a - b;
  R[out] = s;
  R[out + 1] = sumError(a, -b, s);
}

/** Puts x², exactly unless it leaves the doubles. */
function setSquare(out: number, x: number): void {
  const p = x * x;
  R[out] = p;
  R[out + 1] = squareError(x, p);
}

/** out = x·x' + z·z' − a·y·y' for three pairs of double-doubles. */
function form(
  out: number,
  x: number,
  x1: number,
  y: number,
  y1: number,
  z: number,
  z1: number,
): void {
  dd.mul(R, S, x, x1);
  dd.mul(R, T, z, z1);
  dd.add(R, out, S, T);
  if (get(FLARE) === 0) return;
  dd.mul(R, S, FLARE, y);
  dd.mul(R, T, S, y1);
  dd.sub(R, out, out, T);
}

/** out = (dj pk − dk pj)². */
function squaredMinor(out: number, dj: number, dk: number, pj: number, pk: number): void {
  dd.mul(R, S, dj, pk);
  dd.mul(R, T, dk, pj);
  dd.sub(R, S, S, T);
  dd.sqr(R, out, S);
}

/** D/4 by the moment: it does not cancel however far away E is. */
function discriminant(): void {
  squaredMinor(D, Z, X, PZ, PX);
  dd.mul(R, U, RHO, A);
  dd.sub(R, D, U, D);
  if (get(FLARE) === 0) return;
  squaredMinor(U, Y, Z, PY, PZ);
  squaredMinor(B, X, Y, PX, PY);
  dd.add(R, U, U, B);
  dd.mul(R, S, FLARE, U);
  dd.add(R, D, D, S);
}

/** One ray that a filter left open; returns its verdict and fills the slot. */
export function solveSlowly(
  q: Quadric,
  Ex: number,
  Ey: number,
  Ez: number,
  dx: number,
  dy: number,
  dz: number,
  slot: CertifiedSlot,
): number {
  slot.exact = false;
  const verdict = inDoubleDouble(q, Ex, q.hasY ? Ey : 0, Ez, dx, q.hasY ? dy : 0, dz, slot);
  if (verdict >= 0) return verdict;
  slot.exact = true;
  return solveExactly(q, Ex, Ey, Ez, dx, dy, dz, slot);
}

const UNKNOWN = -1;

/** Fills the registers, scaled where it must be; UNKNOWN where a component would lose bits by that. */
function inDoubleDouble(
  q: Quadric,
  Ex: number,
  Ey: number,
  Ez: number,
  dx: number,
  dy: number,
  dz: number,
  slot: CertifiedSlot,
): number {
  const Cy = q.hasY ? q.Cy : 0;
  if (!setFlare(q)) return UNKNOWN;
  const speed = Math.max(Math.abs(dx), Math.abs(dy), Math.abs(dz));
  const length = Math.max(
    Math.max(Math.abs(Ex), Math.abs(Ey), Math.abs(Ez)),
    Math.max(Math.abs(q.Cx), Math.abs(Cy), Math.abs(q.Cz)),
    q.r,
  );
  // d = 0 about a cylinder's axis, or nothing but zeros: the exact stage knows what that means.
  if (speed === 0 || length === 0) return UNKNOWN;
  if (ordinary(speed) && ordinary(length)) {
    setDirection(dx, dy, dz);
    setLengths(Ex, Ey, Ez, q.Cx, Cy, q.Cz, q.r);
    return solveScaled(0, slot);
  }
  const k = exponentOf(speed);
  const l = exponentOf(length);
  setDirection(scale(dx, -k), scale(dy, -k), scale(dz, -k));
  setLengths(
    scale(Ex, -l),
    scale(Ey, -l),
    scale(Ez, -l),
    scale(q.Cx, -l),
    scale(Cy, -l),
    scale(q.Cz, -l),
    scale(q.r, -l),
  );
  const lossless =
    restores(dx, k) &&
    restores(dy, k) &&
    restores(dz, k) &&
    restores(Ex, l) &&
    restores(Ey, l) &&
    restores(Ez, l) &&
    restores(q.Cx, l) &&
    restores(Cy, l) &&
    restores(q.Cz, l) &&
    restores(q.r, l);
  return lossless ? solveScaled(l - k, slot) : UNKNOWN;
}

const ordinary = (x: number): boolean => x < ORDINARY && x > 1 / ORDINARY;

function setDirection(x: number, y: number, z: number): void {
  R[X] = x;
  R[X + 1] = 0;
  R[Y] = y;
  R[Y + 1] = 0;
  R[Z] = z;
  R[Z + 1] = 0;
}

function setLengths(
  Ex: number,
  Ey: number,
  Ez: number,
  Cx: number,
  Cy: number,
  Cz: number,
  r: number,
): void {
  setDifference(PX, Ex, Cx);
  setDifference(PY, Ey, Cy);
  setDifference(PZ, Ez, Cz);
  setSquare(RHO, r);
  R[RADIUS] = r;
}

const restores = (x: number, l: number): boolean => scale(scale(x, -l), l) === x;

/** a as a double-double, exactly; false where it is too large or, as a square, too small for that. */
function setFlare(q: Quadric): boolean {
  if (!q.squared) {
    R[FLARE] = q.flare;
    R[FLARE + 1] = 0;
    return Math.abs(q.flare) <= LARGEST_FLARE;
  }
  setSquare(FLARE, q.flare);
  const a = get(FLARE);
  return q.flare === 0 || (a <= LARGEST_FLARE && a >= SMALLEST_SQUARED);
}

/** Everything is in the registers; t counts in 2^e. */
function solveScaled(e: number, slot: CertifiedSlot): number {
  form(A, X, X, Y, Y, Z, Z);
  discriminant();
  const size = Math.abs(get(FLARE));
  const Am = get(X) ** 2 + get(Z) ** 2 + size * get(Y) ** 2;
  const Cm = get(PX) ** 2 + get(PZ) ** 2 + size * get(PY) ** 2 + get(RHO);
  const error = DISCRIMINANT_ERROR * Am * Cm + ABSOLUTE_ERROR;
  const d = get(D);
  if (!(Math.abs(d) > error)) return UNKNOWN;
  // A = 0 makes it 'one' and not 'two': A must be known not to vanish.
  const a = Math.abs(get(A));
  const errorA = 4 * EPSILON * Am + ABSOLUTE_ERROR;
  if (d < 0) return NONE;
  if (!(a > errorA)) return UNKNOWN;
  return roots(e, a, errorA, Am, Cm, error, slot);
}

/**
 * q = −(b + √D) with b's sign, then q/A and C/q. |δ√D| ≤ δD/√D + 4ε√D, twice what is needed (√(D + δ) − √D ≤ δ/(2√D)·(1 + …) for δ ≪ D, and
 * δD/√D for any δ < D); δq adds 5ε bm and a sum's ε|q|. The quotients' own error is under 2ε.
 */
function roots(
  e: number,
  a: number,
  errorA: number,
  Am: number,
  Cm: number,
  errorD: number,
  slot: CertifiedSlot,
): number {
  form(B, X, PX, Y, PY, Z, PZ);
  form(C, PX, PX, PY, PY, PZ, PZ);
  dd.sub(R, C, C, RHO);
  dd.sqrt(R, D, D);
  const s = get(D);
  const negative = get(B) < 0;
  if (negative) dd.sub(R, U, D, B);
  else {
    dd.add(R, U, B, D);
    dd.neg(R, U, U);
  }
  const size = Math.abs(get(U));
  const errorQ =
    (5 * EPSILON * Math.sqrt(Am * Cm) + errorD / s + 4 * EPSILON * s + ABSOLUTE_ERROR) / size +
    EPSILON;
  const c = Math.abs(get(C));
  const large = errorQ + errorA / a + 2 * EPSILON;
  if (!(large < FAITHFUL)) return UNKNOWN;
  const small = errorQ + (6 * EPSILON * Cm + ABSOLUTE_ERROR) / c + 2 * EPSILON;
  if (!(small < FAITHFUL) && !nearSurface(errorQ, Cm)) return UNKNOWN;
  dd.div(R, S, U, A);
  if (get(C) === 0) dd.set(R, T, 0);
  else dd.div(R, T, C, U);
  // Rounding twice, to 53 bits and then into the subnormals, stays faithful: a neighbour in the coarser grid is one in the finer.
  const t = scale(get(S), e);
  const other = scale(get(T), e);
  const ascending = get(S) <= get(T);
  slot.t0 = ascending ? t : other;
  slot.t1 = ascending ? other : t;
  return TWO;
}

const levels = newLevels();

/**
 * E so near to the surface that C cancels beyond twice the digits: C once more from the exact terms of its expansion, 38 at most, so
 * that it is off by 2^-184 of their sum (and 9u² of itself, from adding the levels). The sum of the terms' sizes is < 2Cm. A C that is
 * 0 exactly gives the root 0 exactly.
 */
function nearSurface(errorQ: number, Cm: number): boolean {
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
  if (exactlyZero(levels)) return true;
  for (let k = 1; k < LEVELS; k++) {
    dd.set(R, S, levels[k] as number);
    dd.add(R, C, C, S);
  }
  const error = (ACCUMULATED_ERROR * Cm + ABSOLUTE_ERROR) / Math.abs(get(C));
  return errorQ + error + 6 * EPSILON < FAITHFUL;
}

const ACCUMULATED_ERROR = 2 ** -180;

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
