import type { Rays } from './batch.ts';
import { CX, CY, CZ, MINUS_FLARE, X, Y, Z } from './machine-forms.ts';
import type { Quadric } from './quadric.ts';
import { DX, DY, DZ, EX, EY, EZ, type Machine, ROOMY } from './register-machine.ts';

/* A ray in a register machine, its points, and whether these and their normals are numbers. */

export function loadRay(rays: Rays, i: number, m: Machine, R: Float64Array): void {
  m.load(R, EX, rays.Ex, i);
  m.load(R, EY, rays.Ey, i);
  m.load(R, EZ, rays.Ez, i);
  m.load(R, DX, rays.dx, i);
  m.load(R, DY, rays.dy, i);
  m.load(R, DZ, rays.dz, i);
}

/** Places at ±t and nearer, and the normals there, are far from leaving the machine's range. */
export function isRoomy(
  m: Machine,
  R: Float64Array,
  t: number,
  slopes: number,
  reach: number,
): boolean {
  const d = m.size(R, DX) + m.size(R, DY) + m.size(R, DZ);
  const start = m.size(R, EX) + m.size(R, EY) + m.size(R, EZ) + reach;
  return slopes * (start + (1 + t) * (1 + d)) < ROOMY;
}

/** t is finite, and neither E + t d nor the normal there has a component that is NaN. */
export function isWhole(q: Quadric, m: Machine, R: Float64Array, t: number): boolean {
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
