import {
  type Answers,
  CONTAINED,
  type Kernel,
  list,
  NONE,
  ONE,
  type Rays,
  selectFirst,
  UNDECIDED,
} from './batch.ts';
import type { Planar } from './planar.ts';

const finite = (x: number): boolean => x - x === 0;

/** What the course's formula makes of one ray and one plane: its numbers, and where the plane is met. */
export interface PlanarSlot {
  offset: number;
  rate: number;
  /** Not a number where the line is parallel or the method cannot tell. */
  t: number;
  x: number;
  y: number;
  z: number;
  /** ≥ 0 inside, NaN where the method cannot tell. */
  margin: number;
}

export const planarSlot = (): PlanarSlot => ({
  offset: 0,
  rate: 0,
  t: 0,
  x: 0,
  y: 0,
  z: 0,
  margin: 0,
});

/** The verdict of the tree-walked rung, operation by operation. */
export function solvePlanar(
  s: Planar,
  Ex: number,
  Ey: number,
  Ez: number,
  dx: number,
  dy: number,
  dz: number,
  slot: PlanarSlot,
): number {
  const [Nx, Ny, Nz] = s.N;
  const [Px, Py, Pz] = s.P;
  const offset = Nx * (Ex - Px) + Ny * (Ey - Py) + Nz * (Ez - Pz);
  const rate = Nx * dx + Ny * dy + Nz * dz;
  slot.offset = offset;
  slot.rate = rate;
  slot.t = Number.NaN;
  slot.margin = Number.NaN;
  if (rate === 0 || !finite(rate)) {
    if (!finite(rate) || !finite(offset)) return UNDECIDED;
    return offset === 0 ? CONTAINED : NONE;
  }
  const t = -offset / rate;
  slot.t = t;
  slot.x = Ex + t * dx;
  slot.y = Ey + t * dy;
  slot.z = Ez + t * dz;
  slot.margin = marginOf(s, slot);
  if (Number.isNaN(slot.margin)) return UNDECIDED;
  if (slot.margin < 0) return NONE;
  // A hit that overflowed is no answer.
  const told = finite(t) && !Number.isNaN(slot.x) && !Number.isNaN(slot.y) && !Number.isNaN(slot.z);
  return told ? ONE : UNDECIDED;
}

/** ≥ 0 where all conditions hold; one that fails decides, else one that is not finite leaves it open. */
function marginOf(s: Planar, { x, y, z }: PlanarSlot): number {
  if (s.bound === 'none') return 1;
  const [Px, Py, Pz] = s.P;
  if (s.bound === 'circle') {
    const a = x - Px;
    const b = y - Py;
    const c = z - Pz;
    const margin = s.size - Math.sqrt(a * a + b * b + c * c);
    return finite(margin) ? margin : Number.NaN;
  }
  const u = s.u === 0 ? x : y;
  const v = s.v === 2 ? z : y;
  const Pu = s.u === 0 ? Px : Py;
  const Pv = s.v === 2 ? Pz : Py;
  const m1 = u - Pu;
  const m2 = Pu + s.size - u;
  const m3 = v - Pv;
  const m4 = Pv + s.size - v;
  const failed =
    (m1 < 0 && finite(m1)) ||
    (m2 < 0 && finite(m2)) ||
    (m3 < 0 && finite(m3)) ||
    (m4 < 0 && finite(m4));
  if (failed) return -1;
  const told = finite(m1) && finite(m2) && finite(m3) && finite(m4);
  return told ? Math.min(m1, m2, m3, m4) : Number.NaN;
}

/** The course's formula over arrays, for flat shapes. */
export function textbookPlanar(s: Planar): Kernel {
  const slot = planarSlot();
  const loop = s.bound === 'none' ? planes : s.bound === 'circle' ? circles : squares;
  return {
    met: 'one',
    classes: (rays, out) => loop(s, rays, out, slot),
    both: (rays, out) => loop(s, rays, out, slot),
    first(rays, tMin, tMax, out) {
      loop(s, rays, out, slot);
      selectFirst(out, rays.count, tMin, tMax);
    },
  };
}

function solveOne(s: Planar, rays: Rays, i: number, out: Answers, slot: PlanarSlot): void {
  const { Ex, Ey, Ez, dx, dy, dz } = rays;
  const verdict = solvePlanar(
    s,
    Ex[i] as number,
    Ey[i] as number,
    Ez[i] as number,
    dx[i] as number,
    dy[i] as number,
    dz[i] as number,
    slot,
  );
  out.t0[i] = verdict === ONE ? slot.t : Number.NaN;
  out.t1[i] = Number.NaN;
  out.margin[i] = verdict === ONE ? 1 : -1;
  if (verdict !== NONE && verdict !== ONE) list(out, i, verdict);
}

/** What every number stays below if nothing overflowed. */
const LARGE = 2 ** 500;

function planes(s: Planar, rays: Rays, out: Answers, slot: PlanarSlot): void {
  const { count, Ex, Ey, Ez, dx, dy, dz } = rays;
  const { t0, t1, margin } = out;
  const [Nx, Ny, Nz] = s.N;
  const [Px, Py, Pz] = s.P;
  out.rareCount = 0;
  for (let i = 0; i < count; i++) {
    const offset =
      Nx * ((Ex[i] as number) - Px) + Ny * ((Ey[i] as number) - Py) + Nz * ((Ez[i] as number) - Pz);
    const rate = Nx * (dx[i] as number) + Ny * (dy[i] as number) + Nz * (dz[i] as number);
    const t = -offset / rate;
    if (Math.abs(t) < LARGE && Math.abs(rate) < LARGE) {
      t0[i] = t;
      t1[i] = Number.NaN;
      margin[i] = 1;
    } else solveOne(s, rays, i, out, slot);
  }
}

function circles(s: Planar, rays: Rays, out: Answers, slot: PlanarSlot): void {
  const { count, Ex, Ey, Ez, dx, dy, dz } = rays;
  const { t0, t1, margin } = out;
  const [Nx, Ny, Nz] = s.N;
  const [Px, Py, Pz] = s.P;
  const r = s.size;
  out.rareCount = 0;
  for (let i = 0; i < count; i++) {
    const ex = Ex[i] as number;
    const ey = Ey[i] as number;
    const ez = Ez[i] as number;
    const x = dx[i] as number;
    const y = dy[i] as number;
    const z = dz[i] as number;
    const offset = Nx * (ex - Px) + Ny * (ey - Py) + Nz * (ez - Pz);
    const rate = Nx * x + Ny * y + Nz * z;
    const t = -offset / rate;
    const a = ex + t * x - Px;
    const b = ey + t * y - Py;
    const c = ez + t * z - Pz;
    const left = r - Math.sqrt(a * a + b * b + c * c);
    if (Math.abs(t) < LARGE && Math.abs(rate) < LARGE && Math.abs(left) < LARGE) {
      t0[i] = left >= 0 ? t : Number.NaN;
      t1[i] = Number.NaN;
      margin[i] = left;
    } else solveOne(s, rays, i, out, slot);
  }
}

function squares(s: Planar, rays: Rays, out: Answers, slot: PlanarSlot): void {
  const { count, Ex, Ey, Ez, dx, dy, dz } = rays;
  const { t0, t1, margin } = out;
  const [Nx, Ny, Nz] = s.N;
  const [Px, Py, Pz] = s.P;
  const first = s.u === 0;
  const last = s.v === 2;
  const Eu = first ? Ex : Ey;
  const Ev = last ? Ez : Ey;
  const du = first ? dx : dy;
  const dv = last ? dz : dy;
  const Pu = first ? Px : Py;
  const Pv = last ? Pz : Py;
  const Qu = Pu + s.size;
  const Qv = Pv + s.size;
  out.rareCount = 0;
  for (let i = 0; i < count; i++) {
    const offset =
      Nx * ((Ex[i] as number) - Px) + Ny * ((Ey[i] as number) - Py) + Nz * ((Ez[i] as number) - Pz);
    const rate = Nx * (dx[i] as number) + Ny * (dy[i] as number) + Nz * (dz[i] as number);
    const t = -offset / rate;
    const u = (Eu[i] as number) + t * (du[i] as number);
    const v = (Ev[i] as number) + t * (dv[i] as number);
    const left = Math.min(Math.min(u - Pu, Qu - u), Math.min(v - Pv, Qv - v));
    if (
      Math.abs(t) < LARGE &&
      Math.abs(rate) < LARGE &&
      Math.abs(left) < LARGE &&
      Math.abs(u) < LARGE &&
      Math.abs(v) < LARGE
    ) {
      t0[i] = left >= 0 ? t : Number.NaN;
      t1[i] = Number.NaN;
      margin[i] = left;
    } else solveOne(s, rays, i, out, slot);
  }
}
