import { AT, type Lattice, ROUND } from './lattice.ts';
import { HITS, type Scratch } from './lattice-scratch.ts';

/*
 * Pass 2: f/2 = (q·q − ρ)/2 at the whole numbers next to the rough roots, q = p + t d. For lift = |t| + 2, l = lift/2 and
 * S = Σ|qh + ql/2| + lift ≥ Σ|q|:
 *
 *   d = dh + dl, E = eh + el, |dl|, |el| ≤ 1/2, exactly; ph = eh − Ch and qh = ph + t·dh are exact;
 *   ql = (el − Cl) + t·dl: |ql| ≤ |t|/2 + 1 = l; roundings u, u|t|/2 and u·l:                |δql| ≤ 2u·l
 *   H = Σqh² − ρh − …: S < 2^23.4 keeps all of it below 2^46.8. x² + z² − a1·y² − ρh counts in 64ths, and a2·y² is
 *   a whole number of 2^-13 below 2^53: exact but for the last subtraction,                   u|H| ≤ u(2|f/2| + 2|L|)
 *   L = Σ ql(qh + ql/2), |L| ≤ l·S: from δql 2, the bracket 1, the product 1, for y a's rounding 1 and its product 1, and four sums:
 *   10u·l·S with the share of H;
 *   a3: |a3|/2 ≤ 2^-15, its rounding, the product and a sum:                                  3u·2^-15 S² < u·2^-13.4 S²
 *   the sum of both and halves:                                                               3u|f/2| in all.
 *
 * So |δ(f/2)| ≤ u·S(5·lift + 2^-13 S) + 3u|f/2|. Math.abs is taken of numbers with a fraction: of whole ones V8 expects int32.
 */

export type ResidualPass = (lattice: Lattice) => void;

export function residualsInSpace(s: Scratch): ResidualPass {
  const { x: xs, y: ys, z: zs, ex: exs, ey: eys, ez: ezs, A: As, near, far, count } = s;
  const { fNear, fFar, overAH, spread, spreadFar } = s;
  return (lattice) => {
    const wholeX = lattice[AT.wholeX] as number;
    const wholeY = lattice[AT.wholeY] as number;
    const wholeZ = lattice[AT.wholeZ] as number;
    const restX = lattice[AT.restX] as number;
    const restY = lattice[AT.restY] as number;
    const restZ = lattice[AT.restZ] as number;
    const a = lattice[AT.a] as number;
    const a1 = lattice[AT.a1] as number;
    const a2 = lattice[AT.a2] as number;
    const halfA3 = lattice[AT.halfA3] as number;
    const wholeRho = lattice[AT.wholeRho] as number;
    const halfRestRho = lattice[AT.halfRestRho] as number;
    const hits = count[HITS] as number;
    const cut = CONSTANTS[0] as number;
    const half = CONSTANTS[1] as number;
    for (let j = 0; j < hits; j++) {
      const x = xs[j] as number;
      const y = ys[j] as number;
      const z = zs[j] as number;
      const ex = exs[j] as number;
      const ey = eys[j] as number;
      const ez = ezs[j] as number;
      const xh = x + cut - cut;
      const yh = y + cut - cut;
      const zh = z + cut - cut;
      const xl = x - xh;
      const yl = y - yh;
      const zl = z - zh;
      const exh = ex + cut - cut;
      const eyh = ey + cut - cut;
      const ezh = ez + cut - cut;
      const pxh = exh - wholeX;
      const pyh = eyh - wholeY;
      const pzh = ezh - wholeZ;
      const pxl = ex - exh - restX;
      const pyl = ey - eyh - restY;
      const pzl = ez - ezh - restZ;
      const t = (near[j] as number) + cut - cut;
      const qx = pxh + t * xh;
      const qy = pyh + t * yh;
      const qz = pzh + t * zh;
      const qxl = pxl + t * xl;
      const qyl = pyl + t * yl;
      const qzl = pzl + t * zl;
      const midX = qx + half * qxl;
      const midY = qy + half * qyl;
      const midZ = qz + half * qzl;
      const round = qx * qx + qz * qz;
      const yy = qy * qy;
      fNear[j] =
        half * (round - a1 * yy - wholeRho - a2 * yy) +
        (qxl * midX + qzl * midZ - a * (qyl * midY) - halfA3 * yy - halfRestRho);
      const v = (far[j] as number) + cut - cut;
      const wx = pxh + v * xh;
      const wy = pyh + v * yh;
      const wz = pzh + v * zh;
      const wxl = pxl + v * xl;
      const wyl = pyl + v * yl;
      const wzl = pzl + v * zl;
      const endX = wx + half * wxl;
      const endY = wy + half * wyl;
      const endZ = wz + half * wzl;
      const wide = wx * wx + wz * wz;
      const vv = wy * wy;
      fFar[j] =
        half * (wide - a1 * vv - wholeRho - a2 * vv) +
        (wxl * endX + wzl * endZ - a * (wyl * endY) - halfA3 * vv - halfRestRho);
      overAH[j] = 1 / ((As[j] as number) * (v - t));
      spread[j] = Math.abs(midX) + Math.abs(midY) + Math.abs(midZ);
      spreadFar[j] = Math.abs(endX) + Math.abs(endY) + Math.abs(endZ);
    }
  };
}

export function residualsAroundAxis(s: Scratch): ResidualPass {
  const { x: xs, z: zs, ex: exs, ez: ezs, A: As, near, far, count } = s;
  const { fNear, fFar, overAH, spread, spreadFar } = s;
  return (lattice) => {
    const wholeX = lattice[AT.wholeX] as number;
    const wholeZ = lattice[AT.wholeZ] as number;
    const restX = lattice[AT.restX] as number;
    const restZ = lattice[AT.restZ] as number;
    const wholeRho = lattice[AT.wholeRho] as number;
    const halfRestRho = lattice[AT.halfRestRho] as number;
    const hits = count[HITS] as number;
    const cut = CONSTANTS[0] as number;
    const half = CONSTANTS[1] as number;
    for (let j = 0; j < hits; j++) {
      const x = xs[j] as number;
      const z = zs[j] as number;
      const ex = exs[j] as number;
      const ez = ezs[j] as number;
      const xh = x + cut - cut;
      const zh = z + cut - cut;
      const xl = x - xh;
      const zl = z - zh;
      const exh = ex + cut - cut;
      const ezh = ez + cut - cut;
      const pxh = exh - wholeX;
      const pzh = ezh - wholeZ;
      const pxl = ex - exh - restX;
      const pzl = ez - ezh - restZ;
      const t = (near[j] as number) + cut - cut;
      const qx = pxh + t * xh;
      const qz = pzh + t * zh;
      const qxl = pxl + t * xl;
      const qzl = pzl + t * zl;
      const midX = qx + half * qxl;
      const midZ = qz + half * qzl;
      const round = qx * qx + qz * qz;
      fNear[j] = half * (round - wholeRho) + (qxl * midX + qzl * midZ - halfRestRho);
      const v = (far[j] as number) + cut - cut;
      const wx = pxh + v * xh;
      const wz = pzh + v * zh;
      const wxl = pxl + v * xl;
      const wzl = pzl + v * zl;
      const endX = wx + half * wxl;
      const endZ = wz + half * wzl;
      const wide = wx * wx + wz * wz;
      fFar[j] = half * (wide - wholeRho) + (wxl * endX + wzl * endZ - halfRestRho);
      overAH[j] = 1 / ((As[j] as number) * (v - t));
      spread[j] = Math.abs(midX) + Math.abs(midZ);
      spreadFar[j] = Math.abs(endX) + Math.abs(endZ);
    }
  };
}

/** V8 builds a literal anew at each use, and keeps in a register what it loaded before the loop. */
export const CONSTANTS = Float64Array.of(ROUND, 0.5);
