import type { Quadric } from './quadric.ts';
import { DX, DY, DZ, EX, EY, EZ, FREE, type Machine } from './register-machine.ts';

/* The registers of a curved shape, two doubles each. */
const place = (k: number): number => FREE + 2 * k;
export const TWO_ = place(0);
const FOUR = place(1);
export const CX = place(2);
export const CY = place(3);
export const CZ = place(4);
export const FLARE = place(5);
const RHO = place(6);
const PX = place(7);
const PY = place(8);
const PZ = place(9);
export const A = place(10);
export const B = place(11);
export const C = place(12);
export const D = place(13);
export const T0 = place(14);
export const T1 = place(15);
export const X = place(16);
export const Y = place(17);
export const Z = place(18);
const W = place(19);
export const MINUS_FLARE = place(20);
export const REGISTERS = place(21);

/**
 * A, B, C and D of a curved shape in a register machine: its trees unrolled, operation by
 * operation.
 */
export function loadShape(q: Quadric, m: Machine, R: Float64Array): void {
  m.set(R, TWO_, 2);
  m.set(R, FOUR, 4);
  m.set(R, CX, q.Cx);
  m.set(R, CY, q.Cy);
  m.set(R, CZ, q.Cz);
  m.set(R, FLARE, q.flare);
  if (q.squared) m.sqr(R, FLARE, FLARE);
  m.neg(R, MINUS_FLARE, FLARE);
  m.set(R, RHO, q.r);
  m.sqr(R, RHO, RHO);
}

export function coefficients(q: Quadric, m: Machine, R: Float64Array): void {
  m.sub(R, PX, EX, CX);
  m.sub(R, PZ, EZ, CZ);
  m.sqr(R, A, DX);
  m.sqr(R, X, DZ);
  m.add(R, A, A, X);
  m.mul(R, B, TWO_, DX);
  m.mul(R, B, B, PX);
  m.mul(R, X, TWO_, DZ);
  m.mul(R, X, X, PZ);
  m.add(R, B, B, X);
  m.sqr(R, C, PX);
  m.sqr(R, X, PZ);
  m.add(R, C, C, X);
  if (q.hasY) {
    m.sub(R, PY, EY, CY);
    m.sqr(R, X, DY);
    m.mul(R, X, FLARE, X);
    m.sub(R, A, A, X);
    m.mul(R, X, TWO_, FLARE);
    m.mul(R, X, X, DY);
    m.mul(R, X, X, PY);
    m.sub(R, B, B, X);
    m.sqr(R, X, PY);
    m.mul(R, X, FLARE, X);
    m.sub(R, C, C, X);
  }
  if (q.hasR) m.sub(R, C, C, RHO);
}

/** B² − 4AC. */
export function discriminant(m: Machine, R: Float64Array): void {
  m.sqr(R, D, B);
  m.mul(R, X, FOUR, A);
  m.mul(R, X, X, C);
  m.sub(R, D, D, X);
}

/** ab − cd into out. */
function minor(
  m: Machine,
  R: Float64Array,
  out: number,
  a: number,
  b: number,
  c: number,
  d: number,
): void {
  m.mul(R, out, a, b);
  m.mul(R, W, c, d);
  m.sub(R, out, out, W);
}

/** 4(ρA + a(mx² + mz²) − my²). */
export function discriminantByMoment(q: Quadric, m: Machine, R: Float64Array): void {
  minor(m, R, Y, DZ, PX, DX, PZ);
  m.sqr(R, Y, Y);
  if (q.hasY) {
    minor(m, R, X, DY, PZ, DZ, PY);
    minor(m, R, Z, DX, PY, DY, PX);
    m.sqr(R, X, X);
    m.sqr(R, Z, Z);
    m.add(R, X, X, Z);
    m.mul(R, X, FLARE, X);
  }
  if (q.hasR) m.mul(R, D, RHO, A);
  if (q.hasR && q.hasY) m.add(R, D, D, X);
  m.sub(R, D, q.hasR ? D : X, Y);
  m.mul(R, D, FOUR, D);
}
