import { type Answers, type Kernel, list, NONE, ONE, type Rays, selectFirst } from './batch.ts';
import type { Planar } from './planar.ts';
import { type PlanarSlot, planarSlot, solvePlanar } from './textbook-planar-scalar.ts';

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
