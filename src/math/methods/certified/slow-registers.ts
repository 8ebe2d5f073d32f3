import type { Quadric } from '../../batch/quadric.ts';
import * as dd from '../../float/double-double.ts';
import { productError, squareError, sumError } from '../../float/eft.ts';
import { LARGEST_FLARE } from './slow-bounds.ts';

/* The second stage's numbers in double-double, and what is worked out from them: A, b, C and D/4. */

/** Places of double-doubles in the register file. */
export const R = new Float64Array(34);
export const X = 0;
export const Y = 2;
export const Z = 4;
export const PX = 6;
export const PY = 8;
export const PZ = 10;
export const FLARE = 12;
export const RHO = 14;
export const A = 16;
export const B = 18;
export const C = 20;
export const D = 22;
export const S = 24;
export const T = 26;
export const U = 28;
export const RADIUS = 30;
/** The bounds on the relative errors of the two roots, at S and T. */
export const BOUND = 32;

export const get = (i: number): number => R[i] as number;

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

/*
 * d is of doubles, p = E − C of double-doubles. So a product d·p is taken as p·hi, whose error is known, and a rest in double: 3u² of it. What is added to
 * such a pair is added to its parts, and normalised once.
 */

/** out = dj pj ± dk pk, by `sign`. */
function dot(out: number, dj: number, pj: number, dk: number, pk: number, sign: 1 | -1): void {
  const a = get(dj);
  const b = get(pj);
  const c = sign * get(dk);
  const e = get(pk);
  const p = a * b;
  const q = c * e;
  const s = p + q;
  const rest = productError(a, b, p) + a * get(pj + 1) + (productError(c, e, q) + c * get(pk + 1));
  const low = sumError(p, q, s) + rest;
  const hi = s + low;
  R[out] = hi;
  R[out + 1] = sumError(s, low, hi);
}

/** out −= a·(dy·y) for a double-double y. */
function subtractAlong(out: number, y: number): void {
  if (get(FLARE) === 0) return;
  dd.mulDouble(R, S, y, get(Y));
  dd.mul(R, S, S, FLARE);
  dd.sub(R, out, out, S);
}

/** A = dx² + dz² − a·dy². */
export function setA(): void {
  dot(A, X, X, Z, Z, 1);
  subtractAlong(A, Y);
}

/** b = dx px + dz pz − a·dy py. */
export function setB(): void {
  dot(B, X, PX, Z, PZ, 1);
  subtractAlong(B, PY);
}

/** C = px² + pz² − a·py² − ρ. */
export function setC(): void {
  dd.sqr(R, S, PX);
  dd.sqr(R, T, PZ);
  dd.add(R, C, S, T);
  if (get(FLARE) !== 0) {
    dd.sqr(R, S, PY);
    dd.mul(R, S, S, FLARE);
    dd.sub(R, C, C, S);
  }
  dd.sub(R, C, C, RHO);
}

/** out = (dj pk − dk pj)². */
function squaredMinor(out: number, dj: number, dk: number, pj: number, pk: number): void {
  dot(out, dj, pk, dk, pj, -1);
  dd.sqr(R, out, out);
}

/** D/4 by the moment: it does not cancel however far away E is. */
export function discriminant(): void {
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

export function setDirection(x: number, y: number, z: number): void {
  R[X] = x;
  R[X + 1] = 0;
  R[Y] = y;
  R[Y + 1] = 0;
  R[Z] = z;
  R[Z + 1] = 0;
}

export function setLengths(
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

/** a as a double-double; false where it is too large. */
export function setFlare(q: Quadric): boolean {
  if (q.squared) setSquare(FLARE, q.flare);
  else dd.set(R, FLARE, q.flare);
  return Math.abs(get(FLARE)) <= LARGEST_FLARE;
}
