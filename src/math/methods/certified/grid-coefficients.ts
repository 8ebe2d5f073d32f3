import { SPLITTER as HALVES, sumError } from '../../float/eft.ts';
import type { Ray } from '../../ray.ts';
import * as at from './grid-scratch.ts';
import { AT_SCALED } from './scaled-quadric.ts';

/*
 * A, b = B/2, C and D/4 = b² − AC, each as a double and a small rest, for a ray and a shape in the box. x = xh + xl with xh = (x + σ) − σ and
 * σ = 2^27 S, S ≥ Σ|x|: xh is a whole multiple of a power of two g ≥ 2^-26 S, Σ|xh| ≤ (2^26 + 4) g, and |xl| ≤ hS, h = 2^-26, exactly (refined.ts).
 * So sums of three squares or products of such parts are below 2^53 of their units and exact, and only what has an xl in it is rounded, by uh a time;
 * η = 2^-77 = 4uh.
 *
 *   S: D = |dx| + |dz| + w|dy| and P = |px| + |pz| + w|py|, w = max(1, k), so that k y is counted, too.
 *   p = E − C: pl = (p − ph) + (what E − C lost), rounded once                                          |pl| ≤ hP,   off by uhP
 *   k y: y in 26 bits y1 and the rest, k1 y1 exact, its part beyond the grid h, k1(y − y1) and k2 y h of k|y| each, k2 off by uh k:
 *     1 + 1 + 1, sums 2 + 3; for p, what E − C lost is one rounding of h more                           |yl| ≤ 3hS,  off by 8uhS, for p 9uhP
 *   A: xl(x + xh) 2 + 2; y, the most: 2·8, yh + yl + yh times yl 3·(1 + 2), the product 6, the last sum 6                   37uh D²
 *   b, of y: yh pl 9 + 3, yl p 8 + 3 + 3, their sum 6, the last sum 6                                                    ≤ 38uh DP
 *   C, of y: 2·9, p + ph times pl 3·(1 + 2), the product 6, the last two sums 6 each; C0 − ρ is split without loss         ≤ 46uh P²
 *     but for u² of ρ, which C is near where that is far above P²
 *   D/4: with 26-bit heads bt, At, Ct: bt² − At Ct without loss, what has a rest in it ≤ 12uh (b² + |AC|), and inherited 2|b|δb + |A|δC + |C|δA
 *
 * ERROR = 48uh for all of them, and for 2|b|DP + |A|P² + |C|D²: the tests have the sums. hi + lo is sorted without a comparison (Fast2Sum): where a
 * number passes the test of grid-quadric.ts, it is 2^-20 of its bound's scale at least, and the second summand below 2^-23 of that.
 */
export const ERROR = 12 * 2 ** -77;
export const CUT = 2 ** 27;

export type CoefficientsPass = (numbers: Float64Array, ray: Ray) => void;

/** A closure over its scratch and constants, as in lattice-scratch.ts, and in one piece: a call that is not inlined boxes its doubles. */
export function coefficientsPass(grid: at.Grid): CoefficientsPass {
  const NUMBER = AT_SCALED;
  const GRID = CUT;
  const SPLITTER = HALVES;
  const BOUND = ERROR;
  return (numbers, { origin: E, direction: d }) => {
    const k = numbers[NUMBER.k] as number;
    const sign = numbers[NUMBER.sign] as number;
    const rho = numbers[NUMBER.rho] as number;
    const wide = numbers[NUMBER.wide] as number;
    const Cx = numbers[NUMBER.Cx] as number;
    const Cz = numbers[NUMBER.Cz] as number;
    const x = d[0];
    const y = d[1];
    const z = d[2];
    const ex = E[0];
    const ey = E[1];
    const ez = E[2];
    // A shape that does not look at y has k = 0; so has a hyperboloid with a = 0.
    const Cy = k === 0 ? ey : (numbers[NUMBER.Cy] as number);
    const px = ex - Cx;
    const py = ey - Cy;
    const pz = ez - Cz;
    const reachD = Math.abs(x) + Math.abs(z) + wide * Math.abs(y);
    const reachP = Math.abs(px) + Math.abs(pz) + wide * Math.abs(py);
    const cutD = GRID * reachD;
    const cutP = GRID * reachP;
    const xh = x + cutD - cutD;
    const xl = x - xh;
    const zh = z + cutD - cutD;
    const zl = z - zh;
    const onGrid = y + cutD - cutD;
    const pxh = px + cutP - cutP;
    const pxl = px - pxh + sumError(ex, -Cx, px);
    const pzh = pz + cutP - cutP;
    const pzl = pz - pzh + sumError(ez, -Cz, pz);
    const k1 = numbers[NUMBER.k1] as number;
    const k2 = numbers[NUMBER.k2] as number;
    let big = SPLITTER * y;
    const y1 = big - (big - y);
    const rise = k1 * y1;
    const yh = rise + cutD - cutD;
    const yl = rise - yh + (k1 * (y - y1) + k2 * y);
    big = SPLITTER * py;
    const p1 = big - (big - py);
    const above = k1 * p1;
    const ph = above + cutP - cutP;
    const pl = above - ph + (k1 * (py - p1 + sumError(ey, -Cy, py)) + k2 * py);
    const p = ph + pl;
    const sh = sign * yh;
    const sl = sign * yl;

    const A0 = xh * xh + zh * zh - sh * yh;
    const A1 = xl * (x + xh) + zl * (z + zh) - sl * (yh + yl + yh);
    const A = A0 + A1;
    const Al = A1 - (A - A0);
    const b0 = xh * pxh + zh * pzh - sh * ph;
    const b1 = xh * pxl + xl * px + (zh * pzl + zl * pz) - (sh * pl + sl * p);
    const b = b0 + b1;
    const bl = b1 - (b - b0);
    const wideC = pxh * pxh + pzh * pzh - sign * (ph * ph);
    const C0 = wideC - rho;
    const C1 =
      pxl * (px + pxh) +
      pzl * (pz + pzh) -
      sign * (pl * (p + ph)) +
      (sumError(wideC, -rho, C0) - (numbers[NUMBER.rhoLow] as number));
    const C = C0 + C1;
    const Cl = C1 - (C - C0);

    big = SPLITTER * A;
    const At = big - (big - A);
    const Ar = A - At + Al;
    big = SPLITTER * C;
    const Ct = big - (big - C);
    const Cr = C - Ct + Cl;
    big = SPLITTER * b;
    const bt = big - (big - b);
    const br = b - bt + bl;
    const bb = bt * bt;
    const AC = At * Ct;
    const D0 = bb - AC;
    const D1 = sumError(bb, -AC, D0) + (br * (b + bt) - (At * Cr + Ar * C));
    const D = D0 + D1;
    grid[at.A] = A;
    grid[at.B] = b;
    grid[at.C] = C;
    grid[at.D] = D;
    grid[at.B_LOW] = bl;
    grid[at.D_LOW] = D1 - (D - D0);
    grid[at.A_HEAD] = At;
    grid[at.A_REST] = Ar;
    grid[at.REACH_D] = reachD;
    grid[at.REACH_P] = reachP;
    grid[at.OFF_D] =
      BOUND *
      (2 * Math.abs(b) * reachD * reachP +
        Math.abs(A) * reachP * reachP +
        Math.abs(C) * reachD * reachD);
    grid[at.DX] = x;
    grid[at.DY] = y;
    grid[at.DZ] = z;
    grid[at.XH] = xh;
    grid[at.YH] = onGrid;
    grid[at.ZH] = zh;
    grid[at.XL] = xl;
    grid[at.YL] = y - onGrid;
    grid[at.ZL] = zl;
  };
}
