import { CONTAINED, NONE, ONE, TANGENT, TWO } from '../../batch/batch.ts';
import type { RootSlot } from '../../batch/exact-quadric.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { productError, squareError, sumError } from '../../float/eft.ts';
import type { Ray } from '../../ray.ts';
import { type Algebra, AT_A, AT_B, AT_C, AT_D, AT_FLARE, AT_P, AT_SIZE } from './doubled.ts';

/*
 * Numbers that people type: whole multiples of 2^-8, none above 2^8, so 16 bits of units and a
 * sign; a = c² likewise. Nothing rounds then:
 *
 *   p = E − C         17 bits of 2^-8
 *   A, b, C           terms of ≤ 2^(16 + 2·17) units of 2^-24, four of them at most: ≤ 2^52
 *   b², AC            ≤ 2^104 of 2^-48, each a double and an error ≤ 2^51, which is whole
 *   D/4 = b² − AC     the difference, and what it and the products lost: ≤ 3·2^51, whole, exact
 *
 * So zeros, tangents and ties are decided here, and not by whole numbers of any length.
 */
export const ON_GRID = 1.5 * 2 ** 44;
const LONGEST = 2 ** 8;

const isShort = (x: number): boolean =>
  x + ON_GRID - ON_GRID === x && x <= LONGEST && x >= -LONGEST;

/**
 * Puts A, b, C and D/4 of a ray into `algebra`, with no error; false where a number is not short.
 */
export function putShort(q: Quadric, { origin: E, direction: d }: Ray, algebra: Algebra): boolean {
  const x = d[0];
  const z = d[2];
  if (!(isShort(x) && isShort(z) && isShort(E[0]) && isShort(E[2]))) return false;
  if (!(isShort(E[1]) && isShort(d[1]) && isShort(q.Cx) && isShort(q.Cz))) return false;
  if (!(isShort(q.r) && isShort(q.flare))) return false;
  const a = q.squared ? q.flare * q.flare : q.flare;
  if (!isShort(a) || !(q.hasY ? isShort(q.Cy) : true)) return false;
  const y = q.hasY ? d[1] : 0;
  const px = E[0] - q.Cx;
  const py = q.hasY ? E[1] - q.Cy : 0;
  const pz = E[2] - q.Cz;
  const A0 = x * x + z * z - a * (y * y) + 0;
  const b = x * px + z * pz - a * (y * py) + 0;
  const C0 = px * px + pz * pz - a * (py * py) - q.r * q.r + 0;
  const bb = b * b;
  const AC = A0 * C0;
  const D0 = bb - AC;
  const D1 = sumError(bb, -AC, D0) + (squareError(b, bb) - productError(A0, C0, AC));
  const Dh = D0 + D1 + 0;
  algebra.fill(0);
  algebra[AT_A] = A0;
  algebra[AT_B] = b;
  algebra[AT_C] = C0;
  algebra[AT_D] = Dh;
  algebra[AT_D + 1] = sumError(D0, D1, Dh);
  algebra[AT_P] = px;
  algebra[AT_P + 2] = py;
  algebra[AT_P + 4] = pz;
  algebra[AT_FLARE] = a;
  const size = Math.abs(a);
  algebra[AT_SIZE] =
    (x * x + z * z + size * y * y) * (px * px + pz * pz + size * py * py + q.r * q.r);
  return true;
}

/** The verdict that the signs in `algebra` tell. */
export function shortVerdict(algebra: Algebra): number {
  const D1 = algebra[AT_D] as number;
  if (algebra[AT_A] === 0) {
    if (algebra[AT_B] !== 0) return ONE;
    return algebra[AT_C] === 0 ? CONTAINED : NONE;
  }
  if (D1 === 0) return TANGENT;
  return D1 < 0 ? NONE : TWO;
}

/** The single root is n/m exactly, rounded once. */
export const topOf = (algebra: Algebra, verdict: number): number =>
  verdict === ONE ? -(algebra[AT_C] as number) : -(algebra[AT_B] as number);
export const bottomOf = (algebra: Algebra, verdict: number): number =>
  verdict === ONE ? 2 * (algebra[AT_B] as number) : (algebra[AT_A] as number);

/** Puts the only root, or none; `TWO` is left to plain-roots.ts. */
export function putSingle(algebra: Algebra, verdict: number, slot: RootSlot): void {
  const has = verdict === ONE || verdict === TANGENT;
  slot.t0 = has ? topOf(algebra, verdict) / bottomOf(algebra, verdict) + 0 : Number.NaN;
  slot.t1 = Number.NaN;
}

/** D/4's root if that is a double, which makes both roots quotients of whole numbers; else NaN. */
export function wholeRoot(algebra: Algebra): number {
  const s = Math.sqrt(algebra[AT_D] as number);
  const ss = s * s;
  const exact = ss === algebra[AT_D] && squareError(s, ss) === algebra[AT_D + 1];
  return exact ? s : Number.NaN;
}
