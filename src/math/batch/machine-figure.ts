import { NONE, ONE, UNDECIDED } from './batch.ts';
import { alongRay } from './machine-place.ts';
import type { Planar } from './planar.ts';
import { DX, FREE, type Machine } from './register-machine.ts';

/* The registers of a flat shape, two doubles each; vectors take three in a row. */
const place = (k: number): number => FREE + 2 * k;
export const NX = place(0);
export const NY = place(1);
export const NZ = place(2);
export const CORNER = place(3);
export const SIZE = place(6);
export const PX = place(7);
export const PY = place(8);
export const PZ = place(9);
export const RATE = place(10);
export const OFFSET = place(11);
export const T = place(12);
export const X = place(13);
export const Y = place(14);
export const Z = place(15);
/** And my, mz after it. */
const MX = place(16);
export const W = place(19);
const V = place(20);
export const ZERO = place(21);
export const REGISTERS = place(22);

/** Where component k of a vector stands. */
export const part = (vector: number, k: number): number => vector + 2 * k;

/**
 * Of the signs of left − right: one that is 1 decides against, one that is unknown leaves it open.
 */
function verdictOf(a: number, b: number, c = -1, d = -1): number {
  if (a > 0 || b > 0 || c > 0 || d > 0) return NONE;
  return Number.isNaN(a + b + c + d) ? UNDECIDED : ONE;
}

/** The course's conditions at X = E + t d. */
export function insideAtX(plane: Planar, m: Machine, R: Float64Array): number {
  alongRay(m, R, T, X, Y, Z);
  if (plane.bound === 'none') return ONE;
  if (plane.bound === 'circle') {
    m.sub(R, W, X, part(CORNER, 0));
    m.sqr(R, W, W);
    m.sub(R, V, Y, part(CORNER, 1));
    m.sqr(R, V, V);
    m.add(R, W, W, V);
    m.sub(R, V, Z, part(CORNER, 2));
    m.sqr(R, V, V);
    m.add(R, W, W, V);
    m.sqrt(R, W, W);
    m.sub(R, W, W, SIZE);
    return verdictOf(m.sign(R, W), -1);
  }
  return verdictOf(
    before(m, R, plane.u),
    beyond(m, R, plane.u),
    before(m, R, plane.v),
    beyond(m, R, plane.v),
  );
}

/** The sign of Pk − xk. */
function before(m: Machine, R: Float64Array, k: number): number {
  m.sub(R, W, part(CORNER, k), part(X, k));
  return m.sign(R, W);
}

/** The sign of xk − (Pk + L). */
function beyond(m: Machine, R: Float64Array, k: number): number {
  m.add(R, W, part(CORNER, k), SIZE);
  m.sub(R, W, part(X, k), W);
  return m.sign(R, W);
}

/** w = m × N into X, with the sign of N·d, then the conditions, then X = P + w / |N·d|. */
export function insideByMoment(plane: Planar, m: Machine, R: Float64Array, rate: number): number {
  cross(m, R, MX, DX, PX);
  cross(m, R, X, MX, NX);
  if (rate < 0) {
    m.neg(R, RATE, RATE);
    m.neg(R, X, X);
    m.neg(R, Y, Y);
    m.neg(R, Z, Z);
  }
  const verdict = plane.bound === 'none' ? ONE : conditionsByMoment(plane, m, R);
  for (let k = 0; k < 3; k++) {
    m.div(R, W, part(X, k), RATE);
    m.add(R, part(X, k), part(CORNER, k), W);
  }
  return verdict;
}

function conditionsByMoment(plane: Planar, m: Machine, R: Float64Array): number {
  if (plane.bound === 'circle') {
    m.sqr(R, W, X);
    m.sqr(R, V, Y);
    m.add(R, W, W, V);
    m.sqr(R, V, Z);
    m.add(R, W, W, V);
    m.sqr(R, V, SIZE);
    m.sqr(R, MX, RATE);
    m.mul(R, V, V, MX);
    m.sub(R, W, W, V);
    return verdictOf(m.sign(R, W), -1);
  }
  m.mul(R, V, SIZE, RATE);
  return verdictOf(
    below(m, R, plane.u),
    above(m, R, plane.u),
    below(m, R, plane.v),
    above(m, R, plane.v),
  );
}

/** The sign of 0 − wk. */
function below(m: Machine, R: Float64Array, k: number): number {
  m.sub(R, W, ZERO, part(X, k));
  return m.sign(R, W);
}

/** The sign of wk − L|N·d|. */
function above(m: Machine, R: Float64Array, k: number): number {
  m.sub(R, W, part(X, k), V);
  return m.sign(R, W);
}

/** a × b; `out` is none of them. */
function cross(m: Machine, R: Float64Array, out: number, a: number, b: number): void {
  for (let k = 0; k < 3; k++) {
    const i = k === 2 ? 0 : k + 1;
    const j = i === 2 ? 0 : i + 1;
    m.mul(R, part(out, k), part(a, i), part(b, j));
    m.mul(R, W, part(a, j), part(b, i));
    m.sub(R, part(out, k), part(out, k), W);
  }
}
