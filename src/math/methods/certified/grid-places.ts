import { SPLITTER as HALVES, productError, sumError } from '../../float/eft.ts';
import type { Hit } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import { ERROR } from './grid-coefficients.ts';
import * as at from './grid-scratch.ts';
import { type Found, T0, T1 } from './one-ray.ts';
import { AT_SCALED } from './scaled-quadric.ts';

/*
 * Points and normals of two hits, from the double t that is certified for each. A t* + b ± √(D/4) = 0 gives t* = t − (A t + b ± √(D/4))/A: no more than
 * that remainder is needed, and not exactly. L = |E|₁ + max|t| D, T = L/D ≥ |t|; D, P, h, η and the grids are those of grid-coefficients.ts, uh = η/4.
 *
 *   √: D − sh² exact, (s − sh)(s + sh) 2 roundings of 2h D/4, the linear step                        off by δD/2s + 2uh s
 *   t = th + tl on the grid 2^27 T: th ≤ (2^26 + 1/2) units, |tl| ≤ hT. At th is exact, its sum with b is split without loss, ±√ takes away all but
 *     2h |A|T of it: that rounding 2, At tl 1, Ar 1, times t 1, three sums 2 each, and √'s own 2      13uh |A|T
 *   δ = t* − t by what A, b and √ are off, over A: 37uh DL, and 38uh DP with √'s own 2uh |b|, by ERROR; and δD/2s   offT
 *   E + t d: th xh is a multiple of a power of two ≥ 2^-52 L, eh of one that is, too, their sum X below 2^53 of them and exact
 *     low = el + th xl + (tl + δ) dx: 13, 1 (tl + δ) + 1 (times dx) + 1 (th xl) + 2 + 2 (sums)          20uh L + |dx| offT
 *   n = (X − C) + low, the difference split without loss, |low| ≤ 2h L: 2uh L and what low is off; y: a hi + lo, times that, 8u²|ny| more
 *
 * POINT = 24uh for all of it: the tests have the sums. A coordinate X + low is rounded once: faithful, and itself where it is a double, if it was off by
 * less than u|x|/2; FAITHFUL leaves a tenth. Where d has no component, X + low is E's own. A normal's component likewise, which is more than is promised
 * of its direction: one that is exactly zero would come out as something like 1e-23, and the next scale of the same ray might say otherwise.
 */
export const POINT = 6 * 2 ** -77;
export const FAITHFUL = 0.9 * 2 ** -54;
export const CUT_TIME = 2 ** 27;
export const CUT_ORIGIN = 2 ** 2;

/** Once `found` holds the roots. */
export type RootsPass = (ray: Ray) => void;
/**
 * The hit at root `k` of `found`, `turn` 1 for the near and −1 for the far one; null where a
 * coordinate, or the way of the normal, stays open.
 */
export type PlacePass = (numbers: Float64Array, k: number, turn: number) => Hit | null;

/** √D/4 and what is common to both hits. */
export function rootsPass(grid: at.Grid, found: Found): RootsPass {
  const SPLITTER = HALVES;
  const GRID_T = CUT_TIME;
  const GRID_E = CUT_ORIGIN;
  const BOUND = ERROR;
  const BOUND_POINT = POINT;
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

export function placePass(grid: at.Grid, found: Found): PlacePass {
  const NUMBER = AT_SCALED;
  const SURE = FAITHFUL;
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
      (p -
        (v - bPart) +
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
    const Cx = numbers[NUMBER.Cx] as number;
    const Cz = numbers[NUMBER.Cz] as number;
    const awayX = X - Cx;
    const awayZ = Z - Cz;
    const normalX = awayX + (sumError(X, -Cx, awayX) + lowX);
    const normalZ = awayZ + (sumError(Z, -Cz, awayZ) + lowZ);
    let normalY = 0;
    if (a !== 0) {
      const Cy = numbers[NUMBER.Cy] as number;
      const awayY = Y - Cy;
      const rise = sumError(Y, -Cy, awayY) + lowY;
      const above = awayY + rise;
      const down = a * above;
      const rest = a * (rise - (above - awayY)) + (numbers[NUMBER.flareLow] as number) * above;
      normalY = 0 - (down + (productError(a, above, down) + rest));
    }
    const offX = grid[at.OFF_X] as number;
    const offY = grid[at.OFF_Y] as number;
    const offZ = grid[at.OFF_Z] as number;
    const settled =
      offX <= SURE * Math.abs(pointX) &&
      offY <= SURE * Math.abs(pointY) &&
      offZ <= SURE * Math.abs(pointZ) &&
      offX <= SURE * Math.abs(normalX) &&
      Math.abs(a) * offY <= SURE * Math.abs(normalY) &&
      offZ <= SURE * Math.abs(normalZ);
    if (!settled) return null;
    return {
      t,
      point: [pointX, pointY, pointZ],
      normal: [normalX, normalY, normalZ],
      singular: false,
    };
  };
}
