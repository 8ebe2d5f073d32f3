import {
  type Answers,
  checkRay,
  type Kernel,
  list,
  NONE,
  ONE,
  type Rays,
  selectFirst,
} from '../../batch/batch.ts';
import type { Planar } from '../../batch/planar.ts';
import { sumError } from '../../float/eft.ts';
import { marginsOf } from './figure.ts';
import type { OpenRays } from './roots-quadric.ts';
import { BOX } from './scaled-quadric.ts';
import { solvePlanarSlowly } from './slow-planar.ts';
import { certifiedSlot } from './slow-quadric.ts';

/*
 * Flat shapes. With p = E − P and m = d × p, where N·d ≠ 0:  t = −N·p / N·d and X − P = (m × N) / (N·d).
 *
 * First stage, on grids as in roots-quadric.ts: N, d and p are cut into 25 or 26 leading bits and a rest, so that the leading products of
 * N·d and N·p and their sums are exact, and what is left over (≤ 2^-23 of |N|₁|d|₁, |N|₁|p|₁) is off by < 2^-73 of these. Where
 * neither cancels to less than LEAST_SHARE = 2^-16 of its terms both are known to 2^-57. One division gives t0, off by 3u; its leading 25 bits
 * th are the root that is corrected: the remainder o + th·r is exact in its leading part, ≤ 2^-23|o|, and its rest off by what o and r are, so
 * t = th − remainder / r is off by < 2^-55 |t| before it is rounded once: faithful, which needs 2^-54.
 *
 * The figure: figure.ts.
 */
export const GRID_25 = 2 ** 29;
export const GRID_26 = 2 ** 28;
export const LEAST_SHARE = 2 ** -16;

export function certifiedPlanar(s: Planar): Kernel {
  const slot = certifiedSlot();
  const left: OpenRays = { count: 0, open: new Int32Array(0) };

  function both(rays: Rays, out: Answers): void {
    out.rareCount = 0;
    if (left.open.length < rays.count) left.open = new Int32Array(rays.count);
    planarRoots(s, rays, out, left);
    for (let k = 0; k < left.count; k++) {
      const i = left.open[k] as number;
      checkRay(rays, i, true, out);
      const verdict = solvePlanarSlowly(s, rays, i, out, slot);
      out.t0[i] = verdict === ONE ? slot.t0 : Number.NaN;
      out.t1[i] = Number.NaN;
      out.margin[i] = verdict === ONE ? 1 : -1;
      if (verdict !== NONE && verdict !== ONE) list(out, i, verdict);
    }
  }

  return {
    met: 'one',
    both,
    classes: both,
    first(rays, tMin, tMax, out) {
      both(rays, out);
      selectFirst(out, rays.count, tMin, tMax);
    },
  };
}

/** The first stage over all rays; those that it cannot certify are left open. */
export function planarRoots(s: Planar, rays: Rays, out: Answers, left: OpenRays): void {
  const sizeN = Math.abs(s.N[0]) + Math.abs(s.N[1]) + Math.abs(s.N[2]);
  const inBox = sizeN < BOX && sizeN > 1 / BOX;
  const { count, Ex, Ey, Ez, dx, dy, dz } = rays;
  const { t0, t1, margin } = out;
  const [Nx, Ny, Nz] = s.N;
  const [Px, Py, Pz] = s.P;
  const gridN = GRID_25 * sizeN;
  const nx = Nx + gridN - gridN;
  const ny = Ny + gridN - gridN;
  const nz = Nz + gridN - gridN;
  const mx = Nx - nx;
  const my = Ny - ny;
  const mz = Nz - nz;
  for (let i = 0; i < count; i++) {
    const x = dx[i] as number;
    const y = dy[i] as number;
    const z = dz[i] as number;
    const ex = Ex[i] as number;
    const ey = Ey[i] as number;
    const ez = Ez[i] as number;
    const px = ex - Px;
    const py = ey - Py;
    const pz = ez - Pz;
    const Sd = Math.abs(x) + Math.abs(y) + Math.abs(z);
    const Sp = Math.abs(px) + Math.abs(py) + Math.abs(pz);
    const gridD = GRID_26 * Sd;
    const gridP = GRID_26 * Sp;
    const xh = x + gridD - gridD;
    const yh = y + gridD - gridD;
    const zh = z + gridD - gridD;
    const phx = px + gridP - gridP;
    const phy = py + gridP - gridP;
    const phz = pz + gridP - gridP;
    const plx = px - phx + sumError(ex, -Px, px);
    const ply = py - phy + sumError(ey, -Py, py);
    const plz = pz - phz + sumError(ez, -Pz, pz);
    const rh = nx * xh + ny * yh + nz * zh;
    const rl = nx * (x - xh) + ny * (y - yh) + nz * (z - zh) + (mx * x + my * y + mz * z);
    const oh = nx * phx + ny * phy + nz * phz;
    const ol = nx * plx + ny * ply + nz * plz + (mx * px + my * py + mz * pz);
    const r = rh + rl;
    const o = oh + ol;
    const inverse = 1 / r;
    const coarse = -o * inverse;
    const gridT = GRID_25 * coarse;
    const th = coarse + gridT - gridT;
    const gridR = GRID_26 * r;
    const rhh = rh + gridR - gridR;
    const rest = oh + th * rhh + (ol + th * (rh - rhh + rl));
    const t = th - rest * inverse;
    t0[i] = t;
    const certain =
      inBox &&
      Sd < BOX &&
      Sd > 1 / BOX &&
      Sp < BOX &&
      Sp > 1 / BOX &&
      Math.abs(r) > LEAST_SHARE * (sizeN * Sd) &&
      Math.abs(o) > LEAST_SHARE * (sizeN * Sp);
    margin[i] = certain ? r : Number.NaN;
  }
  marginsOf(s)(s, rays, 0, count, margin, t1);
  left.count = 0;
  for (let i = 0; i < count; i++) {
    const inside = margin[i] as number;
    if (!(Math.abs(inside) > (t1[i] as number))) left.open[left.count++] = i;
    else if (inside < 0) t0[i] = Number.NaN;
    t1[i] = Number.NaN;
  }
}
