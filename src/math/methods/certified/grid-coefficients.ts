import { sumError } from '../../float/eft.ts';
import type { Ray } from '../../ray.ts';
import { AT_SCALED } from './scaled-quadric.ts';

const U = 2 ** -53;
const SPLITTER = 134217729;
const GRID_26 = 2 ** 28;

export const ERROR = 2 ** -30 * U;
export const ERROR_D = 2 ** -27 * U;

/** What is handed on; the rest of the names say where. */
export const GRID = new Float64Array(24);
export const A = 0;
export const B = 1;
export const C = 2;
export const D = 3;
export const B_LOW = 4;
export const A_HEAD = 5;
export const A_REST = 6;
export const D_LOW = 7;
export const REACH_D = 8;
export const REACH_P = 9;
export const XH = 10;
export const XL = 11;
export const YH = 12;
export const YL = 13;
export const ZH = 14;
export const ZL = 15;

export function putCoefficients(numbers: Float64Array, { origin: E, direction: d }: Ray): void {
  const k = numbers[AT_SCALED.k] as number;
  const sign = numbers[AT_SCALED.sign] as number;
  const rho = numbers[AT_SCALED.rho] as number;
  const wide = numbers[AT_SCALED.wide] as number;
  const Cx = numbers[AT_SCALED.Cx] as number;
  const Cz = numbers[AT_SCALED.Cz] as number;
  const x = d[0];
  const y = d[1];
  const z = d[2];
  const ex = E[0];
  const ez = E[2];
  const px = ex - Cx;
  const pz = ez - Cz;
  const reachD = Math.abs(x) + Math.abs(z) + wide * Math.abs(y);
  let reachP = Math.abs(px) + Math.abs(pz) + (numbers[AT_SCALED.r] as number);
  const cutD = GRID_26 * reachD;
  const xh = x + cutD - cutD;
  const xl = x - xh;
  const yGrid = y + cutD - cutD;
  const zh = z + cutD - cutD;
  const zl = z - zh;
  // y stretched by k, in direction and place.
  let yh = 0;
  let yl = 0;
  let ph = 0;
  let pl = 0;
  let cutP = 0;
  if (k !== 0) {
    const Cy = numbers[AT_SCALED.Cy] as number;
    const k1 = numbers[AT_SCALED.k1] as number;
    const k2 = numbers[AT_SCALED.k2] as number;
    const ey = E[1];
    const py = ey - Cy;
    reachP += wide * Math.abs(py);
    cutP = GRID_26 * reachP;
    let big = SPLITTER * y;
    const y1 = big - (big - y);
    const w = k1 * y1;
    yh = w + cutD - cutD;
    yl = w - yh + (k1 * (y - y1) + k2 * y);
    big = SPLITTER * py;
    const py1 = big - (big - py);
    const v = k1 * py1;
    ph = v + cutP - cutP;
    pl = v - ph + (k1 * (py - py1 + sumError(ey, -Cy, py)) + k2 * py);
  } else cutP = GRID_26 * reachP;
  const pxh = px + cutP - cutP;
  const pxl = px - pxh + sumError(ex, -Cx, px);
  const pzh = pz + cutP - cutP;
  const pzl = pz - pzh + sumError(ez, -Cz, pz);
  const sy = sign * yh;
  const sl = sign * yl;
  const p = ph + pl;

  const A0 = xh * xh + zh * zh - sy * yh;
  const A1 = (x + xh) * xl + (z + zh) * zl - sl * (yh + yl + yh);
  const Ah = A0 + A1;
  const Al = A1 - (Ah - A0);
  const b0 = xh * pxh + zh * pzh - sy * ph;
  const b1 = xh * pxl + xl * px + (zh * pzl + zl * pz) - (sy * pl + sl * p);
  const bh = b0 + b1;
  const bl = b1 - (bh - b0);
  const wideC = pxh * pxh + pzh * pzh - sign * (ph * ph);
  const C0 = wideC - rho;
  const C1 =
    (px + pxh) * pxl +
    (pz + pzh) * pzl -
    sign * ((p + ph) * pl) +
    (sumError(wideC, -rho, C0) - (numbers[AT_SCALED.rhoLow] as number));
  const Ch = C0 + C1;
  const Cl = C1 - (Ch - C0);

  let big = SPLITTER * Ah;
  const At = big - (big - Ah);
  const Ar = Ah - At + Al;
  big = SPLITTER * Ch;
  const Ct = big - (big - Ch);
  const Cr = Ch - Ct + Cl;
  big = SPLITTER * bh;
  const bt = big - (big - bh);
  const br = bh - bt + bl;
  const bb = bt * bt;
  const AC = At * Ct;
  const D0 = bb - AC;
  const D1 = sumError(bb, -AC, D0) + (br * (bh + bt) - (At * Cr + Ar * Ch));
  const Dh = D0 + D1;
  GRID[A] = Ah;
  GRID[B] = bh;
  GRID[C] = Ch;
  GRID[D] = Dh;
  GRID[B_LOW] = bl;
  GRID[A_HEAD] = At;
  GRID[A_REST] = Ar;
  GRID[D_LOW] = D1 - (Dh - D0);
  GRID[REACH_D] = reachD;
  GRID[REACH_P] = reachP;
  GRID[XH] = xh;
  GRID[XL] = xl;
  GRID[YH] = yGrid;
  GRID[YL] = y - yGrid;
  GRID[ZH] = zh;
  GRID[ZL] = zl;
}
