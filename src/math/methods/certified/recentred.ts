import type { Answers, Rays } from '../../batch/batch.ts';
import { SPLITTER } from '../../float/eft.ts';
import { LEAST_A, SMALLEST_D } from './class.ts';
import { AT_SCALED, BOX, FAITHFUL_ONCE, GRID_25, GRID_26, GRID_P } from './numbers.ts';

/*
 * Rays that come from far away or graze the shape: both roots lie close together, so the origin is
 * moved to a short t between them, and the closed form there needs no more than double precision: t
 * + (−b' ∓ √D')/A with q = p + t d, b' = q·d, f = q·q − ρ and D' = b'² − A f, which is D/4. What
 * cancels is q, b' and f, and these are taken on grids. (x + σ) − σ is x rounded to a whole
 * multiple of ulp(σ)/2; for |x| ≤ S and σ = 2^m S what is left over is ≤ 2^(m−52) S, exactly (Rump,
 * Ogita, Oishi 2008).
 *
 * The grids are those of refined.ts, with t itself on its grid; the reach is L = |t||d|₁ + |p|₁,
 * W = |q|₁ + L, Q = |q|₁ of the leading parts + 2^-22 W:
 *
 *   quantity   bound                         reason
 *   q          2^-71 L in all                as in refined.ts
 *   f          2^-69 WQ + 2u|f|              as there; where the leading parts are 0, q is what is
 *                                            left over, ≤ 2^-23 L in each coordinate, and 2|q||δq|
 *                                            has 2^-91.4 L² more
 *   b'         2^-70 W|d|₁ + u|b'|           Σ qh dh is exact (26 by 25 bits); Σ (ql d + qh dl)
 *                                            with |ql| ≤ 2^-21 W, dl ≤ 2^-23 |d|₁ loses 2^-74 W|d|₁
 *                                            at each of up to six operations; δq·d 2^-71 L|d|₁
 *   A          9u|d|₁²                       y 3u, so Y² 7u; sums
 *   D'         |b'|(2^-68 W|d|₁ + 6u|b'|)    2|b'||δb'|, |A||δf|, |f||δA|, and 2u of both terms
 *              + |d|₁²(2^-68 WQ + 14u|f|)
 *   √D'        |δD'|/(1.7√D') + u√D'         where D' > 2|δD'|
 *   each t     (2^-70 W|d|₁ + 0.6|δD'|/√D'   before its only rounding; faithful when that is below
 *              + u(|b'| + √D')(9|d|₁²/|A|    u|t|/2
 *              + 8))/|A|
 */
/** Bounds of the table, with room: D' (three terms), b' in W|d|₁, A in |d|₁², t in |b'| + √D'. */
export const CROSS_ERROR = 2 ** -68;
export const SLOPE_SQUARE_ERROR = 6 * 2 ** -53;
export const RESIDUAL_SHARE = 14 * 2 ** -53;
export const SLOPE_ERROR = 2 ** -70;
export const CLOSED_A = 9 * 2 ** -53;
export const CLOSED = 8 * 2 ** -53;

/** CROSS_ERROR has 2^-68 for 2^-69, so of the 2^-22 in Q half is enough. */
export const NARROW_RECENTRED = 2 ** -23;

/** What the loops take before they begin. */
export const AT_RECENTRED = {
  grid25: 0,
  grid26: 1,
  gridOfP: 2,
  splitter: 3,
  crossError: 4,
  squareError: 5,
  residualError: 6,
  slopeError: 7,
  closedA: 8,
  closed: 9,
  faithful: 10,
  smallestD: 11,
  leastA: 12,
  box: 13,
  narrow: 14,
} as const;
/** In the order of AT_RECENTRED. */
export const RECENTRED_BOUNDS: readonly number[] = [
  GRID_25,
  GRID_26,
  GRID_P,
  SPLITTER,
  CROSS_ERROR,
  SLOPE_SQUARE_ERROR,
  RESIDUAL_SHARE,
  SLOPE_ERROR,
  CLOSED_A,
  CLOSED,
  FAITHFUL_ONCE,
  SMALLEST_D,
  LEAST_A,
  BOX,
  NARROW_RECENTRED,
];

/**
 * Settles what it can of the `count` rays at `places`, moves the others to the front and returns
 * how many these are.
 */
export type RecentredPass = (
  numbers: Float64Array,
  rays: Rays,
  out: Answers,
  places: Int32Array,
  count: number,
) => number;

/** For cylinders, whose formula does not look at y. */
export const recentredAroundAxis: RecentredPass = (
  numbers,
  { Ex, Ez, dx, dz },
  { t0, t1 },
  places,
  count,
) => {
  const Cx = numbers[AT_SCALED.Cx] as number;
  const Cz = numbers[AT_SCALED.Cz] as number;
  const rho = numbers[AT_SCALED.rho] as number;
  const rhoLow = numbers[AT_SCALED.rhoLow] as number;
  const grid25 = RECENTRED_BOUNDS[AT_RECENTRED.grid25] as number;
  const grid26 = RECENTRED_BOUNDS[AT_RECENTRED.grid26] as number;
  const gridOfP = RECENTRED_BOUNDS[AT_RECENTRED.gridOfP] as number;
  const crossError = RECENTRED_BOUNDS[AT_RECENTRED.crossError] as number;
  const squareError = RECENTRED_BOUNDS[AT_RECENTRED.squareError] as number;
  const residualError = RECENTRED_BOUNDS[AT_RECENTRED.residualError] as number;
  const slopeError = RECENTRED_BOUNDS[AT_RECENTRED.slopeError] as number;
  const closedA = RECENTRED_BOUNDS[AT_RECENTRED.closedA] as number;
  const closed = RECENTRED_BOUNDS[AT_RECENTRED.closed] as number;
  const faithful = RECENTRED_BOUNDS[AT_RECENTRED.faithful] as number;
  const smallestD = RECENTRED_BOUNDS[AT_RECENTRED.smallestD] as number;
  const box = RECENTRED_BOUNDS[AT_RECENTRED.box] as number;
  const narrow = RECENTRED_BOUNDS[AT_RECENTRED.narrow] as number;
  let left = 0;
  for (let j = 0; j < count; j++) {
    const i = places[j] as number;
    const x = dx[i] as number;
    const z = dz[i] as number;
    const ex = Ex[i] as number;
    const ez = Ez[i] as number;
    const px = ex - Cx;
    const pz = ez - Cz;
    const vx = px - ex;
    const lostX = ex - (px - vx) - (Cx + vx);
    const vz = pz - ez;
    const lostZ = ez - (pz - vz) - (Cz + vz);
    const A = x * x + z * z;
    const speed = Math.abs(x) + Math.abs(z);
    const Sp = Math.abs(px) + Math.abs(pz);
    const slope = x * px + z * pz;
    const inverse = 1 / (A * speed);
    const overA = inverse * speed;
    const middle = -slope * overA;
    const reach = Math.abs(middle) * speed + Sp;
    const gridD = grid25 * speed;
    const gridT = grid25 * (Math.abs(inverse * A) * reach);
    const gridP = gridOfP * reach;
    const t = middle + gridT - gridT;
    const xh = x + gridD - gridD;
    const xl = x - xh;
    const phx = px + gridP - gridP;
    const plx = px - phx + lostX;
    const qx = phx + t * xh;
    const zh = z + gridD - gridD;
    const zl = z - zh;
    const phz = pz + gridP - gridP;
    const plz = pz - phz + lostZ;
    const qz = phz + t * zh;
    const size = Math.abs(qx) + Math.abs(qz);
    const gridQ = grid26 * size;
    const qxh = qx + gridQ - gridQ;
    const qxl = qx - qxh + (t * xl + plx);
    const qzh = qz + gridQ - gridQ;
    const qzl = qz - qzh + (t * zl + plz);
    const f =
      qxh * qxh + qzh * qzh - rho + (qxl * (qxh + qxh + qxl) + qzl * (qzh + qzh + qzl) - rhoLow);
    const b = qxh * xh + qzh * zh + (qxl * x + qxh * xl + (qzl * z + qzh * zl));
    const D = b * b - A * f;
    const width = size + reach;
    const sizeB = Math.abs(b);
    const square = speed * speed;
    const error =
      sizeB * (crossError * width * speed + squareError * sizeB) +
      square * (crossError * width * (size + narrow * width) + residualError * Math.abs(f)) +
      smallestD;
    const inside = speed < box && speed * box > 1 && Sp < box;
    const clear = D > 2 * error && inside;
    const missed = D < -error && inside;
    if (clear) {
      const root = Math.sqrt(D);
      const overSize = Math.abs(overA);
      const near = t + (-b * overA - root * overSize);
      const far = t + (root * overSize - b * overA);
      const off =
        (slopeError * width * speed +
          (0.6 * error) / root +
          (sizeB + root) * (closedA * square * overSize + closed)) *
        overSize;
      const settled = off <= faithful * Math.abs(near) && off <= faithful * Math.abs(far);
      if (settled) {
        t0[i] = near;
        t1[i] = far;
      } else places[left++] = i;
    } else if (missed) {
      t0[i] = Number.NaN;
      t1[i] = Number.NaN;
    } else places[left++] = i;
  }
  return left;
};

/**
 * For shapes with a term in y. One loop: values handed between functions would go through memory.
 */
export const recentredInSpace: RecentredPass = (
  numbers,
  { Ex, Ey, Ez, dx, dy, dz },
  { t0, t1 },
  places,
  count,
) => {
  const Cx = numbers[AT_SCALED.Cx] as number;
  const Cy = numbers[AT_SCALED.Cy] as number;
  const Cz = numbers[AT_SCALED.Cz] as number;
  const k = numbers[AT_SCALED.k] as number;
  const k1 = numbers[AT_SCALED.k1] as number;
  const k2 = numbers[AT_SCALED.k2] as number;
  const sign = numbers[AT_SCALED.sign] as number;
  const rho = numbers[AT_SCALED.rho] as number;
  const rhoLow = numbers[AT_SCALED.rhoLow] as number;
  const grid25 = RECENTRED_BOUNDS[AT_RECENTRED.grid25] as number;
  const grid26 = RECENTRED_BOUNDS[AT_RECENTRED.grid26] as number;
  const gridOfP = RECENTRED_BOUNDS[AT_RECENTRED.gridOfP] as number;
  const splitter = RECENTRED_BOUNDS[AT_RECENTRED.splitter] as number;
  const crossError = RECENTRED_BOUNDS[AT_RECENTRED.crossError] as number;
  const squareError = RECENTRED_BOUNDS[AT_RECENTRED.squareError] as number;
  const residualError = RECENTRED_BOUNDS[AT_RECENTRED.residualError] as number;
  const slopeError = RECENTRED_BOUNDS[AT_RECENTRED.slopeError] as number;
  const closedA = RECENTRED_BOUNDS[AT_RECENTRED.closedA] as number;
  const closed = RECENTRED_BOUNDS[AT_RECENTRED.closed] as number;
  const faithful = RECENTRED_BOUNDS[AT_RECENTRED.faithful] as number;
  const smallestD = RECENTRED_BOUNDS[AT_RECENTRED.smallestD] as number;
  const leastA = RECENTRED_BOUNDS[AT_RECENTRED.leastA] as number;
  const box = RECENTRED_BOUNDS[AT_RECENTRED.box] as number;
  const narrow = RECENTRED_BOUNDS[AT_RECENTRED.narrow] as number;
  let left = 0;
  for (let j = 0; j < count; j++) {
    const i = places[j] as number;
    const x = dx[i] as number;
    const dyi = dy[i] as number;
    const z = dz[i] as number;
    const ex = Ex[i] as number;
    const ey = Ey[i] as number;
    const ez = Ez[i] as number;
    const px = ex - Cx;
    const py = ey - Cy;
    const pz = ez - Cz;
    const vx = px - ex;
    const lostX = ex - (px - vx) - (Cx + vx);
    const vy = py - ey;
    const lostY = ey - (py - vy) - (Cy + vy);
    const vz = pz - ez;
    const lostZ = ez - (pz - vz) - (Cz + vz);
    // k·dy and k·py: an exact leading product of 26 by 26 bits, and the rest.
    const bigD = splitter * dyi;
    const topD = bigD - (bigD - dyi);
    const leadD = k1 * topD;
    const restD = k1 * (dyi - topD) + k2 * dyi;
    const y = leadD + restD;
    const bigP = splitter * py;
    const topP = bigP - (bigP - py);
    const leadP = k1 * topP;
    const restP = k1 * (py - topP) + k2 * py + k * lostY;
    const round = x * x + z * z;
    const yy = y * y;
    const A = round - sign * yy;
    const speed = Math.abs(x) + Math.abs(y) + Math.abs(z);
    const Sp = Math.abs(px) + Math.abs(leadP) + Math.abs(pz);
    const slope = x * px + z * pz - sign * (y * leadP);
    const inverse = 1 / (A * speed);
    const overA = inverse * speed;
    const middle = -slope * overA;
    const reach = Math.abs(middle) * speed + Sp;
    const gridD = grid25 * speed;
    const gridT = grid25 * (Math.abs(inverse * A) * reach);
    const gridP = gridOfP * reach;
    const t = middle + gridT - gridT;
    const xh = x + gridD - gridD;
    const xl = x - xh;
    const phx = px + gridP - gridP;
    const plx = px - phx + lostX;
    const qx = phx + t * xh;
    const yh = leadD + gridD - gridD;
    const yl = leadD - yh + restD;
    const phy = leadP + gridP - gridP;
    const ply = leadP - phy + restP;
    const qy = phy + t * yh;
    const zh = z + gridD - gridD;
    const zl = z - zh;
    const phz = pz + gridP - gridP;
    const plz = pz - phz + lostZ;
    const qz = phz + t * zh;
    const size = Math.abs(qx) + Math.abs(qy) + Math.abs(qz);
    const gridQ = grid26 * size;
    const qxh = qx + gridQ - gridQ;
    const qxl = qx - qxh + (t * xl + plx);
    const qyh = qy + gridQ - gridQ;
    const qyl = qy - qyh + (t * yl + ply);
    const qzh = qz + gridQ - gridQ;
    const qzl = qz - qzh + (t * zl + plz);
    const f =
      qxh * qxh +
      qzh * qzh -
      sign * (qyh * qyh) -
      rho +
      (qxl * (qxh + qxh + qxl) +
        qzl * (qzh + qzh + qzl) -
        sign * (qyl * (qyh + qyh + qyl)) -
        rhoLow);
    const b =
      qxh * xh +
      qzh * zh -
      sign * (qyh * yh) +
      (qxl * x + qxh * xl + (qzl * z + qzh * zl) - sign * (qyl * y + qyh * yl));
    const D = b * b - A * f;
    const width = size + reach;
    const sizeB = Math.abs(b);
    const square = speed * speed;
    const error =
      sizeB * (crossError * width * speed + squareError * sizeB) +
      square * (crossError * width * (size + narrow * width) + residualError * Math.abs(f)) +
      smallestD;
    const inside = speed < box && speed * box > 1 && Sp < box;
    const clear = D > 2 * error && inside && Math.abs(A) > leastA * (round + yy);
    const missed = D < -error && inside;
    if (clear) {
      const root = Math.sqrt(D);
      const overSize = Math.abs(overA);
      const near = t + (-b * overA - root * overSize);
      const far = t + (root * overSize - b * overA);
      const off =
        (slopeError * width * speed +
          (0.6 * error) / root +
          (sizeB + root) * (closedA * square * overSize + closed)) *
        overSize;
      const settled = off <= faithful * Math.abs(near) && off <= faithful * Math.abs(far);
      if (settled) {
        t0[i] = near;
        t1[i] = far;
      } else places[left++] = i;
    } else if (missed) {
      t0[i] = Number.NaN;
      t1[i] = Number.NaN;
    } else places[left++] = i;
  }
  return left;
};
