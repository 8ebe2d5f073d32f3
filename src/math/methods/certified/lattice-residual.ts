import { AT, type Lattice } from './lattice.ts';
import { HITS, type Scratch } from './lattice-scratch.ts';

/*
 * Pass 2: f = q·q − ρ, q = p + t d, at the whole numbers t next to the rough roots, and g = q·d at the nearer one. In units (y times `up`), for
 * lift = |t| + 2, l = lift/2 and s = Σ|qh|:
 *
 *   d = dh + dl, E = eh + el, |dl|, |el| ≤ 1/2, exactly; ph = eh − Ch and qh = ph + t·dh are exact;
 *   ql = (el − Cl) + t·dl: |ql| ≤ |t|/2 + 1 = l; roundings u, u|t|/2 and u·l:                |δql| ≤ 2u·l
 *   S = Σ|qh + ql| ≤ s + 1.5 lift = size, and so is Σ|2qh + ql|/2
 *   H = Σqh² − ρh − …: size ≤ 2^24 keeps its terms below 2^48. x² + z² − a1·y² − ρh counts in 32nds, and a2·y² is a multiple of
 *   2^-11, at most 2^5 · 2^48 of them: exact but for the last subtraction,                   u|H| ≤ u(|f| + |L|)
 *   L = Σ ql(2qh + ql), |L| ≤ 2l·S: from δql 2, the bracket 1, the product 1, for y a's rounding 1 and its product 1, and four sums:
 *   10u·2l·S = 10u·lift·size with the share of H;
 *   a3: |a3| ≤ 2^-12, its rounding, the product and a sum:                                    3u·2^-12 s² < u·2^-10.4 s²
 *   the rest of ρ (≤ 1/2) and the sum of both:                                                3u|f| in all.
 *
 * So |δf| ≤ ε + 3u|f|, ε = u·size(10·lift + 2^-10.4 size). And g: q is rounded, u, and off by 2u·l; the products u, a twice more; two sums:
 * |δg| ≤ 6u·reach, where reach is the sum of the products' sizes, and what ql adds is far less.
 *
 * Math.abs is taken of numbers with a fraction where there is a choice: of whole ones V8 expects int32.
 */

export type ResidualPass = (lattice: Lattice) => void;

export function residualsInSpace(s: Scratch): ResidualPass {
  const { x: xs, y: ys, z: zs, ex: exs, ey: eys, ez: ezs, near, far, count } = s;
  const { wholeNear, wholeFar, g: gs, reach, fNear, fFar, spread, spreadFar } = s;
  return (lattice) => {
    const cutD = lattice[AT.cutD] as number;
    const cutE = lattice[AT.cutE] as number;
    const cutT = lattice[AT.cutT] as number;
    const wholeX = lattice[AT.wholeX] as number;
    const cutDy = lattice[AT.cutDy] as number;
    const cutEy = lattice[AT.cutEy] as number;
    const up = lattice[AT.up] as number;
    const wholeY = lattice[AT.wholeY] as number;
    const wholeZ = lattice[AT.wholeZ] as number;
    const restX = lattice[AT.restX] as number;
    const restY = lattice[AT.restY] as number;
    const restZ = lattice[AT.restZ] as number;
    const a = lattice[AT.a] as number;
    const a1 = lattice[AT.a1] as number;
    const a2 = lattice[AT.a2] as number;
    const wholeRho = lattice[AT.wholeRho] as number;
    const a3 = lattice[AT.a3] as number;
    const restRho = lattice[AT.restRho] as number;
    const hits = count[HITS] as number;
    for (let j = 0; j < hits; j++) {
      const x = xs[j] as number;
      const y = ys[j] as number;
      const z = zs[j] as number;
      const ex = exs[j] as number;
      const ey = eys[j] as number;
      const ez = ezs[j] as number;
      const xh = x + cutD - cutD;
      const yh = y + cutDy - cutDy;
      const zh = z + cutD - cutD;
      const xl = x - xh;
      const yl = y - yh;
      const zl = z - zh;
      const exh = ex + cutE - cutE;
      const eyh = ey + cutEy - cutEy;
      const ezh = ez + cutE - cutE;
      const pxh = exh - wholeX;
      const pyh = eyh - wholeY;
      const pzh = ezh - wholeZ;
      const pxl = ex - exh - restX;
      const pyl = ey - eyh - restY;
      const pzl = ez - ezh - restZ;
      const t = (near[j] as number) + cutT - cutT;
      const qx = pxh + t * xh;
      const qy = pyh + t * yh;
      const qz = pzh + t * zh;
      const qxl = pxl + t * xl;
      const qyl = pyl + t * yl;
      const qzl = pzl + t * zl;
      const atX = qx + qxl;
      const atY = qy + qyl;
      const atZ = qz + qzl;
      const gx = atX * x;
      const gy = a * (atY * y);
      const gz = atZ * z;
      gs[j] = gx + gz - gy;
      reach[j] = Math.abs(gx) + Math.abs(gz) + Math.abs(gy);
      const round = qx * qx + qz * qz;
      const yy = qy * qy;
      fNear[j] =
        round -
        a1 * yy -
        wholeRho -
        a2 * yy +
        (qxl * (qx + atX) + qzl * (qz + atZ) - a * (qyl * (qy + atY)) - a3 * yy - restRho);
      const v = (far[j] as number) + cutT - cutT;
      const wx = pxh + v * xh;
      const wy = pyh + v * yh;
      const wz = pzh + v * zh;
      const wxl = pxl + v * xl;
      const wyl = pyl + v * yl;
      const wzl = pzl + v * zl;
      const wide = wx * wx + wz * wz;
      const vv = wy * wy;
      fFar[j] =
        wide -
        a1 * vv -
        wholeRho -
        a2 * vv +
        (wxl * (wx + wx + wxl) +
          wzl * (wz + wz + wzl) -
          a * (wyl * (wy + wy + wyl)) -
          a3 * vv -
          restRho);
      wholeNear[j] = t;
      wholeFar[j] = v;
      spread[j] = Math.abs(qx) + up * Math.abs(qy) + Math.abs(qz);
      spreadFar[j] = Math.abs(wx) + up * Math.abs(wy) + Math.abs(wz);
    }
  };
}

export function residualsAroundAxis(s: Scratch): ResidualPass {
  const { x: xs, z: zs, ex: exs, ez: ezs, near, far, count } = s;
  const { wholeNear, wholeFar, g: gs, reach, fNear, fFar, spread, spreadFar } = s;
  return (lattice) => {
    const cutD = lattice[AT.cutD] as number;
    const cutE = lattice[AT.cutE] as number;
    const cutT = lattice[AT.cutT] as number;
    const wholeX = lattice[AT.wholeX] as number;
    const wholeZ = lattice[AT.wholeZ] as number;
    const restX = lattice[AT.restX] as number;
    const restZ = lattice[AT.restZ] as number;
    const wholeRho = lattice[AT.wholeRho] as number;
    const restRho = lattice[AT.restRho] as number;
    const hits = count[HITS] as number;
    for (let j = 0; j < hits; j++) {
      const x = xs[j] as number;
      const z = zs[j] as number;
      const ex = exs[j] as number;
      const ez = ezs[j] as number;
      const xh = x + cutD - cutD;
      const zh = z + cutD - cutD;
      const xl = x - xh;
      const zl = z - zh;
      const exh = ex + cutE - cutE;
      const ezh = ez + cutE - cutE;
      const pxh = exh - wholeX;
      const pzh = ezh - wholeZ;
      const pxl = ex - exh - restX;
      const pzl = ez - ezh - restZ;
      const t = (near[j] as number) + cutT - cutT;
      const qx = pxh + t * xh;
      const qz = pzh + t * zh;
      const qxl = pxl + t * xl;
      const qzl = pzl + t * zl;
      const atX = qx + qxl;
      const atZ = qz + qzl;
      const gx = atX * x;
      const gz = atZ * z;
      gs[j] = gx + gz;
      reach[j] = Math.abs(gx) + Math.abs(gz);
      const round = qx * qx + qz * qz;
      fNear[j] = round - wholeRho + (qxl * (qx + atX) + qzl * (qz + atZ) - restRho);
      const v = (far[j] as number) + cutT - cutT;
      const wx = pxh + v * xh;
      const wz = pzh + v * zh;
      const wxl = pxl + v * xl;
      const wzl = pzl + v * zl;
      const wide = wx * wx + wz * wz;
      fFar[j] = wide - wholeRho + (wxl * (wx + wx + wxl) + wzl * (wz + wz + wzl) - restRho);
      wholeNear[j] = t;
      wholeFar[j] = v;
      spread[j] = Math.abs(qx) + Math.abs(qz);
      spreadFar[j] = Math.abs(wx) + Math.abs(wz);
    }
  };
}
