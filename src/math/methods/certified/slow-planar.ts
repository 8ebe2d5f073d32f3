import { type Answers, NONE, ONE, type Rays } from '../../batch/batch.ts';
import { solvePlanarExactly } from '../../batch/exact-planar.ts';
import type { Planar } from '../../batch/planar.ts';
import * as dd from '../../float/double-double.ts';
import { sumError } from '../../float/eft.ts';
import { FAITHFUL } from './faithful.ts';
import { marginsOf } from './figure.ts';
import { BOX } from './scaled-quadric.ts';
import type { CertifiedSlot } from './slow-quadric.ts';

/*
 * Second stage: N·d and N·p in double-double (float/double-double.ts has the sources). Products of doubles are exact; a sum is off by 3u² of itself. Of three products
 * the first two add up to (Σ|Ni di| + |N·d|)/2 at most, as the third one makes up for the rest: 1.5u² Σ|Ni di|, and 4.5u² of N·d. p is a double-double, and its
 * products are off by 5u² more: 6.5u² Σ|Ni pi|, and 4.5u² of N·p. The quotient is off by that and the division's own 9.8u²: 18.8u².
 * The figure's rim and edge, where the filter cannot tell, go to the exact stage: they are few.
 */
export const R = new Float64Array(16);
const NN = 0;
const V = 2;
const PRODUCT = 4;
const RATE = 6;
const OFFSET = 8;
export const T = 10;
const ERROR_RATE = 1.6 * 2 ** -106;
const ERROR_OFFSET = 6.7 * 2 ** -106;
const ERROR_QUOTIENT = 19 * 2 ** -106;
/** Of N·d and N·p. Both are below 2^200, and with FAITHFUL above SMALLEST·2^55 = 2^-768, so t is between 2^-968 and 2^968, as the division wants it. */
export const SMALLEST = 2 ** -823;
const ordinary = (x: number): boolean => x < BOX && x > 1 / BOX;

function addProduct(out: number, n: number, hi: number, lo: number): void {
  dd.set(R, NN, n);
  R[V] = hi;
  R[V + 1] = lo;
  dd.mul(R, PRODUCT, NN, V);
  dd.add(R, out, out, PRODUCT);
}

/** The double-double root at R[T], for ordinary numbers; returns the bound on its relative error, or Infinity where there is none. */
export function rootInTwice(s: Planar, rays: Rays, i: number): number {
  const Ex = rays.Ex[i] as number;
  const Ey = rays.Ey[i] as number;
  const Ez = rays.Ez[i] as number;
  const dx = rays.dx[i] as number;
  const dy = rays.dy[i] as number;
  const dz = rays.dz[i] as number;
  const [Nx, Ny, Nz] = s.N;
  const px = Ex - s.P[0];
  const py = Ey - s.P[1];
  const pz = Ez - s.P[2];
  const sizeN = Math.abs(Nx) + Math.abs(Ny) + Math.abs(Nz);
  const Sd = Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
  const Sp = Math.abs(px) + Math.abs(py) + Math.abs(pz);
  if (!ordinary(sizeN) || !ordinary(Sd) || !ordinary(Sp)) return Number.POSITIVE_INFINITY;
  dd.set(R, RATE, 0);
  addProduct(RATE, Nx, dx, 0);
  addProduct(RATE, Ny, dy, 0);
  addProduct(RATE, Nz, dz, 0);
  dd.set(R, OFFSET, 0);
  addProduct(OFFSET, Nx, px, sumError(Ex, -s.P[0], px));
  addProduct(OFFSET, Ny, py, sumError(Ey, -s.P[1], py));
  addProduct(OFFSET, Nz, pz, sumError(Ez, -s.P[2], pz));
  const rate = R[RATE] as number;
  const offset = R[OFFSET] as number;
  dd.div(R, T, OFFSET, RATE);
  dd.neg(R, T, T);
  return (
    (ERROR_RATE * (Math.abs(Nx * dx) + Math.abs(Ny * dy) + Math.abs(Nz * dz)) + SMALLEST) /
      Math.abs(rate) +
    (ERROR_OFFSET * (Math.abs(Nx * px) + Math.abs(Ny * py) + Math.abs(Nz * pz)) + SMALLEST) /
      Math.abs(offset) +
    ERROR_QUOTIENT
  );
}

/** Ray i, which the first stage left open; overwrites its margin and t1. */
export function solvePlanarSlowly(
  s: Planar,
  rays: Rays,
  i: number,
  { margin, t1 }: Answers,
  slot: CertifiedSlot,
): number {
  slot.exact = false;
  if (rootInTwice(s, rays, i) < FAITHFUL) {
    margin[i] = R[RATE] as number;
    marginsOf(s)(s, rays, i, i + 1, margin, t1);
    const inside = margin[i] as number;
    if (Math.abs(inside) > (t1[i] as number)) {
      slot.t0 = R[T] as number;
      slot.t1 = Number.NaN;
      return inside < 0 ? NONE : ONE;
    }
  }
  slot.exact = true;
  const { Ex, Ey, Ez, dx, dy, dz } = rays;
  return solvePlanarExactly(
    s,
    Ex[i] as number,
    Ey[i] as number,
    Ez[i] as number,
    dx[i] as number,
    dy[i] as number,
    dz[i] as number,
    slot,
  );
}
