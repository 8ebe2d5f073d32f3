import type { Planar } from '../../batch/planar.ts';
import type { Quadric } from '../../batch/quadric.ts';
import * as dd from '../../float/double-double.ts';
import { productError, squareError, sumError } from '../../float/eft.ts';
import type { Hit } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import type { Vec3 } from '../../vec3.ts';
import { FLARE as ALGEBRA_FLARE, P as ALGEBRA_P, createAlgebra } from './algebra.ts';
import { FAITHFUL } from './faithful.ts';
import { createRoots, hitAt } from './hit-quadric.ts';

/*
 * Points and normals where a faithful root t is known and the exact one, t*, is wanted: δ = t* − t is one Newton step on a residual in double-double
 * (float/double-double.ts has the bounds: a sum 3u², a product 5u²). u = 2^-53; |δ| ≤ τ = 2u|t| + 2^-1074; i runs over x, y, z.
 *
 *   g = E − C + t d, a sum of two double-doubles that are exact:                                    |δgi| ≤ 3u²|gi|
 *   curved, F = gx² + gz² − a gy² − ρ: a square 6 + 5, times a 5 more, two sums:                    |δF| ≤ 22u² (gx² + gz² + |a|gy² + ρ)
 *     F' = 2h = 2(gx dx + gz dz − a gy dy) in doubles: 5u of each, and u of F' at the end:          |δ2h| ≤ 13u Σ ai|gi di|, ai = 1, |a|, 1
 *     F + 2hδ + Aδ² = 0, so δ = −F/(2h + Aδ), |Aδ| ≤ τ Am, Am = Σ ai di²; with −F/2h for the δ below, which is off by η'τ + |δF|/|2h|, η' = (|δ2h| + τ Am)/|2h|,
 *     and A·F/2h in doubles by 8u τ Am:  |δF'| ≤ 13u Σ ai|gi di| + τ Am (η' + 8u) + Am |δF|/|2h|. From far away that matters: τ is long there.
 *   flat, F = N·g, F' = N·d: a product 3 + 5, two sums; u and two sums:                             |δF| ≤ 14u² Σ|Ni gi|, |δF'| ≤ 3u Σ|Ni di|
 *
 * δ* F'* = −F* and δ F' = −F give (δ* − δ)F' = δ*(F' − F'*) − (F* − F): if F' is off by η of itself, −F/F' is off by Δ ≤ |δF|/|F'| + ητ, and 2u|δ| ≤ 4u²|t| for the
 * quotient and F's lower half. hitAt adds 8u²|t|: ROUNDED is both. Underflow: with g, r, √|a| and |N|₁ below WIDE what t·d lost, times 2g and a, is below SMALLEST in F; and in F' too, for t·d is
 * only below 2^-968 for |d| < 2^106. But d may be of any length, since A·(F/2h) is no larger than F' (A·F overflowed, and a slope of ∞ made δ and Δ 0) and is made
 * of dx·(F/2h·dx) … (A underflowed, and Aδ with it: both in tests/repro).
 */
const U = 2 ** -53;
const UU = 2 ** -106;
export const ERROR_CURVED = 24 * UU;
export const ERROR_SLOPE = 14 * U;
export const ERROR_FLAT = 16 * UU;
export const ERROR_RATE = 4 * U;
export const ROUNDED = 14 * UU;
export const WIDE = 2 ** 120;
export const SMALLEST = 2 ** -711;
/** What t·d and δ·d may lose of a coordinate below the doubles, */
export const LOST = 2 ** -1072;
/** and what a step that is below them itself, with its bound. */
export const TINY = 2 ** -1072;

/** g as three double-doubles, F, and what they are made from. */
export const R = new Float64Array(14);
export const F = 6;
const S = 8;
const V = 10;
const FLARE = 12;
const at = (k: number): number => R[k] as number;
const G = [0, 2, 4] as const;

/** What hitAt reads, in the ray's own units: the stage that found t may have had it in others. */
const algebra = createAlgebra();
export const STEP = createRoots();

/** Puts g, and E − C for hitAt. */
function putPlace({ origin, direction }: Ray, center: Vec3, t: number): void {
  for (let i = 0; i < 3; i++) {
    const e = origin[i] as number;
    const c = center[i] as number;
    const x = direction[i] as number;
    R[S] = e - c;
    R[S + 1] = sumError(e, -c, at(S));
    algebra[ALGEBRA_P + 2 * i] = at(S);
    algebra[ALGEBRA_P + 2 * i + 1] = at(S + 1);
    R[V] = t * x;
    R[V + 1] = productError(t, x, at(V));
    dd.add(R, G[i] as number, S, V);
  }
}

function putSquare(out: number, x: number): void {
  R[out] = x * x;
  R[out + 1] = squareError(x, at(out));
}

/**
 * δ and Δ from F with its error, F' and its error; no δ where F' is not known well enough, or has
 * overflowed (faithful.ts): η, δ and Δ would be 0, and E + t d would pass for the point. |F'| < ∞
 * also says that nothing on the way to it has overflowed: a sum or a product of ∞ is ∞ or NaN,
 * except that F/2h is 0 where 2h is ∞, and then F' is ∞ or NaN by 2h itself.
 */
export function putStep(
  k: number,
  t: number,
  offF: number,
  slope: number,
  offSlope: number,
): boolean {
  const steep = Math.abs(slope);
  const eta = (offSlope + SMALLEST) / steep;
  const delta = -at(F) / slope;
  STEP[k] = t;
  STEP[k + 1] = delta;
  STEP[k + 2] = (offF + SMALLEST) / steep + (2 * U * eta + ROUNDED) * Math.abs(t) + TINY;
  return eta <= 0.25 && steep < Number.POSITIVE_INFINITY;
}

/** (dx² + dz² − a·dy²)·s, each square begun with s: of a short d the squares alone would vanish while s is long. */
const times = (a: number, [x, y, z]: Vec3, s: number): number =>
  x * (s * x) + z * (s * z) - a * (y * (s * y));

/**
 * The hit at the faithful root t, or null where a component stays open, or all of the normal's are
 * zero.
 */
export function placeOnQuadric(q: Quadric, ray: Ray, k: 0 | 3, t: number): Hit | null {
  const { origin: E, direction: d } = ray;
  // A cylinder does not look at y: from E's own height nothing is subtracted.
  putPlace(ray, [q.Cx, q.hasY ? q.Cy : E[1], q.Cz], t);
  const [x, y, z] = [at(0), at(2), at(4)];
  if (q.squared) putSquare(FLARE, q.flare);
  else dd.set(R, FLARE, q.flare);
  const a = at(FLARE);
  algebra[ALGEBRA_FLARE] = a;
  algebra[ALGEBRA_FLARE + 1] = at(FLARE + 1);
  const size = Math.abs(a);
  dd.sqr(R, F, 0);
  dd.sqr(R, S, 4);
  dd.add(R, F, F, S);
  dd.sqr(R, S, 2);
  dd.mul(R, S, S, FLARE);
  dd.sub(R, F, F, S);
  putSquare(S, q.r);
  dd.sub(R, F, F, S);
  const offF = ERROR_CURVED * (x * x + z * z + size * y * y + q.r * q.r);
  const slope = 2 * (x * d[0] + z * d[2] - a * (y * d[1]));
  const offSlope =
    ERROR_SLOPE * (Math.abs(x * d[0]) + Math.abs(z * d[2]) + size * Math.abs(y * d[1]));
  const bend = times(-size, d, 2 * U * Math.abs(t) + TINY);
  const eta = (offSlope + bend + SMALLEST) / Math.abs(slope);
  const known =
    eta <= 0.25 &&
    putStep(
      k,
      t,
      offF,
      slope - times(a, d, at(F) / slope),
      offSlope + bend * (eta + 8 * U) + times(-size, d, offF / Math.abs(slope)),
    );
  const narrow = Math.max(Math.abs(x), Math.abs(y), Math.abs(z), q.r) < WIDE && size < WIDE * WIDE;
  return known && narrow ? hitAt(q, ray, algebra, STEP, k, t) : null;
}

/** As `placeOnQuadric`; the normal is N itself. */
export function placeInPlane({ N, P }: Planar, ray: Ray, t: number): Hit | null {
  const { origin: E, direction: d } = ray;
  putPlace(ray, P, t);
  let rate = 0;
  let steep = 0;
  let sharp = 0;
  let size = 0;
  dd.set(R, F, 0);
  for (let i = 0; i < 3; i++) {
    const n = N[i] as number;
    const x = d[i] as number;
    const g = G[i] as number;
    dd.mulDouble(R, S, g, n);
    dd.add(R, F, F, S);
    rate += n * x;
    steep += Math.abs(n * x);
    sharp += Math.abs(n * at(g));
    size = Math.max(size, Math.abs(n), Math.abs(at(g)));
  }
  if (!putStep(0, t, ERROR_FLAT * sharp, rate, ERROR_RATE * steep) || !(size < WIDE)) return null;
  const delta = STEP[1] as number;
  const off = STEP[2] as number;
  const point: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < 3; i++) {
    const e = E[i] as number;
    const x = d[i] as number;
    const m = t * x;
    const s = e + m;
    const p = s + (sumError(e, m, s) + productError(t, x, m) + delta * x);
    const offX = x === 0 ? 0 : off * Math.abs(x) + 16 * UU * Math.abs(s) + LOST;
    if (!(offX <= FAITHFUL * Math.abs(p))) return null;
    point[i] = p + 0;
  }
  return { t, point, normal: [N[0], N[1], N[2]], singular: false };
}
