import type { Rays } from '../../batch/batch.ts';
import type { Planar } from '../../batch/planar.ts';

/*
 * How far inside its figure a line meets the plane, times |N·d|, and a bound on the error. u = 2^-53; p = fl(E − P) is off by u of itself, and N·d by 2u of
 * itself: both stages of the kernel know it to more than 53 bits before they round it.
 *
 * Circle, |w|² against (r N·d)²:
 *   m = d × p:     δmi ≤ 2u Si + u|mi|, Si = |dj pk| + |dk pj| ≤ |mi| + 2√(|dj pj|·|dk pk|) ≤ |mi| + S/2, S = |d|₁|p|₁:   ≤ uS + 3u|mi|
 *   w = m × N:     products u, difference u:       |δwi| ≤ |N|₁ (uS + 5u max|mi|)                            =: e
 *   |w|² − (r·N·d)²:  2|w|₁e + 3e²;  3u of |w|² and 2·(2 + 1)u + u of (r·N·d)² for themselves, u of both for the difference
 * Square, wu and wv against 0 and L|dn|, where n is its normal's axis:
 *   wu = dn pu − du pn:   2u Su + u|wu|, Su = |dn pu| + |du pn|
 *   L|dn| − wu:           u L|dn| more, and u of the difference; it is only asked where it is less than wu, so L|dn| ≤ 2|wu|:     6u Su
 *
 * The constants have room for the terms in u², for being evaluated in doubles, and the circle's for underflow: in the kernels' box |d|₁, |p|₁ and |N|₁ are
 * above 2^-100, so e > 2^-352, and a lost product (2^-1074, multiplied by 2^200 at most) is nothing to that. The square's has SMALLEST for its three products.
 * r and L may be any: r·N·d lost is nothing to e either, and where its square overflows the bound is infinite as well; L|dn| overflows to what it is beside wu.
 */
const U = 2 ** -53;
export const CIRCLE_S = 1.1 * U;
export const CIRCLE_M = 5.1 * U;
export const CIRCLE_SQUARES = 9 * U;
export const SQUARE_S = 7 * U;
export const SMALLEST = 2 ** -1072;

/**
 * Rays from … to − 1. N·d goes in by `margin`, NaN if it is not known; out come the margin (≥ 0 inside) and its bound. Loops of their own: doubles that are
 * handed to a call are boxed, at half the kernel's price.
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
    bound[i] = SQUARE_S * S + SMALLEST;
  }
};

const MARGINS: Readonly<Record<Planar['bound'], Margins>> = { none: plane, circle, square };

export const marginsOf = ({ bound }: Planar): Margins => MARGINS[bound];
