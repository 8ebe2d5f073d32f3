import { CONTAINED, NONE, ONE, UNDECIDED } from './batch.ts';
import type { Planar } from './planar.ts';

const finite = (x: number): boolean => x - x === 0;

/**
 * What the course's formula makes of one ray and one plane: its numbers, and where the plane is
 * met.
 */
interface PlanarSlot {
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

/** The verdict of the tree-walked method, operation by operation. */
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

/**
 * ≥ 0 where all conditions hold; one that fails decides, else one that is not finite leaves it
 * open.
 */
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
