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
import { solvePlanarExactly } from '../../batch/exact-planar.ts';
import type { Planar } from '../../batch/planar.ts';
import * as dd from '../../float/double-double.ts';
import { sumError } from '../../float/eft.ts';
import { lazily } from '../../lazily.ts';
import {
  BOX,
  type CertifiedSlot,
  certifiedSlot,
  FAITHFUL,
  GRID_25,
  GRID_26,
  type OpenRays,
  U,
} from './numbers.ts';

/*
 * Flat shapes. With p = E − P and m = d × p, where N·d ≠ 0:  t = −N·p / N·d and X − P = (m × N) /
 * (N·d).
 *
 * First stage, on grids as in refined.ts: N, d and p are cut into 25 or 26 leading bits and a rest.
 *
 *   quantity            bound                reason
 *   leading products    exact                of N·d and N·p, and their sums
 *   what is left over   2^-73 of |N|₁|d|₁,   it is ≤ 2^-23 of these
 *                       |N|₁|p|₁
 *   r = N·d, o = N·p    2^-57 of them        where neither cancels to less than LEAST_SHARE = 2^-16
 *                                            of its terms
 *   t0 = −o/r           3u of it             one division; its leading 25 bits th are corrected
 *   remainder o + th·r  what o and r are     exact in its leading part, ≤ 2^-23|o|
 *   t = th − rest/r     2^-55 of it          before it is rounded once: faithful, which needs 2^-54
 */
/** Least |N·d| and |N·p| of the first stage, relative to the sums of their terms' sizes. */
export const LEAST_SHARE = 2 ** -16;

/** The batch kernel of a flat shape. */
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

/*
 * How far inside its figure a line meets the plane, times |N·d|, and a bound on the error. u =
 * 2^-53; p = fl(E − P) is off by u of itself, and N·d by 2u of itself: both stages of the kernel
 * know it to more than 53 bits before they round it.
 *
 *   quantity                  bound                reason
 *   circle: |w|² against (r N·d)²
 *   m = d × p                 uS + 3u|mi|          δmi ≤ 2u Si + u|mi|, Si = |dj pk| + |dk pj| ≤
 *                                                  |mi| + 2√(|dj pj||dk pk|) ≤ |mi| + S/2, S =
 *                                                  |d|₁|p|₁
 *   w = m × N                 e = |N|₁ (uS +       products u, difference u
 *                             5u max|mi|)
 *   |w|² − (r N·d)²           2|w|₁e + 3e² + 9u    3u of |w|² and 2·(2 + 1)u + u of (r N·d)² for
 *                             of both              themselves, u of both for the difference
 *   square: wu and wv against 0 and L|dn|, where n is its normal's axis
 *   wu = dn pu − du pn        2u Su + u|wu|        Su = |dn pu| + |du pn|
 *   L|dn| − wu                6u Su                u L|dn| more, and u of the difference; it is
 *                                                  only asked where it is < wu: L|dn| ≤ 2|wu|
 *
 * The constants have room for the terms in u², for being evaluated in doubles, and the circle's for
 * underflow: in the kernels' box |d|₁, |p|₁ and |N|₁ are above 2^-100, so e > 2^-352, and a lost
 * product (2^-1074, multiplied by 2^200 at most) is nothing to that. The square's has
 * SMALLEST_FIGURE for its three products. r and L may be any: r·N·d lost is nothing to e either,
 * and where its square overflows the bound is infinite as well; L|dn| overflows to what it is
 * beside wu.
 */
/**
 * Bounds of the table, with room: of w in S and max|mi|, both squares, wu in Su; an absolute one.
 */
export const CIRCLE_S = 1.1 * U;
export const CIRCLE_M = 5.1 * U;
export const CIRCLE_SQUARES = 9 * U;
export const SQUARE_S = 7 * U;
export const SMALLEST_FIGURE = 2 ** -1072;

/**
 * Rays from … to − 1. N·d goes in by `margin`, NaN if it is not known; out come the margin (≥ 0
 * inside) and its bound. Loops of their own: doubles that are handed to a call are boxed, at half
 * the kernel's price.
 */
type Margins = (
  s: Planar,
  rays: Rays,
  from: number,
  to: number,
  margin: Float64Array,
  bound: Float64Array,
) => void;

const plane: Margins = (_s, _rays, from, to, margin, bound) => {
  for (let i = from; i < to; i++) {
    margin[i] = Math.abs(margin[i] as number);
    bound[i] = 0;
  }
};

const circle: Margins = (s, { Ex, Ey, Ez, dx, dy, dz }, from, to, margin, bound) => {
  const [Nx, Ny, Nz] = s.N;
  const [Px, Py, Pz] = s.P;
  const { size } = s;
  const sizeN = Math.abs(Nx) + Math.abs(Ny) + Math.abs(Nz);
  for (let i = from; i < to; i++) {
    const x = dx[i] as number;
    const y = dy[i] as number;
    const z = dz[i] as number;
    const px = (Ex[i] as number) - Px;
    const py = (Ey[i] as number) - Py;
    const pz = (Ez[i] as number) - Pz;
    const mx = y * pz - z * py;
    const my = z * px - x * pz;
    const mz = x * py - y * px;
    const wx = my * Nz - mz * Ny;
    const wy = mz * Nx - mx * Nz;
    const wz = mx * Ny - my * Nx;
    const S =
      (Math.abs(x) + Math.abs(y) + Math.abs(z)) * (Math.abs(px) + Math.abs(py) + Math.abs(pz));
    const M = Math.abs(mx) + Math.abs(my) + Math.abs(mz);
    const e = sizeN * (CIRCLE_S * S + CIRCLE_M * M);
    const W = Math.abs(wx) + Math.abs(wy) + Math.abs(wz);
    const ww = wx * wx + wy * wy + wz * wz;
    const reach = size * (margin[i] as number);
    margin[i] = reach * reach - ww;
    bound[i] = e * (2 * W + 3 * e) + CIRCLE_SQUARES * (ww + reach * reach);
  }
};

const square: Margins = (s, { Ex, Ey, Ez, dx, dy, dz }, from, to, margin, bound) => {
  const { size, u, v } = s;
  const E = [Ex, Ey, Ez] as const;
  const d = [dx, dy, dz] as const;
  const n = (3 - u - v) as 0 | 1 | 2;
  const [Eu, Ev, En] = [E[u], E[v], E[n]];
  const [du, dv, dn] = [d[u], d[v], d[n]];
  const [Pu, Pv, Pn] = [s.P[u], s.P[v], s.P[n]];
  for (let i = from; i < to; i++) {
    const speed = dn[i] as number;
    const p = (En[i] as number) - Pn;
    const a = speed * ((Eu[i] as number) - Pu);
    const b = (du[i] as number) * p;
    const f = speed * ((Ev[i] as number) - Pv);
    const g = (dv[i] as number) * p;
    const turn = speed < 0 ? -1 : 1;
    const wu = turn * (a - b);
    const wv = turn * (f - g);
    const reach = size * Math.abs(speed);
    const inside = Math.min(Math.min(wu, reach - wu), Math.min(wv, reach - wv));
    const S = Math.max(Math.abs(a) + Math.abs(b), Math.abs(f) + Math.abs(g));
    // Adds nothing, but lets a rate that is not known through as NaN.
    margin[i] = inside + 0 * (margin[i] as number);
    bound[i] = SQUARE_S * S + SMALLEST_FIGURE;
  }
};

const MARGINS: Readonly<Record<Planar['bound'], Margins>> = { none: plane, circle, square };

/** The loop that puts margins and their bounds for this kind of figure. */
export const marginsOf = ({ bound }: Planar): Margins => MARGINS[bound];

/*
 * Second stage: N·d and N·p in double-double (float/double-double.ts has the sources). Products of
 * doubles are exact; a sum is off by 3u² of itself.
 *
 *   quantity   bound                      reason
 *   N·d        1.5u² Σ|Ni di| + 4.5u²     of three products the first two add up to (Σ|Ni di| +
 *              of it                      |N·d|)/2 at most, as the third makes up for the rest
 *   N·p        6.5u² Σ|Ni pi| + 4.5u²     p is a double-double: its products are off by 5u² more
 *              of it
 *   t          both, and 18.8u² of it     the division's own 9.8u²
 *
 * The figure's rim and edge, where the filter cannot tell, go to the exact stage: they are few.
 */
const ERROR_RATE = 1.6 * 2 ** -106;
const ERROR_OFFSET = 6.7 * 2 ** -106;
const ERROR_QUOTIENT = 19 * 2 ** -106;
/**
 * Of N·d and N·p. Both are below 2^200, and with FAITHFUL above SMALLEST_PLANAR·2^55 = 2^-768, so t
 * is between 2^-968 and 2^968, as the division wants it.
 */
export const SMALLEST_PLANAR = 2 ** -823;
/**
 * Numbers of the second stage, two doubles each, from these places on: N·d, N·p and t, which
 * rootInTwice leaves there, and a component of N, what it is multiplied by, and the product.
 */
export type Twice = Float64Array;
/** A `Twice` of zeros. */
export const createTwice = (): Twice => new Float64Array(12);
const TWICE_RATE = 0;
const TWICE_OFFSET = 2;
/** Indices of t in `Twice`. */
export const TWICE_T = 4;
export const TWICE_T_LOW = 5;
const TWICE_N = 6;
const TWICE_V = 8;
const TWICE_V_LOW = 9;
const TWICE_PRODUCT = 10;

const isBoxed = (x: number): boolean => x < BOX && x > 1 / BOX;

/** Adds n·(hi + lo) to what is at `out`. */
function addProduct(twice: Twice, out: number, n: number, hi: number, lo: number): void {
  dd.set(twice, TWICE_N, n);
  twice[TWICE_V] = hi;
  twice[TWICE_V_LOW] = lo;
  dd.mul(twice, TWICE_PRODUCT, TWICE_N, TWICE_V);
  dd.add(twice, out, out, TWICE_PRODUCT);
}

/**
 * Puts N·d, N·p and the root of an ordinary ray; returns the bound on the root's relative error, or
 * Infinity where there is none.
 */
export function rootInTwice(s: Planar, rays: Rays, i: number, twice: Twice): number {
  const Ex = rays.Ex[i] as number;
  const Ey = rays.Ey[i] as number;
  const Ez = rays.Ez[i] as number;
  const dx = rays.dx[i] as number;
  const dy = rays.dy[i] as number;
  const dz = rays.dz[i] as number;
  const [Nx, Ny, Nz] = s.N;
  const px = Ex - s.P[0];
  const py = Ey - s.P[1];
  const pz = Ez - s.P[2];
  const sizeN = Math.abs(Nx) + Math.abs(Ny) + Math.abs(Nz);
  const Sd = Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
  const Sp = Math.abs(px) + Math.abs(py) + Math.abs(pz);
  if (!isBoxed(sizeN) || !isBoxed(Sd) || !isBoxed(Sp)) return Number.POSITIVE_INFINITY;
  dd.set(twice, TWICE_RATE, 0);
  addProduct(twice, TWICE_RATE, Nx, dx, 0);
  addProduct(twice, TWICE_RATE, Ny, dy, 0);
  addProduct(twice, TWICE_RATE, Nz, dz, 0);
  dd.set(twice, TWICE_OFFSET, 0);
  addProduct(twice, TWICE_OFFSET, Nx, px, sumError(Ex, -s.P[0], px));
  addProduct(twice, TWICE_OFFSET, Ny, py, sumError(Ey, -s.P[1], py));
  addProduct(twice, TWICE_OFFSET, Nz, pz, sumError(Ez, -s.P[2], pz));
  const rate = twice[TWICE_RATE] as number;
  const offset = twice[TWICE_OFFSET] as number;
  dd.div(twice, TWICE_T, TWICE_OFFSET, TWICE_RATE);
  dd.neg(twice, TWICE_T, TWICE_T);
  return (
    (ERROR_RATE * (Math.abs(Nx * dx) + Math.abs(Ny * dy) + Math.abs(Nz * dz)) + SMALLEST_PLANAR) /
      Math.abs(rate) +
    (ERROR_OFFSET * (Math.abs(Nx * px) + Math.abs(Ny * py) + Math.abs(Nz * pz)) + SMALLEST_PLANAR) /
      Math.abs(offset) +
    ERROR_QUOTIENT
  );
}

const ownTwice = lazily(createTwice);

/** Ray i, which the first stage left open; overwrites its margin and t1. */
export function solvePlanarSlowly(
  s: Planar,
  rays: Rays,
  i: number,
  { margin, t1 }: Answers,
  slot: CertifiedSlot,
): number {
  const twice = ownTwice();
  slot.exact = false;
  if (rootInTwice(s, rays, i, twice) < FAITHFUL) {
    margin[i] = twice[TWICE_RATE] as number;
    marginsOf(s)(s, rays, i, i + 1, margin, t1);
    const inside = margin[i] as number;
    if (Math.abs(inside) > (t1[i] as number)) {
      slot.t0 = twice[TWICE_T] as number;
      slot.t1 = Number.NaN;
      return inside < 0 ? NONE : ONE;
    }
  }
  slot.exact = true;
  const { Ex, Ey, Ez, dx, dy, dz } = rays;
  return solvePlanarExactly(
    s,
    Ex[i] as number,
    Ey[i] as number,
    Ez[i] as number,
    dx[i] as number,
    dy[i] as number,
    dz[i] as number,
    slot,
  );
}
