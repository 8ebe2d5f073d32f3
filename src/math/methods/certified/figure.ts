import type { Planar } from '../../batch/planar.ts';

/*
 * How far inside the figure, and a bound. u = 2^-53; p = fl(E − P) is off by u of itself, and N·d by 2u of itself: both stages of the kernel
 * know it to more than 53 bits before they round it.
 *   m = d × p:     δmi ≤ 2u Si + u|mi|, Si = |dj pk| + |dk pj| ≤ S = |d|₁|p|₁
 *   w = m × N:     products u, difference u:       |δwi| ≤ |N|₁ (2u S + 3u max|mi|)                          =: e
 *   circle:        |w|² − (r·N·d)²:  2|w|₁e + 3e²;  3u of |w|² and 2·(2 + 1)u + u of (r·N·d)² for themselves, u of both for the difference
 *   square:        wu, wv (e each) and L|N·d| − w (e, 3u of L|N·d|, and u of the difference)
 * The constants have room for the terms in u², for being evaluated in doubles, and for underflow: in the kernels' box |d|₁, |p|₁ and |N|₁ are above
 * 2^-100, so e > 2^-352, and a lost product (2^-1074, multiplied by 2^200 at most) is nothing to that.
 */
const U = 2 ** -53;
const ERROR_S = 3 * U;
const ERROR_M = 4 * U;

/** For one ray: the figure's margin (≥ 0 inside) and a bound on its error. */
export const MARGIN = new Float64Array(2);

/** `rate` is N·d; Sd and Sp are |d|₁ and |p|₁. */
export function insideBy(
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
  const M = Math.abs(mx) + Math.abs(my) + Math.abs(mz);
  const e = sizeN * (ERROR_S * (Sd * Sp) + ERROR_M * M);
  const reach = s.size * Math.abs(rate);
  if (s.bound === 'circle') {
    const ww = wx * wx + wy * wy + wz * wz;
    const size = Math.abs(wx) + Math.abs(wy) + Math.abs(wz);
    MARGIN[0] = reach * reach - ww;
    MARGIN[1] = e * (2 * size + 3 * e) + 9 * U * (ww + reach * reach);
    return;
  }
  const sign = rate < 0 ? -1 : 1;
  const u = sign * (s.u === 0 ? wx : wy);
  const v = sign * (s.v === 2 ? wz : wy);
  MARGIN[0] = Math.min(Math.min(u, reach - u), Math.min(v, reach - v));
  MARGIN[1] = e + 5 * U * (reach + Math.abs(u) + Math.abs(v));
}
