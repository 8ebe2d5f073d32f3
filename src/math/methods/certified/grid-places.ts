import type { Hit } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import * as at from './grid-scratch.ts';
import { FOUND, T0, T1 } from './one-ray.ts';
import { AT_SCALED } from './scaled-quadric.ts';
import { ERROR } from './grid-coefficients.ts';

/* bounds */
const POINT = 24 * 2 ** -77;
export const FAITHFUL = 0.9 * 2 ** -54;
const STRAIGHT = 0.9 * 2 ** -53;
const CUT_25 = 2 ** 29;
const CUT_47 = 2 ** 6;
const HALVES = 134217729;

export type RootsPass = (ray: Ray) => void;
export type PlacePass = (numbers: Float64Array, k: number, turn: number) => Hit | null;

/** √D/4 and what is common to both hits. */
export function rootsPass(grid: at.Grid): RootsPass {
  const SPLITTER = HALVES;
  const GRID_T = CUT_25;
  const GRID_E = CUT_47;
  const BOUND = ERROR;
  const BOUND_POINT = POINT;
  const found = FOUND;
  return ({ origin: E }) => {
    const A = grid[at.A] as number;
    const D = grid[at.D] as number;
    const reachD = grid[at.REACH_D] as number;
    const reachP = grid[at.REACH_P] as number;
    const dx = grid[at.DX] as number;
    const dy = grid[at.DY] as number;
    const dz = grid[at.DZ] as number;
    const ex = E[0];
    const ey = E[1];
    const ez = E[2];
    const s = Math.sqrt(D);
    const overTwo = 0.5 / s;
    const big = SPLITTER * s;
    const sh = big - (big - s);
    const low = (D - sh * sh - (s - sh) * (s + sh) + (grid[at.D_LOW] as number)) * overTwo;
    const overA = 1 / A;
    const t = Math.max(Math.abs(found[T0] as number), Math.abs(found[T1] as number));
    const reach = Math.abs(ex) + Math.abs(ey) + Math.abs(ez) + t * reachD;
    const cut = GRID_E * reach;
    const exh = ex + cut - cut;
    const eyh = ey + cut - cut;
    const ezh = ez + cut - cut;
    const off = BOUND_POINT * reach;
    const offT =
      Math.abs(overA) *
      (BOUND * (reachD * (reach + reachP)) + (grid[at.OFF_D] as number) * overTwo);
    grid[at.OVER_A] = overA;
    grid[at.ROOT] = A > 0 ? s : -s;
    grid[at.ROOT_LOW] = A > 0 ? low : -low;
    grid[at.EXH] = exh;
    grid[at.EYH] = eyh;
    grid[at.EZH] = ezh;
    grid[at.EXL] = ex - exh;
    grid[at.EYL] = ey - eyh;
    grid[at.EZL] = ez - ezh;
    grid[at.OFF_X] = dx === 0 ? 0 : off + offT * Math.abs(dx);
    grid[at.OFF_Y] = dy === 0 ? 0 : off + offT * Math.abs(dy);
    grid[at.OFF_Z] = dz === 0 ? 0 : off + offT * Math.abs(dz);
    grid[at.CUT_T] = GRID_T * (reach / reachD);
  };
}

export function placePass(grid: at.Grid): PlacePass {
  const NUMBER = AT_SCALED;
  const SURE = FAITHFUL;
  const AHEAD = STRAIGHT;
  const found = FOUND;
  return (numbers, k, turn) => {
    const t = found[k] as number;
    const cut = grid[at.CUT_T] as number;
    const th = t + cut - cut;
    const tl = t - th;
    const At = grid[at.A_HEAD] as number;
    const b = grid[at.B] as number;
    const p = At * th;
    const v = p + b;
    const bPart = v - p;
    const residual =
      v +
      turn * (grid[at.ROOT] as number) +
      (p - (v - bPart) +
        (b - bPart) +
        (At * tl + (grid[at.A_REST] as number) * t) +
        ((grid[at.B_LOW] as number) + turn * (grid[at.ROOT_LOW] as number)));
    const rest = tl - residual * (grid[at.OVER_A] as number);
    const X = (grid[at.EXH] as number) + th * (grid[at.XH] as number);
    const Y = (grid[at.EYH] as number) + th * (grid[at.YH] as number);
    const Z = (grid[at.EZH] as number) + th * (grid[at.ZH] as number);
    const lowX =
      (grid[at.EXL] as number) + (th * (grid[at.XL] as number) + rest * (grid[at.DX] as number));
    const lowY =
      (grid[at.EYL] as number) + (th * (grid[at.YL] as number) + rest * (grid[at.DY] as number));
    const lowZ =
      (grid[at.EZL] as number) + (th * (grid[at.ZL] as number) + rest * (grid[at.DZ] as number));
    const pointX = X + lowX;
    const pointY = Y + lowY;
    const pointZ = Z + lowZ;
    const a = numbers[NUMBER.flare] as number;
    const normalX = X - (numbers[NUMBER.Cx] as number) + lowX;
    const normalY = a === 0 ? 0 : 0 - a * (Y - (numbers[NUMBER.Cy] as number) + lowY);
    const normalZ = Z - (numbers[NUMBER.Cz] as number) + lowZ;
    const offX = grid[at.OFF_X] as number;
    const offY = grid[at.OFF_Y] as number;
    const offZ = grid[at.OFF_Z] as number;
    const settled =
      offX <= SURE * Math.abs(pointX) &&
      offY <= SURE * Math.abs(pointY) &&
      offZ <= SURE * Math.abs(pointZ) &&
      offX + Math.abs(a) * offY + offZ <=
        AHEAD * (Math.abs(normalX) + Math.abs(normalY) + Math.abs(normalZ));
    if (!settled) return null;
    return {
      t,
      point: [pointX, pointY, pointZ],
      normal: [normalX, normalY, normalZ],
      singular: false,
    };
  };
}
