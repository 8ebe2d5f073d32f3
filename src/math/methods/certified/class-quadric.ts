import type { Answers, Rays } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { DIRECT_ERROR, LEAST_A, momentError } from './moment-bound.ts';
import type { OpenRays } from './roots-quadric.ts';
import { BOX, type CertifiedQuadric } from './scaled-quadric.ts';

/*
 * "Is it hit?" by D/4 = b² − AC with half-b, and a bound on its error. u = 2^-53; p = fl(E − C) is off by u, a = fl(c²) by u.
 *
 *   A = dx² + dz² − a dy²       squares u, a·dy² 3u, two sums:           |δA| ≤ 4u Am
 *   C = px² + pz² − a py² − ρ   px² 3u, a·py² 5u, ρ u, sums (2 more):    |δC| ≤ 7u Cm
 *   b = dx px + dz pz − a dy py products 2u, the last 4u, two sums:      |δb| ≤ 5u bm, bm ≤ √(Am Cm) by Cauchy–Schwarz
 *   b²: 2·5u + u;  AC: 4u + 7u + u;  their difference u:                 |δ(D/4)| ≤ 24u Am Cm
 *
 * with Am = dx² + dz² + |a|dy², Cm = px² + pz² + |a|py² + ρ. DIRECT_ERROR has room for the terms in u² and for Am and Cm being
 * rounded themselves (at most 10u together). SMALLEST covers underflow: with k in the box and Am, Cm < LARGEST a lost product (2^-1074) is multiplied by a < 2^200 and
 * LARGEST at most, which is less than 2^-470; and where D is above SMALLEST, Am is above SMALLEST / 2 LARGEST = 2^-823, so that what A lost, 2^-874, is within
 * the 4u that its own DIRECT_ERROR is too large by (and more).
 */
export const SMALLEST = 2 ** -422;
/** Am and Cm below this: squares of the box's numbers, six of them and a. */
export const LARGEST = BOX ** 4;

/** Writes D/4 where its sign is certain, and leaves the other rays open. */
export function openClasses(
  q: Quadric,
  c: CertifiedQuadric,
  rays: Rays,
  out: Answers,
  left: OpenRays,
): void {
  left.count = 0;
  if (q.hasY) classesInSpace(q, c, rays, out, left);
  else classesAroundAxis(q, c, rays, out, left);
  classesByMoment(q, c, rays, out, left);
}

/**
 * What the direct form leaves open, with the sharper bound of the moment form: far away D/4 is a small difference of b² and AC,
 * but not of ρA and m². Formula and bound are those of pass 1 in roots-quadric.ts.
 */
function classesByMoment(
  { Cx, Cy, Cz, hasY }: Quadric,
  { k, sign, rho }: CertifiedQuadric,
  { Ex, Ey, Ez, dx, dy, dz }: Rays,
  { margin }: Answers,
  left: OpenRays,
): void {
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

function classesInSpace(
  { Cx, Cy, Cz }: Quadric,
  { flare, rho }: CertifiedQuadric,
  { count, Ex, Ey, Ez, dx, dy, dz }: Rays,
  { margin }: Answers,
  left: OpenRays,
): void {
  const { open } = left;
  const size = Math.abs(flare);
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
    const yy = y * y;
    const pp = py * py;
    const A = round - flare * yy;
    const C = wide - flare * pp - rho;
    const b = x * px + z * pz - flare * (y * py);
    const D = b * b - A * C;
    const Am = round + size * yy;
    const Cm = wide + size * pp + rho;
    margin[i] = D;
    // A = 0 needs |A| above its own error, or a root may have gone to infinity: 'one' is not 'two'.
    if (
      !(Math.abs(D) > DIRECT_ERROR * (Am * Cm) + SMALLEST) ||
      !(Math.abs(A) > DIRECT_ERROR * Am) ||
      !(Am < LARGEST && Cm < LARGEST)
    ) {
      open[opened++] = i;
    }
  }
  left.count = opened;
}

function classesAroundAxis(
  { Cx, Cz }: Quadric,
  { rho }: CertifiedQuadric,
  { count, Ex, Ez, dx, dz }: Rays,
  { margin }: Answers,
  left: OpenRays,
): void {
  const { open } = left;
  let opened = 0;
  for (let i = 0; i < count; i++) {
    const x = dx[i] as number;
    const z = dz[i] as number;
    const px = (Ex[i] as number) - Cx;
    const pz = (Ez[i] as number) - Cz;
    const A = x * x + z * z;
    const Cm = px * px + pz * pz;
    const b = x * px + z * pz;
    const D = b * b - A * (Cm - rho);
    margin[i] = D;
    if (
      !(Math.abs(D) > DIRECT_ERROR * (A * (Cm + rho)) + SMALLEST) ||
      !(A < LARGEST && Cm < LARGEST)
    ) {
      open[opened++] = i;
    }
  }
  left.count = opened;
}
