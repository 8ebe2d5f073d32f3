import { TWO } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { sumError } from '../../float/eft.ts';
import type { CurvedDetails, Hit, Intersection, Sign } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import { DIRECT_ERROR as DIRECT } from './class-quadric.ts';
import { createGrid } from './grid-coefficients.ts';
import { FOUND, findRoots, T0, T1, VERDICT } from './one-ray.ts';
import { AT_SCALED, type CertifiedQuadric } from './scaled-quadric.ts';

const signOf = (x: number): Sign => (x > 0 ? 1 : -1);

function make(): (q: Quadric, c: CertifiedQuadric, ray: Ray) => Intersection | null {
  const { GRID, at, ERROR, putCoefficients } = createGrid();
  const DIRECT_ERROR = DIRECT;
  const FAITHFUL = 0.9 * 2 ** -54;
  const SMALL = 2 ** -100;
  const LARGE = 2 ** 100;
  const GRID_25 = 2 ** 29;
  const GRID_E = 2 ** 6;
  const STRAIGHT = 2 ** -55;
  const SPLITTER = 134217729;
  const ERROR_D = 22 * 2 ** -77;
  const POINT = 24 * 2 ** -77;
  const NUMBER = AT_SCALED;
  const found = FOUND;

  const PLACE = new Float64Array(8);
  const ROOT = 0;
  const ROOT_LOW = 1;
  const OVER_A = 2;
  const OFF = 3;
  const CUT_E = 4;
  const CUT_T = 5;

  function gridQuadric(q: Quadric, c: CertifiedQuadric, ray: Ray): Intersection | null {
    if (!c.inBox) return null;
    putCoefficients(c.numbers, ray);
    const A = GRID[at.A] as number;
    const b = GRID[at.B] as number;
    const C = GRID[at.C] as number;
    const D = GRID[at.D] as number;
    const reachD = GRID[at.REACH_D] as number;
    const reachP = GRID[at.REACH_P] as number;
    const N = reachD * reachP;
    const DD = reachD * reachD;
    const PP = reachP * reachP;
    const offD = ERROR_D * (2 * Math.abs(b) * N + Math.abs(A) * PP + Math.abs(C) * DD);
    const sure =
      ERROR * DD <= FAITHFUL * Math.abs(A) &&
      ERROR * N <= FAITHFUL * Math.abs(b) &&
      ERROR * PP <= FAITHFUL * Math.abs(C) &&
      offD <= FAITHFUL * Math.abs(D) &&
      reachD > SMALL &&
      reachD < LARGE &&
      reachP > SMALL &&
      reachP < LARGE;
    if (!sure) return null;
    const details: CurvedDetails = {
      family: 'curved',
      A,
      B: 2 * b,
      C,
      D: 4 * D,
      signs: { A: signOf(A), B: signOf(b), C: signOf(C), D: signOf(D) },
    };
    const decidedBy = Math.abs(D) > DIRECT_ERROR * (N * N) ? 'filter' : 'double-double';
    if (D < 0) return { class: 'none', hits: [], method: 'certified', decidedBy, details };
    findRoots(q, ray, c);
    if (found[VERDICT] !== TWO) return null;
    const t0 = found[T0] as number;
    const t1 = found[T1] as number;
    const s = Math.sqrt(D);
    const i = 0.5 / s;
    const big = SPLITTER * s;
    const sh = big - (big - s);
    const sm = s - sh;
    const sLow = (D - sh * sh - sm * (s + sh) + (GRID[at.D_LOW] as number)) * i;
    const overA = 1 / A;
    const { origin: E } = ray;
    const reach =
      Math.abs(E[0]) +
      Math.abs(E[1]) +
      Math.abs(E[2]) +
      Math.max(Math.abs(t0), Math.abs(t1)) * reachD;
    PLACE[ROOT] = A > 0 ? s : -s;
    PLACE[ROOT_LOW] = A > 0 ? sLow : -sLow;
    PLACE[OVER_A] = overA;
    PLACE[OFF] =
      POINT * reach +
      reachD * Math.abs(overA) * (ERROR * (reachD * (reach + reachP)) + offD * i);
    PLACE[CUT_E] = GRID_E * reach;
    PLACE[CUT_T] = GRID_25 * (reach / reachD);
    const near = hitAt(c.numbers, ray, T0, 1);
    if (near === null) return null;
    const far = hitAt(c.numbers, ray, T1, -1);
    return far && { class: 'two', hits: [near, far], method: 'certified', decidedBy, details };
  }

  function hitAt(
    numbers: Float64Array,
    { origin: E, direction: d }: Ray,
    k: number,
    turn: number,
  ): Hit | null {
    const t = found[k] as number;
    const cutT = PLACE[CUT_T] as number;
    const cutE = PLACE[CUT_E] as number;
    const th = t + cutT - cutT;
    const tl = t - th;
    const At = GRID[at.A_HEAD] as number;
    const b = GRID[at.B] as number;
    const p = At * th;
    const v = p + b;
    const residual =
      v +
      turn * (PLACE[ROOT] as number) +
      (sumError(p, b, v) +
        (At * tl + (GRID[at.A_REST] as number) * t) +
        ((GRID[at.B_LOW] as number) + turn * (PLACE[ROOT_LOW] as number)));
    const rest = tl - residual * (PLACE[OVER_A] as number);
    const dx = d[0];
    const dy = d[1];
    const dz = d[2];
    const ex = E[0];
    const ey = E[1];
    const ez = E[2];
    const exh = ex + cutE - cutE;
    const eyh = ey + cutE - cutE;
    const ezh = ez + cutE - cutE;
    const X = exh + th * (GRID[at.XH] as number);
    const Y = eyh + th * (GRID[at.YH] as number);
    const Z = ezh + th * (GRID[at.ZH] as number);
    const lx = ex - exh + (th * (GRID[at.XL] as number) + rest * dx);
    const ly = ey - eyh + (th * (GRID[at.YL] as number) + rest * dy);
    const lz = ez - ezh + (th * (GRID[at.ZL] as number) + rest * dz);
    const pointX = X + lx;
    const pointY = Y + ly;
    const pointZ = Z + lz;
    const off = PLACE[OFF] as number;
    const a = numbers[NUMBER.flare] as number;
    const normalX = X - (numbers[NUMBER.Cx] as number) + lx;
    const normalY = a === 0 ? 0 : 0 - a * (Y - (numbers[NUMBER.Cy] as number) + ly);
    const normalZ = Z - (numbers[NUMBER.Cz] as number) + lz;
    const size = Math.abs(normalX) + Math.abs(normalY) + Math.abs(normalZ);
    if (
      (off <= FAITHFUL * Math.abs(pointX) || dx === 0) &&
      (off <= FAITHFUL * Math.abs(pointY) || dy === 0) &&
      (off <= FAITHFUL * Math.abs(pointZ) || dz === 0) &&
      off * (1 + Math.abs(a)) <= STRAIGHT * size
    ) {
      return {
        t,
        point: [pointX, pointY, pointZ],
        normal: [normalX, normalY, normalZ],
        singular: false,
      };
    }
    return null;
  }
  return gridQuadric;
}
export const gridQuadric = make();
