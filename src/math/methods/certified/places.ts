import type { Planar } from '../../batch/planar.ts';
import type { Quadric } from '../../batch/quadric.ts';
import * as dd from '../../float/double-double.ts';
import { productError, squareError, sumError } from '../../float/eft.ts';
import type { Hit } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import type { Vec3 } from '../../vec3.ts';
import { FAITHFUL } from './faithful.ts';
import { hitAt, ROOTS } from './hit-quadric.ts';
import { BOX } from './scaled-quadric.ts';

/*
 * Points and normals where a faithful root t is known and the exact one, t*, is wanted: δ = t* − t is one Newton step on a residual in double-double
 * (float/double-double.ts has the bounds: a sum 3u², a product 5u²). u = 2^-53; |δ| ≤ τ = 2u|t| + 2^-1074; i runs over x, y, z.
 *
 *   g = E − C + t d, a sum of two double-doubles that are exact:                                    |δgi| ≤ 3u²|gi|
 *   curved, F = gx² + gz² − a gy² − ρ: a square 5 + 6, times a 5 more, three sums:                  |δF| ≤ 26u² (gx² + gz² + |a|gy² + ρ)
 *     h = F'/2 = gx dx + gz dz − a gy dy in doubles:                                                |δh| ≤ 6u Σ ai|gi di|, ai = 1, |a|, 1
 *     F + 2hδ + Aδ² = 0, so δ = −F/(2h + Aδ), |Aδ| ≤ τ Am, Am = Σ ai di²; with −F/2h for the δ below, which is off by η' = (|2δh| + τ Am)/|2h| twice and
 *     by δF, and A off by 8u Am:  |δF'| ≤ 12u Σ ai|gi di| + τ Am (2η' + 8u) + 4Am |δF|/|2h|. From far away that matters: τ is long there.
 *   flat, F = N·g, h = N·d: |δF| ≤ 15u² Σ|Ni gi|, |δh| ≤ 4u Σ|Ni di|, δ = −F/h
 *
 * If F' is off by η ≤ 1/4 of itself, −F/F' is off by Δ ≤ 2|δF|/|F'| + 2ητ + 5u|δ|. Underflow: what is lost in F and F' is below SMALLEST as long as g, r, √|a| and
 * |N|₁ are below WIDE.
 */
const U = 2 ** -53;
const UU = 2 ** -106;
const WIDE = 2 ** 120;
const SMALLEST = 2 ** -600;
const LOST = 2 ** -1070;
const TINY = 2 ** -1072;

/** g as three double-doubles, F, and what they are made from. */
const R = new Float64Array(14);
const F = 6;
const S = 8;
const V = 10;
const FLARE = 12;
const at = (k: number): number => R[k] as number;
const G = [0, 2, 4] as const;

function putPlace({ origin, direction }: Ray, center: Vec3, t: number): void {
  for (let i = 0; i < 3; i++) {
    const e = origin[i] as number;
    const c = center[i] as number;
    const x = direction[i] as number;
    R[S] = e - c;
    R[S + 1] = sumError(e, -c, at(S));
    R[V] = t * x;
    R[V + 1] = productError(t, x, at(V));
    dd.add(R, G[i] as number, S, V);
  }
}

function putSquare(out: number, x: number): void {
  R[out] = x * x;
  R[out + 1] = squareError(x, at(out));
}

/** δ and Δ from F with its error, F' and its error; no δ where F' is not known well enough. */
function putStep(k: number, t: number, offF: number, slope: number, offSlope: number): boolean {
  const steep = Math.abs(slope);
  const eta = (offSlope + SMALLEST) / steep;
  const delta = -at(F) / slope;
  ROOTS[k] = t;
  ROOTS[k + 1] = delta;
  ROOTS[k + 2] =
    (2 * (offF + SMALLEST)) / steep +
    U * (4 * eta * Math.abs(t) + 5 * Math.abs(delta)) +
    16 * UU * Math.abs(t) +
    TINY;
  return eta <= 0.25;
}

/** The hit at the faithful root t, or null where a component stays open, or all of the normal's are zero. Asked right after plainQuadric, whose ALGEBRA it reads. */
export function placeOnQuadric(q: Quadric, ray: Ray, k: 0 | 3, t: number): Hit | null {
  const { origin: E, direction: d } = ray;
  // A cylinder does not look at y: from E's own height nothing is subtracted.
  putPlace(ray, [q.Cx, q.hasY ? q.Cy : E[1], q.Cz], t);
  const [x, y, z] = [at(0), at(2), at(4)];
  if (q.squared) putSquare(FLARE, q.flare);
  else dd.set(R, FLARE, q.flare);
  const a = at(FLARE);
  const size = Math.abs(a);
  dd.sqr(R, F, 0);
  dd.sqr(R, S, 4);
  dd.add(R, F, F, S);
  dd.sqr(R, S, 2);
  dd.mul(R, S, S, FLARE);
  dd.sub(R, F, F, S);
  putSquare(S, q.r);
  dd.sub(R, F, F, S);
  const Am = d[0] * d[0] + d[2] * d[2] + size * d[1] * d[1];
  const A = d[0] * d[0] + d[2] * d[2] - a * d[1] * d[1];
  const offF = 32 * UU * (x * x + z * z + size * y * y + q.r * q.r);
  const slope = 2 * (x * d[0] + z * d[2] - a * (y * d[1]));
  const offSlope = 12 * U * (Math.abs(x * d[0]) + Math.abs(z * d[2]) + size * Math.abs(y * d[1]));
  const bend = Am * (2 * U * Math.abs(t) + TINY);
  const eta = (offSlope + bend + SMALLEST) / Math.abs(slope);
  const known =
    eta <= 0.25 &&
    putStep(
      k,
      t,
      offF,
      slope - (A * at(F)) / slope,
      offSlope + bend * (2 * eta + 8 * U) + (4 * Am * offF) / Math.abs(slope),
    );
  const narrow = Math.max(Math.abs(x), Math.abs(y), Math.abs(z), q.r) < WIDE && size < WIDE * WIDE;
  const long = Math.max(Math.abs(d[0]), Math.abs(d[1]), Math.abs(d[2]));
  // Of directions beyond the box points were off (tests/repro): the bounds are not proven there, and whole numbers answer.
  return known && narrow && long < BOX ? hitAt(q, ray, k, t) : null;
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
  if (!putStep(0, t, 16 * UU * sharp, rate, 4 * U * steep) || !(size < WIDE)) return null;
  const delta = ROOTS[1] as number;
  const off = ROOTS[2] as number;
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
