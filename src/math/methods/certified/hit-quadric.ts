import type { Quadric } from '../../batch/quadric.ts';
import { productError, SPLITTER, sumError } from '../../float/eft.ts';
import type { Hit } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import { type Algebra, FLARE, lost, P } from './algebra.ts';
import { FAITHFUL } from './faithful.ts';

/*
 * Point and normal from a root t + tl that is off by at most `off`. E + t d, p + t d: product and sum are split without loss, and what is left, ≤ u|X| and
 * a few u|t d|, is rounded: u² |X|, which is here, and 8u² |t d|, for which `off` must have room. A coordinate whose error is below u/4 of it is faithful
 * when it is rounded; one along which the line does not move is E's own.
 */
const UU = 2 ** -106;
/** Of the normal's longest component: its direction is promised within 2^-50. */
const STRAIGHT = 2 ** -52;
export const LOST = 2 ** -1070;
export const SMALLEST = 2 ** -600;

/**
 * t, tl and off of the near root; the same of the far one. Each stage has its own, as with Algebra.
 */
export type Roots = Float64Array;
export const createRoots = (): Roots => new Float64Array(6);

/**
 * The hit at root k of `roots`, which goes by the double that was `certified` for it, with E − C
 * and a from `algebra`; null where a coordinate, or the way of the normal, stays open.
 */
export function hitAt(
  q: Quadric,
  { origin: E, direction: d }: Ray,
  algebra: Algebra,
  roots: Roots,
  k: number,
  certified: number,
): Hit | null {
  const t = roots[k] as number;
  const tl = roots[k + 1] as number;
  const off = roots[k + 2] as number;
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
  const px = algebra[P] as number;
  const py = algebra[P + 2] as number;
  const pz = algebra[P + 4] as number;
  const nx = px + mx;
  const ny = py + my;
  const nz = pz + mz;
  const normalX = nx + (sumError(px, mx, nx) + lx + (algebra[P + 1] as number));
  const rise = sumError(py, my, ny) + ly + (algebra[P + 3] as number);
  const above = ny + rise;
  const normalZ = nz + (sumError(pz, mz, nz) + lz + (algebra[P + 5] as number));
  const a = algebra[FLARE] as number;
  const down = a * above;
  const normalY = q.hasY
    ? -(
        down +
        (productError(a, above, down) +
          a * (rise - (above - ny)) +
          (algebra[FLARE + 1] as number) * above)
      )
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
