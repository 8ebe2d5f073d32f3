import { type Answers, CONTAINED, NONE, ONE, type Rays, TANGENT, TWO, UNDECIDED } from './batch.ts';
import { type SolveRay, withoutRoots } from './loops.ts';
import type { Quadric } from './quadric.ts';
import { DX, DY, DZ, EX, EY, EZ, FREE, type Machine, ROOMY } from './register-machine.ts';

/* The registers of a curved shape, two doubles each. */
const place = (k: number): number => FREE + 2 * k;
const TWO_ = place(0);
const FOUR = place(1);
const CX = place(2);
const CY = place(3);
const CZ = place(4);
const FLARE = place(5);
const RHO = place(6);
const PX = place(7);
const PY = place(8);
const PZ = place(9);
const A = place(10);
const B = place(11);
const C = place(12);
const D = place(13);
const T0 = place(14);
const T1 = place(15);
const X = place(16);
const Y = place(17);
const Z = place(18);
const W = place(19);
const MINUS_FLARE = place(20);
const REGISTERS = place(21);

/** D by B² − 4AC, or by the moment; everything else is one program. */
export type DiscriminantBy = 'course' | 'moment';

/**
 * The stable solver over the course's A, B, C in a register machine: methods/tree-method.ts unrolled, operation by
 * operation. That class and roots are bit-equal to it is tested.
 */
export function machineQuadric(q: Quadric, machine: Machine, by: DiscriminantBy): SolveRay {
  const R = new Float64Array(REGISTERS);
  load(q, machine, R);
  // A hit's place and normal are only looked at where they might be no numbers.
  const slopes = 1 + machine.size(R, FLARE);
  const reach = Math.abs(q.Cx) + Math.abs(q.Cy) + Math.abs(q.Cz);
  return (rays, i, out) => {
    loadRay(rays, i, machine, R);
    coefficients(q, machine, R);
    if (by === 'moment') discriminantByMoment(q, machine, R);
    else discriminant(machine, R);
    const verdict = solve(machine, R);
    if (verdict === NONE || verdict >= CONTAINED) return withoutRoots(out, i, verdict);
    return keep(q, machine, R, out, i, verdict, slopes, reach);
  };
}

function load(q: Quadric, m: Machine, R: Float64Array): void {
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

export function loadRay(rays: Rays, i: number, m: Machine, R: Float64Array): void {
  m.set(R, EX, rays.Ex[i] as number);
  m.set(R, EY, rays.Ey[i] as number);
  m.set(R, EZ, rays.Ez[i] as number);
  m.set(R, DX, rays.dx[i] as number);
  m.set(R, DY, rays.dy[i] as number);
  m.set(R, DZ, rays.dz[i] as number);
}

function coefficients(q: Quadric, m: Machine, R: Float64Array): void {
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
function discriminant(m: Machine, R: Float64Array): void {
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
function discriminantByMoment(q: Quadric, m: Machine, R: Float64Array): void {
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

/** methods/solvers.ts: the class, with one root in T0 or both in T0 and T1. */
function solve(m: Machine, R: Float64Array): number {
  const signA = m.sign(R, A);
  if (signA === 0) return solveLinear(m, R);
  const signD = m.sign(R, D);
  if (Number.isNaN(signA) || Number.isNaN(signD)) return UNDECIDED;
  if (signD < 0) return NONE;
  if (signD === 0) {
    m.neg(R, T0, B);
    m.mul(R, X, TWO_, A);
    m.div(R, T0, T0, X);
    return TANGENT;
  }
  m.sqrt(R, X, D);
  if (m.sign(R, B) < 0) m.sub(R, X, X, B);
  else {
    m.add(R, X, B, X);
    m.neg(R, X, X);
  }
  m.div(R, X, X, TWO_);
  m.div(R, T0, X, A);
  m.div(R, T1, C, X);
  m.sort(R, T0, T1);
  return TWO;
}

function solveLinear(m: Machine, R: Float64Array): number {
  const signB = m.sign(R, B);
  if (Number.isNaN(signB)) return UNDECIDED;
  if (signB !== 0) {
    m.neg(R, T0, C);
    m.div(R, T0, T0, B);
    return ONE;
  }
  const signC = m.sign(R, C);
  if (Number.isNaN(signC)) return UNDECIDED;
  return signC === 0 ? CONTAINED : NONE;
}

/** Writes the roots, unless one of them or its place or normal is no number. */
function keep(
  q: Quadric,
  m: Machine,
  R: Float64Array,
  out: Answers,
  i: number,
  verdict: number,
  slopes: number,
  reach: number,
): number {
  const d = m.size(R, DX) + m.size(R, DY) + m.size(R, DZ);
  const start = m.size(R, EX) + m.size(R, EY) + m.size(R, EZ) + reach;
  const t = Math.max(m.size(R, T0), verdict === TWO ? m.size(R, T1) : 0);
  const roomy = slopes * (start + (1 + t) * (1 + d)) < ROOMY;
  if (!roomy && !isWhole(q, m, R, T0)) return withoutRoots(out, i, UNDECIDED);
  if (!roomy && verdict === TWO && !isWhole(q, m, R, T1)) return withoutRoots(out, i, UNDECIDED);
  out.t0[i] = m.toNumber(R, T0);
  out.t1[i] = verdict === TWO ? m.toNumber(R, T1) : Number.NaN;
  return verdict;
}

/** t is finite, and neither E + t d nor the normal there has a component that is NaN. */
function isWhole(q: Quadric, m: Machine, R: Float64Array, t: number): boolean {
  if (!Number.isFinite(m.toNumber(R, t))) return false;
  alongRay(m, R, t, X, Y, Z);
  if (isNaNAt(m, R, X) || isNaNAt(m, R, Y) || isNaNAt(m, R, Z)) return false;
  m.sub(R, X, X, CX);
  m.sub(R, Z, Z, CZ);
  if (isNaNAt(m, R, X) || isNaNAt(m, R, Z)) return false;
  if (!q.hasY) return true;
  m.sub(R, Y, Y, CY);
  m.mul(R, Y, MINUS_FLARE, Y);
  return !isNaNAt(m, R, Y);
}

const isNaNAt = (m: Machine, R: Float64Array, a: number): boolean => Number.isNaN(m.toNumber(R, a));

/** E + t d. */
export function alongRay(
  m: Machine,
  R: Float64Array,
  t: number,
  x: number,
  y: number,
  z: number,
): void {
  m.mul(R, x, t, DX);
  m.add(R, x, EX, x);
  m.mul(R, y, t, DY);
  m.add(R, y, EY, y);
  m.mul(R, z, t, DZ);
  m.add(R, z, EZ, z);
}
