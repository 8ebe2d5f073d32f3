import { AT, type Lattice, ROUND } from './lattice.ts';
import { HITS, type Scratch } from './lattice-scratch.ts';

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
const CONSTANTS = Float64Array.of(ROUND, 0.5);
