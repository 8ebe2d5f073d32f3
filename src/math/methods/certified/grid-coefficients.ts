import { sumError } from '../../float/eft.ts';
import type { Ray } from '../../ray.ts';
import { AT_SCALED } from './scaled-quadric.ts';

export function createGrid() {
  const SPLITTER = 134217729;
  const GRID_26 = 2 ** 28;
  const ERROR = 20 * 2 ** -77;
  const GRID = new Float64Array(24);
  const A = 0;
  const B = 1;
  const C = 2;
  const D = 3;
  const B_LOW = 4;
  const A_HEAD = 5;
  const A_REST = 6;
  const D_LOW = 7;
  const REACH_D = 8;
  const REACH_P = 9;
  const XH = 10;
  const XL = 11;
  const YH = 12;
  const YL = 13;
  const ZH = 14;
  const ZL = 15;
  const N = AT_SCALED;
function putCoefficients(numbers: Float64Array, { origin: E, direction: d }: Ray): void {
  const k = numbers[N.k] as number;
  const sign = numbers[N.sign] as number;
  const rho = numbers[N.rho] as number;
  const wide = numbers[N.wide] as number;
  const Cx = numbers[N.Cx] as number;
  const Cz = numbers[N.Cz] as number;
  const x = d[0];
  const y = d[1];
  const z = d[2];
  const ex = E[0];
  const ez = E[2];
  const px = ex - Cx;
  const pz = ez - Cz;
  const reachD = Math.abs(x) + Math.abs(z) + wide * Math.abs(y);
  let reachP = Math.abs(px) + Math.abs(pz) + (numbers[N.r] as number);
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
    const Cy = numbers[N.Cy] as number;
    const k1 = numbers[N.k1] as number;
    const k2 = numbers[N.k2] as number;
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
    (sumError(wideC, -rho, C0) - (numbers[N.rhoLow] as number));
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
  return { GRID, ERROR, putCoefficients, at: {A, B, C, D, B_LOW, A_HEAD, A_REST, D_LOW, REACH_D, REACH_P, XH, XL, YH, YL, ZH, ZL} };
}
