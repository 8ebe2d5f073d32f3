import { type Answers, CONTAINED, NONE, ONE, type Rays, UNDECIDED } from './batch.ts';
import { type SolveRay, withoutRoots } from './loops.ts';
import { alongRay, type DiscriminantBy, loadRay } from './machine-quadric.ts';
import type { Planar } from './planar.ts';
import { DX, DY, DZ, EX, EY, EZ, FREE, type Machine } from './register-machine.ts';

/* The registers of a flat shape, two doubles each; vectors take three in a row. */
const place = (k: number): number => FREE + 2 * k;
const NX = place(0);
const NY = place(1);
const NZ = place(2);
const CORNER = place(3);
const SIZE = place(6);
const PX = place(7);
const PY = place(8);
const PZ = place(9);
const RATE = place(10);
const OFFSET = place(11);
const T = place(12);
const X = place(13);
const Y = place(14);
const Z = place(15);
/** And my, mz after it. */
const MX = place(16);
const W = place(19);
const V = place(20);
const ZERO = place(21);
const REGISTERS = place(22);

/** Where component k of a vector stands. */
const part = (vector: number, k: number): number => vector + 2 * k;

/** A flat shape in a register machine: methods/tree-method.ts unrolled, as machine-quadric.ts. */
export function machinePlanar(plane: Planar, machine: Machine, by: DiscriminantBy): SolveRay {
  const R = new Float64Array(REGISTERS);
  const m = machine;
  for (const k of [0, 1, 2] as const) {
    m.set(R, part(NX, k), plane.N[k]);
    m.set(R, part(CORNER, k), plane.P[k]);
  }
  m.set(R, SIZE, plane.size);
  m.set(R, ZERO, 0);
  return (rays, i, out) => {
    loadRay(rays, i, m, R);
    return solve(plane, m, R, by, rays, i, out);
  };
}

function solve(
  plane: Planar,
  m: Machine,
  R: Float64Array,
  by: DiscriminantBy,
  _: Rays,
  i: number,
  out: Answers,
): number {
  dot(m, R, RATE, DX, DY, DZ);
  m.sub(R, PX, EX, part(CORNER, 0));
  m.sub(R, PY, EY, part(CORNER, 1));
  m.sub(R, PZ, EZ, part(CORNER, 2));
  dot(m, R, OFFSET, PX, PY, PZ);
  const rate = m.sign(R, RATE);
  if (Number.isNaN(rate)) return withoutRoots(out, i, UNDECIDED);
  if (rate === 0) {
    const offset = m.sign(R, OFFSET);
    const verdict = Number.isNaN(offset) ? UNDECIDED : offset === 0 ? CONTAINED : NONE;
    return withoutRoots(out, i, verdict);
  }
  m.neg(R, T, OFFSET);
  m.div(R, T, T, RATE);
  const inside = by === 'moment' ? insideByMoment(plane, m, R, rate) : insideAtX(plane, m, R);
  if (inside !== ONE) return withoutRoots(out, i, inside);
  const t = m.toNumber(R, T);
  if (!Number.isFinite(t) || anyNaN(m, R)) return withoutRoots(out, i, UNDECIDED);
  out.t0[i] = t;
  out.t1[i] = Number.NaN;
  return ONE;
}

/** N·v. */
function dot(m: Machine, R: Float64Array, out: number, x: number, y: number, z: number): void {
  m.mul(R, out, NX, x);
  m.mul(R, W, NY, y);
  m.add(R, out, out, W);
  m.mul(R, W, NZ, z);
  m.add(R, out, out, W);
}

const anyNaN = (m: Machine, R: Float64Array): boolean =>
  Number.isNaN(m.toNumber(R, X)) ||
  Number.isNaN(m.toNumber(R, Y)) ||
  Number.isNaN(m.toNumber(R, Z));

/** Of the signs of left − right: one that is 1 decides against, one that is unknown leaves it open. */
function verdictOf(a: number, b: number, c = -1, d = -1): number {
  if (a > 0 || b > 0 || c > 0 || d > 0) return NONE;
  return Number.isNaN(a + b + c + d) ? UNDECIDED : ONE;
}

/** The course's conditions at X = E + t d. */
function insideAtX(plane: Planar, m: Machine, R: Float64Array): number {
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
function insideByMoment(plane: Planar, m: Machine, R: Float64Array, rate: number): number {
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
