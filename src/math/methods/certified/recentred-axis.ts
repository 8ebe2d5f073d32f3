import { BOUNDS, type RecentredPass } from './recentred.ts';
import { AT_SCALED } from './scaled-quadric.ts';

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
  const grid25 = BOUNDS[0] as number;
  const grid26 = BOUNDS[1] as number;
  const gridOfP = BOUNDS[2] as number;
  const crossError = BOUNDS[4] as number;
  const squareError = BOUNDS[5] as number;
  const residualError = BOUNDS[6] as number;
  const slopeError = BOUNDS[7] as number;
  const closedA = BOUNDS[8] as number;
  const closed = BOUNDS[9] as number;
  const faithful = BOUNDS[10] as number;
  const smallestD = BOUNDS[11] as number;
  const box = BOUNDS[13] as number;
  const narrow = BOUNDS[14] as number;
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
