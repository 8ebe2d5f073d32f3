import { NONE, TWO } from '../../batch/batch.ts';
import { type RootSlot, solveExactly } from '../../batch/exact-quadric.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { exponentOf, scale } from '../../float/bits.ts';
import { SPLITTER, squareError, sumError } from '../../float/eft.ts';
import { lazily } from '../../lazily.ts';
import type { Ray } from '../../ray.ts';
import type { Vec3 } from '../../vec3.ts';
import {
  type Algebra,
  AT_A,
  AT_A_LOW,
  AT_B,
  AT_B_LOW,
  AT_C,
  AT_C_LOW,
  AT_D,
  AT_D_LOW,
  AT_OFF_A,
  AT_OFF_B,
  AT_OFF_C,
  AT_OFF_D,
  AT_SIZE,
  createAlgebra,
  createRoots,
  FAR,
  lost,
  NEAR,
  putAlgebra,
  putShort,
  putSingle,
  ROOT_LOW,
  ROOT_OFF,
  type Roots,
  sharpenC,
  shortVerdict,
} from './algebra.ts';
import { type CertifiedSlot, FAITHFUL, UU } from './numbers.ts';

/*
 * Both roots from A, b, C and D/4 = b² − AC of two doubles each (algebra.ts), as sums of two
 * doubles. The errors, in u² = 2^-106, for any |δD| < D:
 *
 *   quantity         error                     reason
 *   s = √D/4         4.1u², and |δD|/s         hi − s² exact, 2u of D, and D's lower half 3u²; the
 *                                              quotient 1.5u²; what Newton's step leaves 1.1u²
 *   q = −(b ± s)     9u², and (δb + δD/s)/|q|  with b's sign: lower halves 1.5u and u, their sums
 *                                              4u²
 *   t = q/A, C/q     9u²                       the rest is 2u and two lower halves, 4u in all
 *                    12u²                      the quotient off by 2u, without the lower half
 *                    26u² in all               with the sums of hitAt, 5u²
 *
 * A number hi + lo whose error is below u/4 of it is faithful as hi: FAITHFUL. t = q/A is the
 * lesser root if A and q differ in sign. The doubles keep that order: with q² ≤ 2(b² + D) ≤ 6AmCm
 * the bound of δD/s says s > 2^55 · 136u² AmCm/|q| > 2^-47 |q|, and the roots are 2s/|A| apart, t =
 * |q/A|. None is so small that its lower half is lost: D > SMALLEST_ALGEBRA_D makes |q/A| > 2^-535;
 * |C| > 2^55 of its bound, 2^-47 Cm and 2^-817, so |C| > √(2^-864 Cm) and |C/q| > 2^-432
 * √Cm/(3√(AmCm)) > 2^-534; by sharpenC > 2^-131 Cm and 2^-815, which makes it > 2^-575.
 */

/** No verdict. */
export const UNKNOWN = -1;

/** Bounds of the table: of q in |q|, and of a quotient in |t|. */
export const ROUNDED_Q = 10 * UU;
export const QUOTIENT = 30 * UU;

/**
 * Where C's bound is a larger share of it, E is so near to the surface that C cancels beyond twice
 * the digits.
 */
const SHARP = FAITHFUL / 2;

/** What the functions below fill for a ray: in its own units, or in those of inUnits. */
export interface Work {
  readonly formed: Algebra;
  readonly solved: Roots;
}
/** A `Work` of zeros. */
export const createWork = (): Work => ({ formed: createAlgebra(), solved: createRoots() });
const ownWork = lazily(createWork);

/** Where nothing rounds: any verdict and its roots; UNKNOWN elsewhere. */
function shortRoots(q: Quadric, ray: Ray, slot: RootSlot, work: Work): number {
  const { formed } = work;
  if (!putShort(q, ray, formed)) return UNKNOWN;
  const verdict = shortVerdict(formed);
  putSingle(formed, verdict, slot);
  return verdict === TWO ? putBoth(slot, work) : verdict;
}

function putBoth(slot: RootSlot, { formed, solved }: Work): number {
  if (!putRoots(formed, solved)) return UNKNOWN;
  // No root is −0.
  slot.t0 = (solved[NEAR] as number) + 0;
  slot.t1 = (solved[FAR] as number) + 0;
  return TWO;
}

/**
 * The roots of a ray, and NONE or TWO; UNKNOWN, and no roots, where a bound is too wide. `work`
 * holds the algebra then, and with TWO the roots with their bounds.
 */
export function plainRoots(q: Quadric, ray: Ray, slot: RootSlot, work: Work): number {
  const { formed } = work;
  putAlgebra(q, ray, formed);
  const D1 = formed[AT_D] as number;
  const sure = (formed[AT_SIZE] as number) > 0 && Math.abs(D1) > (formed[AT_OFF_D] as number);
  if (!sure) return UNKNOWN;
  if (D1 < 0) return NONE;
  const near = !((formed[AT_OFF_C] as number) <= SHARP * Math.abs(formed[AT_C] as number));
  if (near) sharpenC(formed, q.r);
  return putBoth(slot, work);
}

/** Not where a root has vanished below the doubles, and its bound with it. */
const isFaithful = (solved: Roots, k: number): boolean =>
  (solved[k + ROOT_OFF] as number) < FAITHFUL * Math.abs(solved[k] as number);

/**
 * Puts both roots of `algebra`, whose AT_SIZE says that its numbers are finite; false where one of
 * them is not known to be faithful.
 */
export function putRoots(formed: Algebra, solved: Roots): boolean {
  const D1 = formed[AT_D] as number;
  const s = Math.sqrt(D1);
  const ss = s * s;
  const sl = (D1 - ss - squareError(s, ss) + (formed[AT_D_LOW] as number)) / (2 * s);
  const b = formed[AT_B] as number;
  const turn = b < 0 ? 1 : -1;
  // q = −(b ± √D) with b's sign.
  const q0 = -b + turn * s;
  const q1 = sumError(-b, turn * s, q0) + (turn * sl - (formed[AT_B_LOW] as number));
  const qh = q0 + q1;
  const ql = q1 - (qh - q0);
  const offQ =
    ((formed[AT_OFF_B] as number) + (formed[AT_OFF_D] as number) / s) / Math.abs(qh) + ROUNDED_Q;
  const A1 = formed[AT_A] as number;
  const ordered = A1 > 0 === qh < 0;
  const lower = ordered ? NEAR : FAR;
  const upper = ordered ? FAR : NEAR;
  quotient(
    solved,
    lower,
    qh,
    ql,
    A1,
    formed[AT_A_LOW] as number,
    offQ + (formed[AT_OFF_A] as number) / Math.abs(A1) + QUOTIENT,
  );
  const C1 = formed[AT_C] as number;
  const zero = (formed[AT_OFF_C] as number) === 0;
  const offC = zero ? 0 : (formed[AT_OFF_C] as number) / Math.abs(C1);
  quotient(solved, upper, C1, formed[AT_C_LOW] as number, qh, ql, offQ + offC + QUOTIENT);
  return isFaithful(solved, lower) && (zero || isFaithful(solved, upper));
}

function quotient(
  solved: Roots,
  k: number,
  n: number,
  nl: number,
  m: number,
  ml: number,
  off: number,
): void {
  const inverse = 1 / m;
  const t = n * inverse;
  const p = t * m;
  let big = SPLITTER * t;
  const th = big - (big - t);
  big = SPLITTER * m;
  const mh = big - (big - m);
  const rest = n - p - lost(th, t - th, mh, m - mh, p) + (nl - t * ml);
  const lo = rest * inverse;
  const hi = t + lo;
  solved[k] = hi;
  solved[k + ROOT_LOW] = lo - (hi - t);
  solved[k + ROOT_OFF] = off * Math.abs(hi);
}

/** max |d| and the largest length between 2^-40 and 2^40: a scale would change nothing. */
export const ORDINARY = 2 ** 40;
const ordinary = (x: number): boolean => x < ORDINARY && x > 1 / ORDINARY;

/**
 * One ray that the filters left open; returns its verdict and fills the slot: twice the digits, the
 * same in other units, whole numbers.
 */
export function solveSlowly(q: Quadric, ray: Ray, slot: CertifiedSlot): number {
  const work = ownWork();
  const { formed } = work;
  let verdict = shortRoots(q, ray, slot, work);
  slot.exact = verdict !== UNKNOWN && (formed[AT_A] === 0 || formed[AT_D] === 0);
  if (verdict !== UNKNOWN) return verdict;
  verdict = plainRoots(q, ray, slot, work);
  if (verdict === UNKNOWN) verdict = inUnits(q, ray, slot);
  if (verdict !== UNKNOWN) return verdict;
  slot.exact = true;
  const { origin: E, direction: d } = ray;
  return solveExactly(q, E[0], E[1], E[2], d[0], d[1], d[2], slot);
}

const longest = (v: Vec3, hasY: boolean): number =>
  Math.max(Math.abs(v[0]), hasY ? Math.abs(v[1]) : 0, Math.abs(v[2]));

/**
 * In powers of two as units, by which d and the lengths are about 1. UNKNOWN where a number would
 * lose bits by that: E could seem to be on the surface then.
 */
function inUnits(q: Quadric, { origin: E, direction: d }: Ray, slot: RootSlot): number {
  const { hasY } = q;
  const speed = longest(d, hasY);
  const length = Math.max(longest(E, hasY), longest([q.Cx, q.Cy, q.Cz], hasY), q.r);
  if (speed === 0 || length === 0 || (ordinary(speed) && ordinary(length))) return UNKNOWN;
  const k = exponentOf(speed);
  const l = exponentOf(length);
  let lossless = true;
  const inUnit = (x: number, unit: number): number => {
    const y = scale(x, -unit);
    if (scale(y, unit) !== x) lossless = false;
    return y;
  };
  const shape: Quadric = {
    ...q,
    Cx: inUnit(q.Cx, l),
    Cy: hasY ? inUnit(q.Cy, l) : 0,
    Cz: inUnit(q.Cz, l),
    r: inUnit(q.r, l),
  };
  const origin: Vec3 = [inUnit(E[0], l), hasY ? inUnit(E[1], l) : 0, inUnit(E[2], l)];
  const direction: Vec3 = [inUnit(d[0], k), hasY ? inUnit(d[1], k) : 0, inUnit(d[2], k)];
  if (!lossless) return UNKNOWN;
  const verdict = plainRoots(shape, { origin, direction }, slot, ownWork());
  if (verdict === TWO) {
    // Rounding twice, to 53 bits and then into the subnormals, stays faithful: a neighbour in the
    // coarser grid is one in the finer.
    slot.t0 = scale(slot.t0, l - k);
    slot.t1 = scale(slot.t1, l - k);
  }
  return verdict;
}
