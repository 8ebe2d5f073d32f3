import type { Answers, Rays } from '../../batch/batch.ts';
import { BOUNDS } from './refined.ts';
import { AT_SCALED } from './scaled-quadric.ts';

/*
 * The third stage; what it certifies is derived in refined.ts. One loop for both kinds of shapes: about an axis y and k are 0. It is long because what it hands on
 * are forty numbers, which a call between two halves would send through memory.
 */

/** Settles what it can of the `count` rays at `places`, moves the others to the front and returns how many these are. */
export function refine(
  numbers: Float64Array,
  hasY: boolean,
  { Ex, Ey, Ez, dx, dy, dz }: Rays,
  { t0, t1 }: Answers,
  places: Int32Array,
  count: number,
): number {
  const Cx = numbers[AT_SCALED.Cx] as number;
  const Cy = numbers[AT_SCALED.Cy] as number;
  const Cz = numbers[AT_SCALED.Cz] as number;
  const k = numbers[AT_SCALED.k] as number;
  const k1 = numbers[AT_SCALED.k1] as number;
  const k2 = numbers[AT_SCALED.k2] as number;
  const sign = numbers[AT_SCALED.sign] as number;
  const rho = numbers[AT_SCALED.rho] as number;
  const rhoLow = numbers[AT_SCALED.rhoLow] as number;
  const grid25 = BOUNDS[0] as number;
  const grid26 = BOUNDS[1] as number;
  const gridOfP = BOUNDS[2] as number;
  const splitter = BOUNDS[3] as number;
  const residualError = BOUNDS[4] as number;
  const stepError = BOUNDS[5] as number;
  const faithful = BOUNDS[6] as number;
  const spread = BOUNDS[7] as number;
  const step = BOUNDS[8] as number;
  const clearly = BOUNDS[9] as number;
  const apart = BOUNDS[10] as number;
  const leastA = BOUNDS[11] as number;
  const box = BOUNDS[12] as number;
  const momentError = BOUNDS[13] as number;
  const squareError = BOUNDS[14] as number;
  const rhoError = BOUNDS[15] as number;
  const smallestD = BOUNDS[16] as number;
  const narrow = BOUNDS[17] as number;
  let left = 0;
  for (let j = 0; j < count; j++) {
    const i = places[j] as number;
    const x = dx[i] as number;
    const dyi = hasY ? (dy[i] as number) : 0;
    const z = dz[i] as number;
    const ex = Ex[i] as number;
    const ey = hasY ? (Ey[i] as number) : Cy;
    const ez = Ez[i] as number;
    // p = fl(E − C) and what it lost (Knuth's TwoSum).
    const px = ex - Cx;
    const py = ey - Cy;
    const pz = ez - Cz;
    const vx = px - ex;
    const vy = py - ey;
    const vz = pz - ez;
    const lostX = ex - (px - vx) - (Cx + vx);
    const lostY = ey - (py - vy) - (Cy + vy);
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

    const Sd = Math.abs(x) + Math.abs(y) + Math.abs(z);
    const Sp = Math.abs(px) + Math.abs(leadP) + Math.abs(pz);
    const pk = k * py;
    const mx = y * pz - z * pk;
    const my = z * px - x * pz;
    const mz = x * pk - y * px;
    const round = x * x + z * z;
    const yy = y * y;
    const A = round - sign * yy;
    const D = rho * A + sign * (mx * mx + mz * mz) - my * my;
    const S = Sd * Sp;
    const Am = round + yy;
    const M = Math.abs(mx) + Math.abs(my) + Math.abs(mz);
    const error = S * (momentError * M + squareError * S) + rhoError * (rho * Am) + smallestD;
    const inside = Sd < box && Sd * box > 1 && Sp < box;
    const clear = D > clearly * error && inside && D > apart * (S * S) && Math.abs(A) > leastA * Am;
    if (!clear) {
      places[left++] = i;
      continue;
    }
    const slope = x * px + z * pz - sign * (y * pk);
    const s = Math.sqrt(D);
    const As = A * s;
    const inverse = 1 / (As * Sd);
    const overA = inverse * (s * Sd);
    const ta = (-slope - s) * overA;
    const tb = (s - slope) * overA;
    const half = 0.5 * inverse * (A * Sd);
    const over = inverse * As;
    const reachA = Math.abs(ta) * Sd + Sp;
    const reachB = Math.abs(tb) * Sd + Sp;
    const gridD = grid25 * Sd;
    const gridA = grid25 * (over * reachA);
    const gridB = grid25 * (over * reachB);
    const gridP = gridOfP * (reachA + reachB);
    const xh = x + gridD - gridD;
    const yh = leadD + gridD - gridD;
    const zh = z + gridD - gridD;
    const xl = x - xh;
    const yl = leadD - yh + restD;
    const zl = z - zh;
    const phx = px + gridP - gridP;
    const phy = leadP + gridP - gridP;
    const phz = pz + gridP - gridP;
    const plx = px - phx + lostX;
    const ply = leadP - phy + restP;
    const plz = pz - phz + lostZ;
    // One root after the other: interleaved, more values are alive than there are registers.
    const tah = ta + gridA - gridA;
    const tal = ta - tah;
    const ax = phx + tah * xh;
    const ay = phy + tah * yh;
    const az = phz + tah * zh;
    const sizeOfA = Math.abs(ax) + Math.abs(ay) + Math.abs(az);
    const gridQA = grid26 * sizeOfA;
    const axh = ax + gridQA - gridQA;
    const ayh = ay + gridQA - gridQA;
    const azh = az + gridQA - gridQA;
    const axl = ax - axh + (tah * xl + tal * x + plx);
    const ayl = ay - ayh + (tah * yl + tal * y + ply);
    const azl = az - azh + (tah * zl + tal * z + plz);
    const fa =
      axh * axh +
      azh * azh -
      sign * (ayh * ayh) -
      rho +
      (axl * (axh + axh + axl) +
        azl * (azh + azh + azl) -
        sign * (ayl * (ayh + ayh + ayl)) -
        rhoLow);
    const tbh = tb + gridB - gridB;
    const tbl = tb - tbh;
    const bx = phx + tbh * xh;
    const by = phy + tbh * yh;
    const bz = phz + tbh * zh;
    const sizeOfB = Math.abs(bx) + Math.abs(by) + Math.abs(bz);
    const gridQB = grid26 * sizeOfB;
    const bxh = bx + gridQB - gridQB;
    const byh = by + gridQB - gridQB;
    const bzh = bz + gridQB - gridQB;
    const bxl = bx - bxh + (tbh * xl + tbl * x + plx);
    const byl = by - byh + (tbh * yl + tbl * y + ply);
    const bzl = bz - bzh + (tbh * zl + tbl * z + plz);
    const fb =
      bxh * bxh +
      bzh * bzh -
      sign * (byh * byh) -
      rho +
      (bxl * (bxh + bxh + bxl) +
        bzl * (bzh + bzh + bzl) -
        sign * (byl * (byh + byh + byl)) -
        rhoLow);
    const ra = ta + fa * half;
    const rb = tb - fb * half;
    const f = Math.abs(fa);
    const g = Math.abs(fb);
    const widthA = sizeOfA + reachA;
    const widthB = sizeOfB + reachB;
    const errorA = half * (residualError * widthA * (sizeOfA + narrow * widthA) + stepError * f);
    const errorB = half * (residualError * widthB * (sizeOfB + narrow * widthB) + stepError * g);
    const settled =
      errorA <= faithful * Math.abs(ra) &&
      errorB <= faithful * Math.abs(rb) &&
      reachA + reachB <= spread * Sp &&
      (f + g) * Math.abs(A) <= step * D;
    if (settled) {
      t0[i] = Math.min(ra, rb);
      t1[i] = Math.max(ra, rb);
    } else places[left++] = i;
  }
  return left;
}
