import { type Answers, CONTAINED, NONE, ONE, type Rays, UNDECIDED } from './batch.ts';
import { type SolveRay, withoutRoots } from './loops.ts';
import {
  CORNER,
  insideAtX,
  insideByMoment,
  NX,
  NY,
  NZ,
  OFFSET,
  PX,
  PY,
  PZ,
  part,
  RATE,
  REGISTERS,
  SIZE,
  T,
  W,
  X,
  Y,
  Z,
  ZERO,
} from './machine-figure.ts';
import { loadRay } from './machine-place.ts';
import type { DiscriminantBy } from './machine-quadric.ts';
import type { Planar } from './planar.ts';
import { DX, DY, DZ, EX, EY, EZ, type Machine } from './register-machine.ts';

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
