import type { Quadric } from '../batch/quadric.ts';
import { SPLITTER } from '../float/eft.ts';
import type { Fate, Hit } from '../intersection.ts';
import { DIRECT_ERROR, LARGEST, LEAST_A, SMALLEST_DIRECT } from '../methods/certified/class.ts';
import { LOST_POINT, SMALLEST_NORMAL } from '../methods/certified/hits.ts';
import { AT_SCALED, type CertifiedQuadric, FAITHFUL_ONCE } from '../methods/certified/numbers.ts';
import type { Ray } from '../ray.ts';

/*
 * One ray, one curved shape, and no more of it than is asked for: the class by a filter, then a
 * root by one Newton step on a residual in twice the digits. What stays open is OPEN here, and goes
 * to the slow stages of `certified`.
 *
 * The class: D/4 = b² − AC with the bound of class.ts.
 *
 * A root from an approximation t, with u = 2^-53, p = E − C as two doubles exactly, Gi = |pi| +
 * |t di|, G² = Gx² + Gz² + |a|Gy² + ρ, K = Gx|dx| + Gz|dz| + |a|Gy|dy|, Am = dx² + dz² + |a|dy²:
 *
 *   quantity                  bound             reason
 *   g = p + t d = s + l       4.1u² Gi          t·d and the sum are split without loss; l is two
 *                                               sums of numbers below 2uGi
 *   g²                        22u² Gi²          s² split; l² ≤ 4u²Gi² left out; 2s·l and its sum
 *                                               10, 2s·δg 8.2
 *   a g²                      40u² |a|Gy²       the same; a·s² split, three products more of l's
 *                                               size
 *   F = gx² + gz² − a gy² − ρ 128u² G² + u|F|   sums of leading parts split; what is left over adds
 *                                               up in seven steps, on 12u G² at most
 *   F' = 2(gx dx + … )        20u K             s for g 2u·2K, products 3u each, sums 2u
 *   x = −F/F' for t* − t      2u|x| of its own  F' x + F = −A x²; with Am|x| ≤ 2^-20|F'| there is a
 *                             + Am·4x²/|F'|     root within 2|x|, and F' has its sign there
 *
 * So t + x is off by Δ = (128u² G² + 4Am x² + 20uK|x|)/|F'| + 5u|x|, and faithful when rounded once
 * if Δ ≤ FAITHFUL_ONCE |t + x|. Of two roots the near one is that where F' has not A's sign: which
 * of both was found does not depend on how good the approximation was.
 *
 * Underflow: with all numbers of G² and Am below 2^400, what a product loses (2^-1073) is
 * multiplied by 2s·a < 2^400 at most, which is far below u² SMALLEST_DIRECT.
 *
 * Which root is wanted where only those from 0 on count: with D > 0, and A and C certain by the
 * bounds of class.ts (7u of Cm; LEAST_A), roots of unlike signs have A C < 0, and the far one is
 * it. Else b² > D > 27u AmCm says that b, known to 5u√(AmCm), has its sign, and both roots have
 * that of −b/A. Nothing but signs of exact numbers, and so the same answer as by both roots.
 *
 * The point E + t* d is E + m + (l + x d) with m = fl(t d): off by Δ|d| and 4u of what is small.
 * The normal is that of g + x d; 2^-54 of its longest component is left for it, and each is rounded
 * three times at most: its direction is right to 2^-51.
 */

/** No verdict. */
export const OPEN = -1;
/** Added to what was found: its point and normal are not certain. */
export const UNPLACED = 4;

/** The near root, the far one; the lesser one of those from 0 on; whether there is such a one. */
export const NEAR = 1;
export const FAR = 2;
export const FIRST = 3;
export const ANY = 4;
type Wanted = typeof NEAR | typeof FAR | typeof FIRST | typeof ANY;

/** Which root was found, from what AskOne says; 0: there is none. */
export const rootOf = (said: number): number => said & 3;

/** A hit that is filled again and again, so that nothing is allocated for one. */
export interface HitRoom {
  /** As of a Hit, and so are the others. */
  t: number;
  readonly point: [number, number, number];
  readonly normal: [number, number, number];
  singular: boolean;
  fate: Fate;
}

/**
 * Room for one hit.
 *
 * @example
 * createHit().fate; // → 'hit'
 */
export const createHit = (): HitRoom => ({
  // Doubles from the beginning, so that V8 need not change their representation.
  t: Number.NaN,
  point: [Number.NaN, Number.NaN, Number.NaN],
  normal: [Number.NaN, Number.NaN, Number.NaN],
  singular: false,
  fate: 'hit',
});

/** Copies a hit, whatever else it has, and whatever became of the root. */
export function put(out: HitRoom, { t, point, normal, singular }: Hit): void {
  out.t = t;
  for (let i = 0; i < 3; i++) {
    out.point[i] = point[i] as number;
    out.normal[i] = normal[i] as number;
  }
  out.singular = singular;
}

/**
 * Puts one root of a ray, with its point and normal if `placed`; for ANY nothing. NEAR or FAR with
 * or without UNPLACED, 0 where there is none that is wanted, or OPEN.
 */
export type AskOne = (ray: Ray, wanted: Wanted, placed: boolean, out: HitRoom) => number;

/**
 * For one curved shape. In one piece, error-free transforms (float/eft.ts) and all: a call that is
 * not inlined boxes its doubles, and what is not a literal, or captured, is looked up at each use.
 */
export function sharpLine({ hasY }: Quadric, { inBox, numbers }: CertifiedQuadric): AskOne {
  const at = (k: number): number => numbers[k] as number;
  const [Cx, Cz] = [at(AT_SCALED.Cx), at(AT_SCALED.Cz)];
  const Cy = hasY ? at(AT_SCALED.Cy) : 0;
  const [a, aLow] = [at(AT_SCALED.flare), at(AT_SCALED.flareLow)];
  const [rho, rhoLow] = [at(AT_SCALED.rho), at(AT_SCALED.rhoLow)];
  const size = Math.abs(a);
  const aBig = SPLITTER * a;
  const aHigh = aBig - (aBig - a);
  const aRest = a - aHigh;
  // A sphere's: products with it are exact.
  const isUnit = size === 1 && aLow === 0;
  const largest = inBox ? LARGEST : 0;
  const [direct, smallest, leastA] = [DIRECT_ERROR, SMALLEST_DIRECT, LEAST_A];
  const [once, lostPoint, smallestNormal] = [FAITHFUL_ONCE, LOST_POINT, SMALLEST_NORMAL];

  return ({ origin, direction }, wanted, placed, out) => {
    const ex = origin[0];
    const ey = origin[1];
    const ez = origin[2];
    const dx = direction[0];
    const dy = direction[1];
    const dz = direction[2];
    const px = ex - Cx;
    const py = ey - Cy;
    const pz = ez - Cz;
    const along = a * (dy * dy);
    const across = dx * dx + dz * dz;
    const above = a * (py * py);
    const away = px * px + pz * pz;
    const A = across - along;
    const b = dx * px + dz * pz - a * (dy * py);
    const C = away - above - rho;
    const Am = across + Math.abs(along);
    const Cm = away + Math.abs(above) + rho;
    const D = b * b - A * C;
    if (!(Math.abs(D) > direct * (Am * Cm) + smallest && Am + Cm < largest)) return OPEN;
    if (D < 0) return 0;
    if (!(Math.abs(A) > leastA * Am)) return OPEN;
    let isFar = wanted === FAR;
    if (wanted > FAR) {
      const certain = Math.abs(C) > direct * Cm + smallest;
      isFar = certain && A > 0 !== C > 0;
      // Both are below 0.
      if (certain && !isFar && A > 0 === b > 0) return 0;
      if (wanted === ANY) return certain ? NEAR : OPEN;
    }
    const root = Math.sqrt(D);
    const larger = b < 0 ? root - b : -b - root;
    // The near one is larger/A where these differ in sign.
    const t = (A > 0 === larger < 0) === isFar ? C / larger : larger / A;
    const mx = t * dx;
    const my = t * dy;
    const mz = t * dz;
    const sx = px + mx;
    const sy = py + my;
    const sz = pz + mz;
    const slope = 2 * (sx * dx + sz * dz - a * (sy * dy));
    const inverse = 1 / slope;
    const splitter = 134217729;
    let big = splitter * t;
    const th = big - (big - t);
    const tl = t - th;
    big = splitter * dx;
    let h = big - (big - dx);
    let r = dx - h;
    const mxl = tl * r - (mx - th * h - tl * h - th * r);
    big = splitter * dy;
    h = big - (big - dy);
    r = dy - h;
    const myl = tl * r - (my - th * h - tl * h - th * r);
    big = splitter * dz;
    h = big - (big - dz);
    r = dz - h;
    const mzl = tl * r - (mz - th * h - tl * h - th * r);
    let part = sx - px;
    let own = px - ex;
    const lx = px - (sx - part) + (mx - part) + mxl + (ex - (px - own) - (Cx + own));
    part = sy - py;
    own = py - ey;
    const ly = py - (sy - part) + (my - part) + myl + (ey - (py - own) - (Cy + own));
    part = sz - pz;
    own = pz - ez;
    const lz = pz - (sz - part) + (mz - part) + mzl + (ez - (pz - own) - (Cz + own));
    const xx = sx * sx;
    const yy = sy * sy;
    const zz = sz * sz;
    const ayy = a * yy;
    big = splitter * sx;
    h = big - (big - sx);
    r = sx - h;
    const xxl = r * r - (xx - h * h - 2 * (h * r)) + 2 * sx * lx;
    big = splitter * sy;
    h = big - (big - sy);
    r = sy - h;
    const yyl = r * r - (yy - h * h - 2 * (h * r)) + 2 * sy * ly;
    big = splitter * sz;
    h = big - (big - sz);
    r = sz - h;
    const zzl = r * r - (zz - h * h - 2 * (h * r)) + 2 * sz * lz;
    let ayyl = a * yyl;
    if (!isUnit) {
      big = splitter * yy;
      h = big - (big - yy);
      r = yy - h;
      ayyl = aRest * r - (ayy - aHigh * h - aRest * h - aHigh * r) + (ayyl + aLow * yy);
    }
    const round = xx + zz;
    const curved = round - ayy;
    const lead = curved - rho;
    part = round - xx;
    let lost = xx - (round - part) + (zz - part);
    part = curved - round;
    lost += round - (curved - part) - (ayy + part);
    part = lead - curved;
    lost += curved - (lead - part) - (rho + part);
    const F = lead + (lost + (xxl + zzl) - ayyl - rhoLow);
    const gx = Math.abs(px) + Math.abs(mx);
    const gy = Math.abs(py) + Math.abs(my);
    const gz = Math.abs(pz) + Math.abs(mz);
    const reach = gx * gx + gz * gz + size * (gy * gy) + rho;
    const K = gx * Math.abs(dx) + gz * Math.abs(dz) + size * (gy * Math.abs(dy));
    const steep = Math.abs(slope);
    const step = -F * inverse;
    const far = Math.abs(step);
    const u = 2 ** -53;
    const errorF = 2 ** -99;
    const narrow = 2 ** -20;
    const off =
      1.05 *
      ((errorF * reach + far * (4 * Am * far + 20 * u * K)) * Math.abs(inverse) + 5 * u * far);
    const found = t + step;
    const known =
      off <= once * Math.abs(found) &&
      reach < largest &&
      steep * Math.abs(t) > smallest &&
      20 * u * K <= narrow * steep &&
      Am * far <= narrow * steep &&
      slope < 0 === (A > 0 === !isFar);
    if (!known) return OPEN;
    out.t = found;
    const told = isFar ? FAR : NEAR;
    if (!placed) return told;
    const stepX = step * dx;
    const stepY = step * dy;
    const stepZ = step * dz;
    const X = ex + mx;
    const Y = ey + my;
    const Z = ez + mz;
    part = X - ex;
    const x = X + (ex - (X - part) + (mx - part) + (mxl + stepX));
    part = Y - ey;
    const y = Y + (ey - (Y - part) + (my - part) + (myl + stepY));
    part = Z - ez;
    const z = Z + (ez - (Z - part) + (mz - part) + (mzl + stepZ));
    const { point, normal } = out;
    point[0] = x + 0;
    point[1] = y + 0;
    point[2] = z + 0;
    const sizeX = Math.abs(stepX);
    const sizeY = Math.abs(stepY);
    const sizeZ = Math.abs(stepZ);
    const offX = off * Math.abs(dx) + 4 * u * (u * (Math.abs(X) + Math.abs(mx)) + sizeX);
    const offY = off * Math.abs(dy) + 4 * u * (u * (Math.abs(Y) + Math.abs(my)) + sizeY);
    const offZ = off * Math.abs(dz) + 4 * u * (u * (Math.abs(Z) + Math.abs(mz)) + sizeZ);
    const isPoint =
      (dx === 0 || offX + lostPoint <= once * Math.abs(x)) &&
      (dy === 0 || offY + lostPoint <= once * Math.abs(y)) &&
      (dz === 0 || offZ + lostPoint <= once * Math.abs(z));
    if (!isPoint) return told + UNPLACED;
    const rise = sy + (ly + stepY);
    const nx = sx + (lx + stepX);
    const ny = hasY ? -(a * rise + aLow * rise) : 0;
    const nz = sz + (lz + stepZ);
    const offN =
      off * (Math.abs(dx) + size * Math.abs(dy) + Math.abs(dz)) +
      4 * u * (2 * u * (gx + size * gy + gz) + (sizeX + size * sizeY + sizeZ));
    const long = Math.max(Math.abs(nx), Math.abs(ny), Math.abs(nz));
    if (!(offN + smallestNormal <= 2 ** -54 * long)) return told + UNPLACED;
    normal[0] = nx + 0;
    normal[1] = ny + 0;
    normal[2] = nz + 0;
    out.singular = false;
    return told;
  };
}
