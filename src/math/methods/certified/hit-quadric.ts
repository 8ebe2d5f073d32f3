import type { Quadric } from '../../batch/quadric.ts';
import { productError, SPLITTER, sumError } from '../../float/eft.ts';
import type { Hit } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import { ALGEBRA, FLARE, lost, P } from './algebra.ts';
import { FAITHFUL } from './faithful.ts';

/*
 * Point and normal from a root t + tl that is off by at most `off`. E + t d, p + t d: product and sum are split without loss, and what is left, ≤ u|X| and
 * a few u|t d|, is rounded: u² |X|, which is here, and 8u² |t d|, for which `off` must have room. A coordinate whose error is below u/4 of it is faithful
 * when it is rounded; one along which the line does not move is E's own.
 */
const UU = 2 ** -106;
/** Of the normal's longest component: its direction is promised within 2^-50. */
const STRAIGHT = 2 ** -52;
const LOST = 2 ** -1070;
const SMALLEST = 2 ** -600;

/** t, tl and off of the near root; the same of the far one. */
export const ROOTS = new Float64Array(6);

const at = (k: number): number => ALGEBRA[k] as number;

/** The hit at root k of ROOTS, which goes by the double that was `certified` for it, with E − C and a from ALGEBRA; null where a coordinate, or the way of the normal, stays open. */
export function hitAt(
  q: Quadric,
  { origin: E, direction: d }: Ray,
  k: number,
  certified: number,
): Hit | null {
  const t = ROOTS[k] as number;
  const tl = ROOTS[k + 1] as number;
  const off = ROOTS[k + 2] as number;
  let big = SPLITTER * t;
  const th = big - (big - t);
  const tm = t - th;
  const dx = d[0];
  const dy = d[1];
  const dz = d[2];
  const mx = t * dx;
  const my = t * dy;
  const mz = t * dz;
  big = SPLITTER * dx;
  const xh = big - (big - dx);
  big = SPLITTER * dy;
  const yh = big - (big - dy);
  big = SPLITTER * dz;
  const zh = big - (big - dz);
  const lx = lost(th, tm, xh, dx - xh, mx) + tl * dx;
  const ly = lost(th, tm, yh, dy - yh, my) + tl * dy;
  const lz = lost(th, tm, zh, dz - zh, mz) + tl * dz;
  const X = E[0] + mx;
  const Y = E[1] + my;
  const Z = E[2] + mz;
  const pointX = X + (sumError(E[0], mx, X) + lx);
  const pointY = Y + (sumError(E[1], my, Y) + ly);
  const pointZ = Z + (sumError(E[2], mz, Z) + lz);
  const offX = dx === 0 ? 0 : off * Math.abs(dx) + LOST;
  const offY = dy === 0 ? 0 : off * Math.abs(dy) + LOST;
  const offZ = dz === 0 ? 0 : off * Math.abs(dz) + LOST;
  const faithful =
    offX + 16 * UU * Math.abs(X) <= FAITHFUL * Math.abs(pointX) &&
    offY + 16 * UU * Math.abs(Y) <= FAITHFUL * Math.abs(pointY) &&
    offZ + 16 * UU * Math.abs(Z) <= FAITHFUL * Math.abs(pointZ);
  if (!faithful) return null;
  const px = at(P);
  const py = at(P + 2);
  const pz = at(P + 4);
  const nx = px + mx;
  const ny = py + my;
  const nz = pz + mz;
  const normalX = nx + (sumError(px, mx, nx) + lx + at(P + 1));
  const rise = sumError(py, my, ny) + ly + at(P + 3);
  const above = ny + rise;
  const normalZ = nz + (sumError(pz, mz, nz) + lz + at(P + 5));
  const a = at(FLARE);
  const down = a * above;
  const normalY = q.hasY
    ? -(down + (productError(a, above, down) + a * (rise - (above - ny)) + at(FLARE + 1) * above))
    : 0;
  const size = Math.abs(a);
  const long = Math.max(Math.abs(normalX), Math.abs(normalY), Math.abs(normalZ));
  const around = Math.abs(px) + Math.abs(pz) + size * Math.abs(py);
  if (!(offX + offZ + size * offY + 32 * UU * around + SMALLEST <= STRAIGHT * long)) return null;
  return {
    t: certified,
    point: [pointX + 0, pointY + 0, pointZ + 0],
    normal: [normalX + 0, normalY + 0, normalZ + 0],
    singular: false,
  };
}
