import type { Answers, Rays } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { AT_SCALED, BOX, type CertifiedQuadric, type OpenRays } from './numbers.ts';

/*
 * D/4 by the moment. u = 2^-53. Coordinates along y are multiplied by k = √|a|: Y = k·dy, PY =
 * k·(Ey − Cy), so all three are alike. Si = |dj pk| + |dk pj|, S = |d|₁|p|₁ ≥ ΣSi, M = Σ|mi|, and
 * mi² ≤ |mi| Si, all as they are computed.
 *
 *   quantity                      bound                   reason
 *   p = fl(E − C)                 u of it                 one difference
 *   k, Y, PY                      u, 2u, 3u of them       √ is rounded once, then products
 *   m = d × p                     4u Si + u|mi|           products 4u, their difference u
 *   mi²                           8u|mi|Si + 3u mi²       2|mi||δmi| + |δmi|² + u mi²
 *                                 + 16u²Si² + 9u²|mi|Si
 *   ρA                            8u ρAm                  A: dx² 3u, Y² (4 + 2)u; ρ u, product u
 *   D/4 = ρA ± (mx² + mz²) − my²  Σ(8u + 9u²)|mi|Si       three more sums, each of which adds u of
 *                                 + 6uΣmi² + 10u ρAm      what it adds
 *                                 + 16u²ΣSi²
 *                                 ≤ u(14.1 MS + 10 ρAm    Σ|mi|Si ≤ MS, Σmi² ≤ MS; ΣSi² ≤ Σmi² +
 *                                 + 4u S²)                S²/4 (below)
 *
 * Si² ≤ mi² + 4 wj wk for wj = |dj pj|, and Σj<k wj wk ≤ (Σ√wj)⁴/16 ≤ S²/16 (most for two of them
 * alike and no third). MOMENT_ERROR, SQUARE_ERROR and RHO_ERROR are these constants with room for
 * terms in u² and for evaluating the bound in doubles (a relative 20u). Unlike 13u·S² it stays
 * sharp however far away E is, where M ≪ S.
 *
 * Underflow: inside the box (|d|₁ from 2^-100 to 2^100, |p|₁ and r and k up to 2^100) a lost
 * product is ≤ 2^-1074, and at most 2^600 multiplies it; SMALLEST_D is far above.
 */
/** Bounds of the table: in MS, S² and ρAm, and an absolute one for underflow. */
export const MOMENT_ERROR = 16 * 2 ** -53;
export const SQUARE_ERROR = 5 * 2 ** -106;
export const RHO_ERROR = 12 * 2 ** -53;
export const SMALLEST_D = 2 ** -200;

/**
 * Below |A| = LEAST_A·Am nothing is said about A: above, A ≠ 0, and it is known to 6u·2^20 < 2^-30.
 */
export const LEAST_A = 2 ** -20;

/** The bound on |δ(D/4)| that is derived above. */
export const momentError = (S: number, M: number, rhoAm: number): number =>
  S * (MOMENT_ERROR * M + SQUARE_ERROR * S) + RHO_ERROR * rhoAm + SMALLEST_D;

/** The bound of the direct form, b² − AC, in units of Am·Cm; derived below. */
export const DIRECT_ERROR = 27 * 2 ** -53;

/*
 * "Is it hit?" by D/4 = b² − AC with half-b, and a bound on its error. u = 2^-53; p = fl(E − C) is
 * off by u, a = fl(c²) by u.
 *
 *   quantity                         bound                 reason
 *   A = dx² + dz² − a dy²            |δA| ≤ 4u Am          squares u, a·dy² 3u, two sums
 *   C = px² + pz² − a py² − ρ        |δC| ≤ 7u Cm          px² 3u, a·py² 5u, ρ u, sums (2 more)
 *   b = dx px + dz pz − a dy py      |δb| ≤ 5u bm          products 2u, the last 4u, two sums;
 *                                                          bm ≤ √(Am Cm) by Cauchy–Schwarz
 *   D/4 = b² − AC                    |δ(D/4)| ≤ 24u Am Cm  b² 2·5u + u, AC 4u + 7u + u,
 *                                                          their difference u
 *
 * with Am = dx² + dz² + |a|dy², Cm = px² + pz² + |a|py² + ρ. DIRECT_ERROR has room for the terms in
 * u² and for Am and Cm being rounded themselves (at most 10u together). SMALLEST_DIRECT covers
 * underflow: with k in the box and Am, Cm < LARGEST a lost product (2^-1074) is multiplied by a <
 * 2^200 and LARGEST at most, which is less than 2^-470; and where D is above SMALLEST_DIRECT, Am is
 * above SMALLEST_DIRECT / 2 LARGEST = 2^-823, so that what A lost, 2^-874, is within the 4u that
 * its own DIRECT_ERROR is too large by (and more).
 */
/** Absolute bound of the direct form, for underflow. */
export const SMALLEST_DIRECT = 2 ** -422;
/** Am + Cm below this: squares of the box's numbers, six of them and a. */
export const LARGEST = BOX ** 4;

/** What the loops of the direct form take before they begin. */
export const AT_CLASS = {
  direct: 0,
  smallest: 1,
  largest: 2,
} as const;
/** In the order of AT_CLASS. */
export const CLASS_BOUNDS: readonly number[] = [DIRECT_ERROR, SMALLEST_DIRECT, LARGEST];

/** Writes D/4, puts the rays whose sign of it is not certain into `open`: how many they are. */
export type ClassPass = (
  numbers: Float64Array,
  rays: Rays,
  out: Answers,
  open: Int32Array,
) => number;

/** For shapes with a term in y. */
export const classesInSpace: ClassPass = (
  numbers,
  { count, Ex, Ey, Ez, dx, dy, dz },
  { margin },
  open,
) => {
  const Cx = numbers[AT_SCALED.Cx] as number;
  const Cy = numbers[AT_SCALED.Cy] as number;
  const Cz = numbers[AT_SCALED.Cz] as number;
  const flare = numbers[AT_SCALED.flare] as number;
  const rho = numbers[AT_SCALED.rho] as number;
  const direct = CLASS_BOUNDS[AT_CLASS.direct] as number;
  const smallest = CLASS_BOUNDS[AT_CLASS.smallest] as number;
  const largest = CLASS_BOUNDS[AT_CLASS.largest] as number;
  let opened = 0;
  for (let i = 0; i < count; i++) {
    const x = dx[i] as number;
    const y = dy[i] as number;
    const z = dz[i] as number;
    const px = (Ex[i] as number) - Cx;
    const py = (Ey[i] as number) - Cy;
    const pz = (Ez[i] as number) - Cz;
    const round = x * x + z * z;
    const wide = px * px + pz * pz;
    const ayy = flare * (y * y);
    const app = flare * (py * py);
    const A = round - ayy;
    const b = x * px + z * pz - flare * (y * py);
    const D = b * b - A * (wide - app - rho);
    const Am = round + Math.abs(ayy);
    const Cm = wide + Math.abs(app) + rho;
    margin[i] = D;
    // A = 0 needs |A| above its own error, or a root may have gone to infinity: 'one' is not 'two'.
    const clear =
      Math.abs(D) > direct * (Am * Cm) + smallest && Math.abs(A) > direct * Am && Am + Cm < largest;
    if (!clear) open[opened++] = i;
  }
  return opened;
};

/** For cylinders, whose formula does not look at y. */
export const classesAroundAxis: ClassPass = (
  numbers,
  { count, Ex, Ez, dx, dz },
  { margin },
  open,
) => {
  const Cx = numbers[AT_SCALED.Cx] as number;
  const Cz = numbers[AT_SCALED.Cz] as number;
  const rho = numbers[AT_SCALED.rho] as number;
  const direct = CLASS_BOUNDS[AT_CLASS.direct] as number;
  const smallest = CLASS_BOUNDS[AT_CLASS.smallest] as number;
  const largest = CLASS_BOUNDS[AT_CLASS.largest] as number;
  let opened = 0;
  for (let i = 0; i < count; i++) {
    const x = dx[i] as number;
    const z = dz[i] as number;
    const px = (Ex[i] as number) - Cx;
    const pz = (Ez[i] as number) - Cz;
    const A = x * x + z * z;
    const wide = px * px + pz * pz;
    const b = x * px + z * pz;
    const D = b * b - A * (wide - rho);
    const Cm = wide + rho;
    margin[i] = D;
    const clear = Math.abs(D) > direct * (A * Cm) + smallest && A + Cm < largest;
    if (!clear) open[opened++] = i;
  }
  return opened;
};

/**
 * What the direct form leaves open, with the sharper bound of the moment form: far away D/4 is a
 * small difference of b² and AC, but not of ρA and m². Formula and bound are those of refined.ts.
 */
export function classesByMoment(
  { Cx, Cy, Cz, hasY }: Quadric,
  { numbers }: CertifiedQuadric,
  { Ex, Ey, Ez, dx, dy, dz }: Rays,
  { margin }: Answers,
  left: OpenRays,
): void {
  const k = numbers[AT_SCALED.k] as number;
  const sign = numbers[AT_SCALED.sign] as number;
  const rho = numbers[AT_SCALED.rho] as number;
  const { open, count } = left;
  let opened = 0;
  for (let j = 0; j < count; j++) {
    const i = open[j] as number;
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
    const Am = round + y * y;
    const A = round - sign * (y * y);
    const D = rho * A + sign * (mx * mx + mz * mz) - my * my;
    const Sd = Math.abs(x) + Math.abs(y) + Math.abs(z);
    const Sp = Math.abs(px) + Math.abs(py) + Math.abs(pz);
    const error = momentError(Sd * Sp, Math.abs(mx) + Math.abs(my) + Math.abs(mz), rho * Am);
    margin[i] = D;
    if (
      !(Math.abs(D) > error) ||
      !(Math.abs(A) > LEAST_A * Am) ||
      !(Sd < BOX && Sd > 1 / BOX && Sp < BOX)
    ) {
      open[opened++] = i;
    }
  }
  left.count = opened;
}
