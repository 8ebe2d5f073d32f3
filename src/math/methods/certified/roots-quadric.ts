import type { Answers, Rays } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { count, doubtful, ordinaryRoots } from './lattice-roots.ts';
import { BLOCK, DOUBTS } from './lattice-scratch.ts';
import { recentredAroundAxis, recentredInSpace } from './recentred.ts';
import { BOX, type CertifiedQuadric } from './scaled-quadric.ts';

/*
 * Both roots of curved shapes, in two passes over a block of rays that stays in the first cache.
 *
 * Pass 1, the filter. u = 2^-53. Coordinates along y are multiplied by k = √|a|: Y = k·dy, PY = k·(Ey − Cy), so all three
 * are alike. p = fl(E − C) is off by u; k by u, so Y by 2u and PY by 3u.
 *
 *   m = d × p: each of its two products is off by ≤ 4u, the difference by u|m|:           |δmi| ≤ 4u Si + u|mi|
 *   mi²:       2|mi|(4u Si + u|mi|) + (5u Si)² + u mi²:                                   ≤ 8u |mi| Si + 3u mi² + 25u² Si²
 *   ρA:        A: dx² 3u, Y² (4 + 2)u; ρ u; the product u:                                ≤ 8u ρ Am
 *   D/4 = ρA ± (mx² + mz²) − my²: three more sums, each of which adds u of what it adds:
 *              |δ(D/4)| ≤ Σ (8u|mi|Si + 6u mi²) + 10u ρAm + 25u² Σ Si²  ≤ u·(14 M S + 10 ρAm + 25u S²)
 *
 * with Si = |dj pk| + |dk pj|, S = |d|₁|p|₁ ≥ ΣSi, M = Σ|mi|, mi² ≤ |mi| Si. MOMENT_ERROR, SQUARE_ERROR and RHO_ERROR are these
 * constants with room for terms in u² and for evaluating the bound in doubles (a relative 20u). Unlike 13u·S² it stays sharp
 * however far away E is, where M ≪ S.
 *
 * Underflow: inside the box (|d|₁ from 2^-100 to 2^100, |p|₁ and r and k up to 2^100) a lost product is ≤ 2^-1074, and at
 * most 2^600 multiplies it; SMALLEST_D is far above.
 */
const MOMENT_ERROR = 16 * 2 ** -53;
const SQUARE_ERROR = 32 * 2 ** -106;
const RHO_ERROR = 12 * 2 ** -53;
const SMALLEST_D = 2 ** -200;

/*
 * What pass 2 asks of pass 1:
 *   D > 2^17 δD                so √D is known to 2^-18;
 *   D > 2^-84 S²               so b's rounding error (≤ 8uS = 2^-50 S) and t's are below 2^-7 √D: each coarse root is nearer to its own root than
 *                              to the other one;
 *   |A| > 2^-20 Am             so A ≠ 0, and A is known to 6u · 2^20 < 2^-30.
 */
const CLEAR = 2 ** 17;
const APART = 2 ** -84;
export const LEAST_A = 2 ** -20;

/** The bound on |δ(D/4)| that is derived above. */
export const momentError = (S: number, M: number, rhoAm: number): number =>
  S * (MOMENT_ERROR * M + SQUARE_ERROR * S) + RHO_ERROR * rhoAm + SMALLEST_D;

/*
 * Most rays need no sharp bound: with Pm = |p|² and Q = Am (Pm + ρ), S² ≤ 9 Am Pm and M ≤ S, so |δ(D/4)| < 145u Q < 2^-45 Q. D > 2^-28 Q then gives
 * all that pass 2 asks for but the condition on A. Only rays in between, far or grazing ones, are looked at with the sharp bound.
 */
const PLAIN_ERROR = 2 ** -45;
const PLAIN_CLEAR = 2 ** -28;
const LARGEST_SQUARE = BOX * BOX;

/*
 * Pass 2, Newton's step on grids. (x + σ) − σ is x rounded to a whole multiple of g = ulp(σ)/2; for |x| ≤ S and σ = 2^m S it
 * has |x|/g < 2^(54−m) and what is left over is ≤ 2^(m−52) S, exactly (Sterbenz; Rump, Ogita, Oishi 2008 call it ExtractVector).
 *
 * For each coarse root t let L = |t||d|₁ + |p|₁ be its reach and T = L/|d|₁. With d = dh + dl and t = th + tl on grids for |d|₁ and T (m = 29: 25
 * bits), p = ph + pl on one for both reaches together (m = 6):
 *
 *   q = p + t d = (ph + th dh) + (th dl + tl d + pl),
 *
 * where the first bracket is exact: th dh is a multiple of G ≥ 2^-50 L with ≤ 2^50 units, ph a multiple of G (its grid is
 * > 2^-48 L ≥ G), and both together are ≤ 2L < 2^53 G. Errors in w = 2^-75 L:
 *   x, z:  th·dl ½, tl·d ½, their sum 1, + pl 1;                                                   ≤ 3w each
 *   y:     dl ¾, k·dy's rounding ½ more, and pl: k·(p's lower half) 1¾ + 1, a larger sum 2;        ≤ 10w
 * together ≤ 16w = 2^-71 L, and the second bracket is ≤ 2^-21 L in each coordinate. pl itself is ≤ 2^-46 of both reaches, and its rounding (2^-99
 * of them) negligible as long as they are ≤ 2^20 |p|₁ ≤ 2^20 L: that is SPREAD.
 *
 *   f = qx² + qz² ∓ qy² − ρ: with q = qh + ql on a grid for Sq = |q|₁ (m = 28: 26 bits) the sum of qh² is exact (≤ 2^52 units, partial
 * sums too), subtracting ρ loses u|fh|, since the result is small. ql ≤ 2^-24 Sq + 2^-21 L ≤ 2^-21 W, W = Sq + L.
 *   Σ ql(2qh + ql), ≤ 2^-20 W Sq: rounding ql 1, the bracket 1, the product 1, three sums 3, k's own error 1, fh 1, in 2^-73 W Sq; what q
 *   itself is off, 2^-71 L · 2Sq: 8 of them.  16 · 2^-73 = 2^-69 W Sq in all, and 2u|f|.
 *
 * From the coarse root with b' = b + A·t: b'² = D/4 + A f exactly, so the exact step is δ = ∓f/(√(D/4 + A f) + √(D/4)). Taking
 * f/(2√D̂) instead is off by |A f|/D (≤ 2^-17, that is STEP) and by √D's error 2^-18: together with rounding < 2^-16 of |δ|. Hence
 *   |error of the step| ≤ (2^-69 W Sq + 2^-16 |f|)/(2√(D/4)),
 * and the root is faithful when t + δ is rounded once and that is below u|t|/2 (neighbours of t are u|t| apart, at least).
 */
const RESIDUAL_ERROR = 2 ** -68;
const STEP = 2 ** -17;
const STEP_ERROR = 2 ** -16;
const SPREAD = 2 ** 20;
const FAITHFUL = 2 ** -55;

const GRID_25 = 2 ** 29;
const GRID_26 = 2 ** 28;
const GRID_P = 2 ** 6;
const SPLITTER = 134217729;

/*
 * The loops read their constants from these: V8 rebuilds a literal from an immediate at every use, and keeps what it loaded before the loop.
 * A tenth of the time.
 */
const FILTER = Float64Array.of(PLAIN_CLEAR, SMALLEST_D, PLAIN_ERROR, LARGEST_SQUARE, LEAST_A);
const BOUNDS = Float64Array.of(
  GRID_25,
  GRID_26,
  GRID_P,
  SPLITTER,
  RESIDUAL_ERROR,
  STEP_ERROR,
  FAITHFUL,
  SPREAD,
  STEP,
);

const hitIndex = new Int32Array(BLOCK);
const near = new Float64Array(BLOCK);
const far = new Float64Array(BLOCK);
const halfOverRoot = new Float64Array(BLOCK);
const sizeA = new Float64Array(BLOCK);
const sizeD = new Float64Array(BLOCK);
const overSpeed = new Float64Array(BLOCK);
let hits = 0;

/** Rays that the fast stages leave open, in `open[0 … count − 1]`. */
export interface OpenRays {
  count: number;
  open: Int32Array;
}

export function bothRoots(
  q: Quadric,
  c: CertifiedQuadric,
  rays: Rays,
  out: Answers,
  left: OpenRays,
): void {
  left.count = 0;
  for (let from = 0; from < rays.count; from += BLOCK) {
    const to = Math.min(from + BLOCK, rays.count);
    if (c.lattice) ordinaryRoots(c.lattice, q.hasY, rays, out, from, to);
    else leaveAll(from, to);
    const recentred = q.hasY ? recentredInSpace : recentredAroundAxis;
    const doubts = recentred(c.numbers, rays, out, doubtful, count[DOUBTS] as number);
    if (doubts === 0) continue;
    hits = 0;
    filterSharply(q, c, rays, out, left, doubts);
    if (q.hasY) refineInSpace(q, c, rays, out, left);
    else refineAroundAxis(q, c, rays, out, left);
  }
}

function leaveAll(from: number, to: number): void {
  for (let i = from; i < to; i++) doubtful[i - from] = i;
  count[DOUBTS] = to - from;
}

/** The doubtful rays with the sharp bound, for both kinds of shapes: about an axis Y and PY are 0. */
function filterSharply(
  { Cx, Cy, Cz, hasY }: Quadric,
  { k, sign, rho }: CertifiedQuadric,
  { Ex, Ey, Ez, dx, dy, dz }: Rays,
  { t0, t1 }: Answers,
  left: OpenRays,
  doubts: number,
): void {
  let found = 0;
  for (let j = 0; j < doubts; j++) {
    const i = doubtful[j] as number;
    const x = dx[i] as number;
    const y = hasY ? k * (dy[i] as number) : 0;
    const z = dz[i] as number;
    const px = (Ex[i] as number) - Cx;
    const py = hasY ? k * ((Ey[i] as number) - Cy) : 0;
    const pz = (Ez[i] as number) - Cz;
    const mx = y * pz - z * py;
    const my = z * px - x * pz;
    const mz = x * py - y * px;
    const round = x * x + z * z;
    const yy = y * y;
    const A = round - sign * yy;
    const D = rho * A + sign * (mx * mx + mz * mz) - my * my;
    const speed = Math.abs(x) + Math.abs(y) + Math.abs(z);
    const Sp = Math.abs(px) + Math.abs(py) + Math.abs(pz);
    const S = speed * Sp;
    const Am = round + yy;
    const error = momentError(S, Math.abs(mx) + Math.abs(my) + Math.abs(mz), rho * Am);
    const inside = speed < BOX && speed > 1 / BOX && Sp < BOX;
    if (D > CLEAR * error && inside && D > APART * (S * S) && Math.abs(A) > LEAST_A * Am) {
      const b = x * px + z * pz - sign * (y * py);
      const s = Math.sqrt(D);
      const As = A * s;
      const inverse = 1 / (As * speed);
      const overA = inverse * (s * speed);
      near[found] = (-b - s) * overA;
      far[found] = (s - b) * overA;
      halfOverRoot[found] = 0.5 * inverse * (A * speed);
      overSpeed[found] = inverse * As;
      sizeA[found] = Math.abs(A);
      sizeD[found] = D;
      hitIndex[found] = i;
      found += 1;
    } else if (D < -error && inside) {
      t0[i] = Number.NaN;
      t1[i] = Number.NaN;
    } else left.open[left.count++] = i;
  }
  hits = found;
}

function refineInSpace(
  { Cx, Cy, Cz }: Quadric,
  { k, k1, k2, sign, rho, rhoLow }: CertifiedQuadric,
  { Ex, Ey, Ez, dx, dy, dz }: Rays,
  { t0, t1 }: Answers,
  left: OpenRays,
): void {
  const grid25 = BOUNDS[0] as number;
  const grid26 = BOUNDS[1] as number;
  const gridOfP = BOUNDS[2] as number;
  const splitter = BOUNDS[3] as number;
  const residualError = BOUNDS[4] as number;
  const stepError = BOUNDS[5] as number;
  const faithful = BOUNDS[6] as number;
  const spread = BOUNDS[7] as number;
  const step = BOUNDS[8] as number;
  for (let j = 0; j < hits; j++) {
    const i = hitIndex[j] as number;
    const ta = near[j] as number;
    const tb = far[j] as number;
    const x = dx[i] as number;
    const z = dz[i] as number;
    const dyi = dy[i] as number;
    const ex = Ex[i] as number;
    const ey = Ey[i] as number;
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
    const over = overSpeed[j] as number;
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
    const half = halfOverRoot[j] as number;
    const ra = ta + fa * half;
    const rb = tb - fb * half;
    const f = Math.abs(fa);
    const g = Math.abs(fb);
    const errorA = half * (residualError * sizeOfA * (sizeOfA + reachA) + stepError * f);
    const errorB = half * (residualError * sizeOfB * (sizeOfB + reachB) + stepError * g);
    if (
      errorA <= faithful * Math.abs(ra) &&
      errorB <= faithful * Math.abs(rb) &&
      reachA + reachB <= spread * Sp &&
      (f + g) * (sizeA[j] as number) <= step * (sizeD[j] as number)
    ) {
      t0[i] = Math.min(ra, rb);
      t1[i] = Math.max(ra, rb);
    } else left.open[left.count++] = i;
  }
}

function refineAroundAxis(
  { Cx, Cz }: Quadric,
  { rho, rhoLow }: CertifiedQuadric,
  { Ex, Ez, dx, dz }: Rays,
  { t0, t1 }: Answers,
  left: OpenRays,
): void {
  const grid25 = BOUNDS[0] as number;
  const grid26 = BOUNDS[1] as number;
  const gridOfP = BOUNDS[2] as number;
  const residualError = BOUNDS[4] as number;
  const stepError = BOUNDS[5] as number;
  const faithful = BOUNDS[6] as number;
  const spread = BOUNDS[7] as number;
  const step = BOUNDS[8] as number;
  for (let j = 0; j < hits; j++) {
    const i = hitIndex[j] as number;
    const ta = near[j] as number;
    const tb = far[j] as number;
    const x = dx[i] as number;
    const z = dz[i] as number;
    const ex = Ex[i] as number;
    const ez = Ez[i] as number;
    const px = ex - Cx;
    const pz = ez - Cz;
    const vx = px - ex;
    const vz = pz - ez;
    const lostX = ex - (px - vx) - (Cx + vx);
    const lostZ = ez - (pz - vz) - (Cz + vz);
    const Sd = Math.abs(x) + Math.abs(z);
    const Sp = Math.abs(px) + Math.abs(pz);
    const over = overSpeed[j] as number;
    const reachA = Math.abs(ta) * Sd + Sp;
    const reachB = Math.abs(tb) * Sd + Sp;
    const gridD = grid25 * Sd;
    const gridA = grid25 * (over * reachA);
    const gridB = grid25 * (over * reachB);
    const gridP = gridOfP * (reachA + reachB);
    const xh = x + gridD - gridD;
    const zh = z + gridD - gridD;
    const xl = x - xh;
    const zl = z - zh;
    const phx = px + gridP - gridP;
    const phz = pz + gridP - gridP;
    const plx = px - phx + lostX;
    const plz = pz - phz + lostZ;
    // One root after the other: interleaved, more values are alive than there are registers.
    const tah = ta + gridA - gridA;
    const tal = ta - tah;
    const ax = phx + tah * xh;
    const az = phz + tah * zh;
    const sizeOfA = Math.abs(ax) + Math.abs(az);
    const gridQA = grid26 * sizeOfA;
    const axh = ax + gridQA - gridQA;
    const azh = az + gridQA - gridQA;
    const axl = ax - axh + (tah * xl + tal * x + plx);
    const azl = az - azh + (tah * zl + tal * z + plz);
    const fa =
      axh * axh + azh * azh - rho + (axl * (axh + axh + axl) + azl * (azh + azh + azl) - rhoLow);
    const tbh = tb + gridB - gridB;
    const tbl = tb - tbh;
    const bx = phx + tbh * xh;
    const bz = phz + tbh * zh;
    const sizeOfB = Math.abs(bx) + Math.abs(bz);
    const gridQB = grid26 * sizeOfB;
    const bxh = bx + gridQB - gridQB;
    const bzh = bz + gridQB - gridQB;
    const bxl = bx - bxh + (tbh * xl + tbl * x + plx);
    const bzl = bz - bzh + (tbh * zl + tbl * z + plz);
    const fb =
      bxh * bxh + bzh * bzh - rho + (bxl * (bxh + bxh + bxl) + bzl * (bzh + bzh + bzl) - rhoLow);
    const half = halfOverRoot[j] as number;
    const ra = ta + fa * half;
    const rb = tb - fb * half;
    const f = Math.abs(fa);
    const g = Math.abs(fb);
    const errorA = half * (residualError * sizeOfA * (sizeOfA + reachA) + stepError * f);
    const errorB = half * (residualError * sizeOfB * (sizeOfB + reachB) + stepError * g);
    if (
      errorA <= faithful * Math.abs(ra) &&
      errorB <= faithful * Math.abs(rb) &&
      reachA + reachB <= spread * Sp &&
      (f + g) * (sizeA[j] as number) <= step * (sizeD[j] as number)
    ) {
      t0[i] = ra;
      t1[i] = rb;
    } else left.open[left.count++] = i;
  }
}
