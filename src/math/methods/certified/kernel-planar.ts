import {
  type Answers,
  type Kernel,
  list,
  NONE,
  ONE,
  type Rays,
  selectFirst,
} from '../../batch/batch.ts';
import { solvePlanarExactly } from '../../batch/exact-planar.ts';
import type { Planar } from '../../batch/planar.ts';
import * as dd from '../../float/double-double.ts';
import { sumError } from '../../float/eft.ts';
import type { OpenRays } from './roots-quadric.ts';
import { type CertifiedSlot, certifiedSlot } from './slow-quadric.ts';

/*
 * Flat shapes. With p = E − P and m = d × p, where N·d ≠ 0:  t = −N·p / N·d and X − P = (m × N) / (N·d).
 *
 * First stage, on grids as in roots-quadric.ts: N, d and p are cut into 25 or 26 leading bits and a rest, so that the leading products of
 * N·d and N·p and their sums are exact, and what is left over (≤ 2^-23 of |N|₁|d|₁, |N|₁|p|₁) is off by < 2^-72 of these. Where
 * neither cancels by more than LEAST_SHARE both are known to 2^-62. One division gives t0, off by 3u; its leading 25 bits th are the root
 * that is corrected: the remainder o + th·r is exact in its leading part, ≤ 2^-23|o|, hence off by < 2^-61|o| with its rest, and
 * t = th − remainder / r is off by < 2^-60 |t| before it is rounded once: faithful, which needs 2^-54.
 *
 * The figure: w = m × N against r|N·d| (circle) or w = rate·p − offset·d against 0 and L|N·d| (square), as in `insideBy`.
 */
const GRID_25 = 2 ** 29;
const GRID_26 = 2 ** 28;
const LEAST_SHARE = 2 ** -10;
const BOX = 2 ** 100;

/** For one ray: the figure's margin (≥ 0 inside) and a bound on its error. */
const MARGIN = new Float64Array(2);

export function certifiedPlanar(s: Planar): Kernel {
  const slot = certifiedSlot();
  const left: OpenRays = { count: 0, open: new Int32Array(0) };

  function both(rays: Rays, out: Answers): void {
    out.rareCount = 0;
    if (left.open.length < rays.count) left.open = new Int32Array(rays.count);
    planarRoots(s, rays, out, left);
    for (let k = 0; k < left.count; k++) {
      const i = left.open[k] as number;
      const verdict = solvePlanarSlowly(
        s,
        rays.Ex[i] as number,
        rays.Ey[i] as number,
        rays.Ez[i] as number,
        rays.dx[i] as number,
        rays.dy[i] as number,
        rays.dz[i] as number,
        slot,
      );
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
  const inBox =
    sizeN < BOX && sizeN > 1 / BOX && (s.size === 0 || (s.size < BOX && s.size > 1 / BOX));
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
  left.count = 0;
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
    MARGIN[0] = 1;
    MARGIN[1] = 0;
    if (s.bound !== 'none') insideBy(s, px, py, pz, x, y, z, r, Sd, Sp);
    const inside = MARGIN[0];
    if (
      inBox &&
      Sd < BOX &&
      Sd > 1 / BOX &&
      Sp < BOX &&
      Sp > 1 / BOX &&
      Math.abs(r) > LEAST_SHARE * (sizeN * Sd) &&
      Math.abs(o) > LEAST_SHARE * (sizeN * Sp) &&
      Math.abs(inside) > MARGIN[1]
    ) {
      t0[i] = inside > 0 ? t : Number.NaN;
      t1[i] = Number.NaN;
      margin[i] = inside;
    } else left.open[left.count++] = i;
  }
}

/*
 * How far inside, and a bound. u = 2^-53; |r̂ − N·d| ≤ 2^-52 |N|₁|d|₁ =: 2u·Sr, p is off by u.
 *   m = d × p:     products 2u, difference u:                       |δmi| ≤ 3u·S,  S = |d|₁|p|₁ ≥ |mi|
 *   w = m × N:     products (3 + 1)u, difference u:                 |δwi| ≤ 8u·S|N|₁ =: e
 *   circle:        |w|² − (r·N·d)²:  2|w|₁e + 3e² + 4u|w|²;  2·2u|r N·d|·r Sr + 4u² r²Sr² + 4u (r N·d)²
 *   square:        wu, wv (e each) and L|N·d| − w (e + 2u·L Sr + 2u(L|N·d| + |w|))
 * The constants below are twice these, for the terms in u² and for evaluating them in doubles; SMALLEST covers underflow in the box.
 */
const U = 2 ** -53;
const SMALLEST = 2 ** -400;

function insideBy(
  s: Planar,
  px: number,
  py: number,
  pz: number,
  x: number,
  y: number,
  z: number,
  rate: number,
  Sd: number,
  Sp: number,
): void {
  const [Nx, Ny, Nz] = s.N;
  const mx = y * pz - z * py;
  const my = z * px - x * pz;
  const mz = x * py - y * px;
  const wx = my * Nz - mz * Ny;
  const wy = mz * Nx - mx * Nz;
  const wz = mx * Ny - my * Nx;
  const sizeN = Math.abs(Nx) + Math.abs(Ny) + Math.abs(Nz);
  const e = 16 * U * (Sd * Sp * sizeN);
  const reach = s.size * Math.abs(rate);
  const slack = 4 * U * (s.size * (sizeN * Sd));
  if (s.bound === 'circle') {
    const ww = wx * wx + wy * wy + wz * wz;
    const size = Math.abs(wx) + Math.abs(wy) + Math.abs(wz);
    MARGIN[0] = reach * reach - ww;
    MARGIN[1] =
      e * (2 * size + 3 * e) +
      slack * (2 * reach + slack) +
      8 * U * (ww + reach * reach) +
      SMALLEST;
    return;
  }
  const sign = rate < 0 ? -1 : 1;
  const u = sign * (s.u === 0 ? wx : wy);
  const v = sign * (s.v === 2 ? wz : wy);
  MARGIN[0] = Math.min(Math.min(u, reach - u), Math.min(v, reach - v));
  MARGIN[1] = e + slack + 4 * U * (reach + Math.abs(u) + Math.abs(v)) + SMALLEST;
}

/*
 * Second stage: N·d and N·p in double-double (ε = 5u² < 2^-103; products of doubles are exact): off by 3ε|N|₁|d|₁ and 4ε|N|₁|p|₁. Their
 * quotient is faithful if what that makes of it, with the division's own 2ε, is below u/4. The figure's rim and edge, where the filter
 * above cannot tell, go to the exact stage: they are few.
 */
const R = new Float64Array(16);
const NN = 0;
const V = 2;
const PRODUCT = 4;
const RATE = 6;
const OFFSET = 8;
const T = 10;
const EPSILON = 2 ** -103;
const FAITHFUL = 2 ** -55;
const ORDINARY = 2 ** 40;
const ordinary = (x: number): boolean => x < ORDINARY && x > 1 / ORDINARY;

function addProduct(out: number, n: number, hi: number, lo: number): void {
  dd.set(R, NN, n);
  R[V] = hi;
  R[V + 1] = lo;
  dd.mul(R, PRODUCT, NN, V);
  dd.add(R, out, out, PRODUCT);
}

export function solvePlanarSlowly(
  s: Planar,
  Ex: number,
  Ey: number,
  Ez: number,
  dx: number,
  dy: number,
  dz: number,
  slot: CertifiedSlot,
): number {
  const [Nx, Ny, Nz] = s.N;
  const px = Ex - s.P[0];
  const py = Ey - s.P[1];
  const pz = Ez - s.P[2];
  const sizeN = Math.abs(Nx) + Math.abs(Ny) + Math.abs(Nz);
  const Sd = Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
  const Sp = Math.abs(px) + Math.abs(py) + Math.abs(pz);
  slot.exact = false;
  if (ordinary(sizeN) && ordinary(Sd) && ordinary(Sp) && (s.size === 0 || ordinary(s.size))) {
    dd.set(R, RATE, 0);
    addProduct(RATE, Nx, dx, 0);
    addProduct(RATE, Ny, dy, 0);
    addProduct(RATE, Nz, dz, 0);
    dd.set(R, OFFSET, 0);
    addProduct(OFFSET, Nx, px, sumError(Ex, -s.P[0], px));
    addProduct(OFFSET, Ny, py, sumError(Ey, -s.P[1], py));
    addProduct(OFFSET, Nz, pz, sumError(Ez, -s.P[2], pz));
    const rate = R[RATE] as number;
    const offset = R[OFFSET] as number;
    const off =
      (4 * EPSILON * sizeN * Sd + SMALLEST) / Math.abs(rate) +
      (5 * EPSILON * sizeN * Sp + SMALLEST) / Math.abs(offset) +
      2 * EPSILON;
    if (off < FAITHFUL) {
      MARGIN[0] = 1;
      MARGIN[1] = 0;
      if (s.bound !== 'none') insideBy(s, px, py, pz, dx, dy, dz, rate, Sd, Sp);
      if (Math.abs(MARGIN[0]) > MARGIN[1]) {
        if (MARGIN[0] < 0) return NONE;
        dd.div(R, T, OFFSET, RATE);
        slot.t0 = -(R[T] as number);
        slot.t1 = Number.NaN;
        return ONE;
      }
    }
  }
  slot.exact = true;
  return solvePlanarExactly(s, Ex, Ey, Ez, dx, dy, dz, slot);
}
