import type { Planar } from '../../batch/planar.ts';
import type { Quadric } from '../../batch/quadric.ts';
import * as dd from '../../float/double-double.ts';
import { productError, SPLITTER, squareError, sumError } from '../../float/eft.ts';
import type { Hit } from '../../intersection.ts';
import { lazily } from '../../lazily.ts';
import type { Ray } from '../../ray.ts';
import type { Vec3 } from '../../vec3.ts';
import {
  type Algebra,
  AT_FLARE,
  AT_FLARE_LOW,
  AT_PX,
  AT_PX_LOW,
  AT_PY,
  AT_PY_LOW,
  AT_PZ,
  AT_PZ_LOW,
  createAlgebra,
  createRoots,
  lost,
  NEAR,
  ROOT_LOW,
  ROOT_OFF,
  type Roots,
} from './algebra.ts';
import { FAITHFUL, U, UU } from './numbers.ts';

/*
 * Point and normal from a root t + tl that is off by at most `off`.
 *
 *   quantity          bound                   reason
 *   E + t d, p + t d  off |d| + u²|X|         product and sum are split without loss; what is left,
 *                     + 8u²|t d|              ≤ u|X| and a few u|t d|, is rounded. `off` must have
 *                                             room for the last
 *   a coordinate      rounded to a double     faithful where its error is below u/4 of it; one
 *                                             along which the line does not move is E's own
 */
/** Of the normal's longest component: its direction is promised within 2^-50. */
const STRAIGHT = 2 ** -52;
/** Absolute bound on a coordinate, for underflow. */
export const LOST_POINT = 2 ** -1070;
/** Least longest component of a normal whose direction is promised. */
export const SMALLEST_NORMAL = 2 ** -600;

/**
 * The hit at root k of `roots`, which goes by the double that was `certified` for it, with E − C
 * and a from `algebra`; null where a coordinate, or the way of the normal, stays open.
 */
export function hitAt(
  q: Quadric,
  { origin: E, direction: d }: Ray,
  algebra: Algebra,
  roots: Roots,
  k: number,
  certified: number,
): Hit | null {
  const t = roots[k] as number;
  const tl = roots[k + ROOT_LOW] as number;
  const off = roots[k + ROOT_OFF] as number;
  let big = SPLITTER * t;
  const th = big - (big - t);
  const tm = t - th;
  const dx = d[0];
  const dy = d[1];
  const dz = d[2];
  const mx = t * dx;
  const my = t * dy;
  const mz = t * dz;
  big = SPLITTER * dx;
  const xh = big - (big - dx);
  big = SPLITTER * dy;
  const yh = big - (big - dy);
  big = SPLITTER * dz;
  const zh = big - (big - dz);
  const lx = lost(th, tm, xh, dx - xh, mx) + tl * dx;
  const ly = lost(th, tm, yh, dy - yh, my) + tl * dy;
  const lz = lost(th, tm, zh, dz - zh, mz) + tl * dz;
  const X = E[0] + mx;
  const Y = E[1] + my;
  const Z = E[2] + mz;
  const pointX = X + (sumError(E[0], mx, X) + lx);
  const pointY = Y + (sumError(E[1], my, Y) + ly);
  const pointZ = Z + (sumError(E[2], mz, Z) + lz);
  const offX = dx === 0 ? 0 : off * Math.abs(dx) + LOST_POINT;
  const offY = dy === 0 ? 0 : off * Math.abs(dy) + LOST_POINT;
  const offZ = dz === 0 ? 0 : off * Math.abs(dz) + LOST_POINT;
  const faithful =
    offX + 16 * UU * Math.abs(X) <= FAITHFUL * Math.abs(pointX) &&
    offY + 16 * UU * Math.abs(Y) <= FAITHFUL * Math.abs(pointY) &&
    offZ + 16 * UU * Math.abs(Z) <= FAITHFUL * Math.abs(pointZ);
  if (!faithful) return null;
  const px = algebra[AT_PX] as number;
  const py = algebra[AT_PY] as number;
  const pz = algebra[AT_PZ] as number;
  const nx = px + mx;
  const ny = py + my;
  const nz = pz + mz;
  const normalX = nx + (sumError(px, mx, nx) + lx + (algebra[AT_PX_LOW] as number));
  const rise = sumError(py, my, ny) + ly + (algebra[AT_PY_LOW] as number);
  const above = ny + rise;
  const normalZ = nz + (sumError(pz, mz, nz) + lz + (algebra[AT_PZ_LOW] as number));
  const a = algebra[AT_FLARE] as number;
  const down = a * above;
  const normalY = q.hasY
    ? -(
        down +
        (productError(a, above, down) +
          a * (rise - (above - ny)) +
          (algebra[AT_FLARE_LOW] as number) * above)
      )
    : 0;
  const size = Math.abs(a);
  const long = Math.max(Math.abs(normalX), Math.abs(normalY), Math.abs(normalZ));
  const around = Math.abs(px) + Math.abs(pz) + size * Math.abs(py);
  if (!(offX + offZ + size * offY + 32 * UU * around + SMALLEST_NORMAL <= STRAIGHT * long))
    return null;
  return {
    t: certified,
    point: [pointX + 0, pointY + 0, pointZ + 0],
    normal: [normalX + 0, normalY + 0, normalZ + 0],
    singular: false,
  };
}

/*
 * Points and normals where a faithful root t is known and the exact one, t*, is wanted: δ = t* − t
 * is one Newton step on a residual in double-double (float/double-double.ts has the bounds: a sum
 * 3u², a product 5u²). u = 2^-53; |δ| ≤ τ = 2u|t| + 2^-1074; i runs over x, y, z.
 *
 *   quantity                  bound                    reason
 *   g = E − C + t d           3u²|gi|                  a sum of two double-doubles that are exact
 *   curved:
 *   F = gx² + gz² − a gy² − ρ 22u² (gx² + gz² +        a square 6 + 5, times a 5 more, two sums
 *                             |a|gy² + ρ)
 *   2h = 2(gx dx + gz dz      13u Σ ai|gi di|          in doubles: 5u of each, and u of F' at the
 *   − a gy dy)                                         end; ai = 1, |a|, 1
 *   −F/2h for δ               η'τ + |δF|/|2h|          F + 2hδ + Aδ² = 0, so δ = −F/(2h + Aδ), |Aδ|
 *                                                      ≤ τ Am, Am = Σ ai di²; η' = (|δ2h| + τ Am)
 *                                                      / |2h|
 *   F' = 2h − A F/2h          13u Σ ai|gi di|          A·F/2h in doubles is off by 8u τ Am. From
 *                             + τ Am (η' + 8u)         far away that matters: τ is long there
 *                             + Am |δF|/|2h|
 *   flat:
 *   F = N·g                   14u² Σ|Ni gi|            a product 3 + 5, two sums
 *   F' = N·d                  3u Σ|Ni di|              u and two sums
 *
 * δ* F'* = −F* and δ F' = −F give (δ* − δ)F' = δ*(F' − F'*) − (F* − F): if F' is off by η of
 * itself, −F/F' is off by Δ ≤ |δF|/|F'| + ητ, and 2u|δ| ≤ 4u²|t| for the quotient and F's lower
 * half. hitAt adds 8u²|t|: ROUNDED is both. Underflow: with g, r, √|a| and |N|₁ below WIDE what t·d
 * lost, times 2g and a, is below SMALLEST_PLACE in F; and in F' too, for t·d is only below 2^-968
 * for |d| < 2^106. But d may be of any length, since A·(F/2h) is no larger than F' (A·F overflowed,
 * and a slope of ∞ made δ and Δ 0) and is made of dx·(F/2h·dx) … (A underflowed, and Aδ with it:
 * both in tests/repro).
 */
/** Bounds of the table, with room: of F, 2h, N·g and N·d in their terms, and of δ in |t|. */
export const ERROR_CURVED = 24 * UU;
export const ERROR_SLOPE = 14 * U;
export const ERROR_FLAT = 16 * UU;
export const ERROR_FLAT_RATE = 4 * U;
export const ROUNDED = 14 * UU;
/** Limit for |g|, r, √|a| and |N|₁, below which the bounds for underflow hold. */
export const WIDE = 2 ** 120;
/** Absolute bound on F, for underflow. */
export const SMALLEST_PLACE = 2 ** -711;
/** What t·d and δ·d may lose of a coordinate below the doubles, */
export const LOST_PLACE = 2 ** -1072;
/** and what a step that is below them itself, with its bound. */
export const TINY = 2 ** -1072;

/**
 * Numbers of a step, two doubles each, from these places on: g, F, a (of a curved shape), and two
 * that are used on the way. putPlace writes g, and the step's own function the others.
 */
export type Place = Float64Array;
const PLACE_GX = 0;
const PLACE_GY = 2;
const PLACE_GZ = 4;
const PLACE_G = [PLACE_GX, PLACE_GY, PLACE_GZ] as const;
/** Index of F in `Place`. */
export const PLACE_F = 6;
const PLACE_A = 8;
const PLACE_A_LOW = 9;
const PLACE_S = 10;
const PLACE_S_LOW = 11;
const PLACE_V = 12;
const PLACE_V_LOW = 13;

/**
 * What a step fills: its numbers, p and a as hitAt reads them, in the ray's own units (the stage
 * that found t may have had it in others), and the root. Valid until the next step.
 */
export interface Step {
  readonly place: Place;
  readonly algebra: Algebra;
  readonly roots: Roots;
}
/** A `Step` of zeros. */
export const createStep = (): Step => ({
  place: new Float64Array(14),
  algebra: createAlgebra(),
  roots: createRoots(),
});
const ownStep = lazily(createStep);

/** Puts g, and p for hitAt. */
function putPlace(
  { place, algebra }: Step,
  { origin, direction }: Ray,
  center: Vec3,
  t: number,
): void {
  for (let i = 0; i < 3; i++) {
    const e = origin[i] as number;
    const c = center[i] as number;
    const x = direction[i] as number;
    const p = e - c;
    const low = sumError(e, -c, p);
    place[PLACE_S] = p;
    place[PLACE_S_LOW] = low;
    algebra[AT_PX + 2 * i] = p;
    algebra[AT_PX_LOW + 2 * i] = low;
    const v = t * x;
    place[PLACE_V] = v;
    place[PLACE_V_LOW] = productError(t, x, v);
    dd.add(place, PLACE_G[i] as number, PLACE_S, PLACE_V);
  }
}

function putSquare(place: Place, out: number, x: number): void {
  const square = x * x;
  place[out] = square;
  place[out + 1] = squareError(x, square);
}

/**
 * Puts t, δ and Δ as root k, from F with its error, F' and its error; false where F' is not known
 * well enough, or has overflowed (FAITHFUL): η, δ and Δ would be 0, and E + t d would pass for the
 * point. |F'| < ∞ also says that nothing on the way to it has overflowed: a sum or a product of ∞
 * is ∞ or NaN, except that F/2h is 0 where 2h is ∞, and then F' is ∞ or NaN by 2h itself.
 */
export function putStep(
  roots: Roots,
  k: number,
  t: number,
  F: number,
  offF: number,
  slope: number,
  offSlope: number,
): boolean {
  const steep = Math.abs(slope);
  const eta = (offSlope + SMALLEST_PLACE) / steep;
  roots[k] = t;
  roots[k + ROOT_LOW] = -F / slope;
  roots[k + ROOT_OFF] =
    (offF + SMALLEST_PLACE) / steep + (2 * U * eta + ROUNDED) * Math.abs(t) + TINY;
  return eta <= 0.25 && steep < Number.POSITIVE_INFINITY;
}

/**
 * (dx² + dz² − a·dy²)·s, each square begun with s: of a short d the squares alone would vanish
 * while s is long.
 */
const times = (a: number, [x, y, z]: Vec3, s: number): number =>
  x * (s * x) + z * (s * z) - a * (y * (s * y));

/**
 * The step from the faithful root t of a curved shape, as root k; false where it is not known well
 * enough, or a number is too large.
 */
export function stepOnQuadric(step: Step, q: Quadric, ray: Ray, k: number, t: number): boolean {
  const { place, algebra, roots } = step;
  const { origin: E, direction: d } = ray;
  // A cylinder does not look at y: from E's own height nothing is subtracted.
  putPlace(step, ray, [q.Cx, q.hasY ? q.Cy : E[1], q.Cz], t);
  const x = place[PLACE_GX] as number;
  const y = place[PLACE_GY] as number;
  const z = place[PLACE_GZ] as number;
  if (q.squared) putSquare(place, PLACE_A, q.flare);
  else dd.set(place, PLACE_A, q.flare);
  const a = place[PLACE_A] as number;
  algebra[AT_FLARE] = a;
  algebra[AT_FLARE_LOW] = place[PLACE_A_LOW] as number;
  const size = Math.abs(a);
  dd.sqr(place, PLACE_F, PLACE_GX);
  dd.sqr(place, PLACE_S, PLACE_GZ);
  dd.add(place, PLACE_F, PLACE_F, PLACE_S);
  dd.sqr(place, PLACE_S, PLACE_GY);
  dd.mul(place, PLACE_S, PLACE_S, PLACE_A);
  dd.sub(place, PLACE_F, PLACE_F, PLACE_S);
  putSquare(place, PLACE_S, q.r);
  dd.sub(place, PLACE_F, PLACE_F, PLACE_S);
  const F = place[PLACE_F] as number;
  const offF = ERROR_CURVED * (x * x + z * z + size * y * y + q.r * q.r);
  const slope = 2 * (x * d[0] + z * d[2] - a * (y * d[1]));
  const offSlope =
    ERROR_SLOPE * (Math.abs(x * d[0]) + Math.abs(z * d[2]) + size * Math.abs(y * d[1]));
  const bend = times(-size, d, 2 * U * Math.abs(t) + TINY);
  const eta = (offSlope + bend + SMALLEST_PLACE) / Math.abs(slope);
  const bent = slope - times(a, d, F / slope);
  const offBent = offSlope + bend * (eta + 8 * U) + times(-size, d, offF / Math.abs(slope));
  const known = eta <= 0.25 && putStep(roots, k, t, F, offF, bent, offBent);
  const narrow = Math.max(Math.abs(x), Math.abs(y), Math.abs(z), q.r) < WIDE && size < WIDE * WIDE;
  return known && narrow;
}

/**
 * The hit at the faithful root t, or null where a component stays open, or all of the normal's are
 * zero.
 */
export function placeOnQuadric(q: Quadric, ray: Ray, t: number): Hit | null {
  const own = ownStep();
  return stepOnQuadric(own, q, ray, NEAR, t)
    ? hitAt(q, ray, own.algebra, own.roots, NEAR, t)
    : null;
}

/** As `placeOnQuadric`; the normal is N itself. */
export function placeInPlane({ N, P }: Planar, ray: Ray, t: number): Hit | null {
  const { origin: E, direction: d } = ray;
  const own = ownStep();
  const { place, roots } = own;
  putPlace(own, ray, P, t);
  let rate = 0;
  let steep = 0;
  let sharp = 0;
  let size = 0;
  dd.set(place, PLACE_F, 0);
  for (let i = 0; i < 3; i++) {
    const n = N[i] as number;
    const x = d[i] as number;
    const g = PLACE_G[i] as number;
    dd.mulDouble(place, PLACE_S, g, n);
    dd.add(place, PLACE_F, PLACE_F, PLACE_S);
    rate += n * x;
    steep += Math.abs(n * x);
    sharp += Math.abs(n * (place[g] as number));
    size = Math.max(size, Math.abs(n), Math.abs(place[g] as number));
  }
  const F = place[PLACE_F] as number;
  const offRate = ERROR_FLAT_RATE * steep;
  const known = putStep(roots, NEAR, t, F, ERROR_FLAT * sharp, rate, offRate);
  if (!known || !(size < WIDE)) return null;
  const delta = roots[NEAR + ROOT_LOW] as number;
  const off = roots[NEAR + ROOT_OFF] as number;
  const point: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < 3; i++) {
    const e = E[i] as number;
    const x = d[i] as number;
    const m = t * x;
    const s = e + m;
    const p = s + (sumError(e, m, s) + productError(t, x, m) + delta * x);
    const offX = x === 0 ? 0 : off * Math.abs(x) + 16 * UU * Math.abs(s) + LOST_PLACE;
    if (!(offX <= FAITHFUL * Math.abs(p))) return null;
    point[i] = p + 0;
  }
  return { t, point, normal: [N[0], N[1], N[2]], singular: false };
}
