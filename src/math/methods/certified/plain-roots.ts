import { NONE, TWO } from '../../batch/batch.ts';
import type { RootSlot } from '../../batch/exact-quadric.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { SPLITTER, squareError, sumError } from '../../float/eft.ts';
import type { Ray } from '../../ray.ts';
import { A, type Algebra, B, C, createAlgebra, D, lost, OFF, putAlgebra, SIZE } from './algebra.ts';
import { FAITHFUL } from './faithful.ts';
import { createRoots, type Roots } from './hit-quadric.ts';
import { sharpenC } from './near-surface.ts';

/*
 * Both roots from A, b, C and D/4 = b² − AC of two doubles each (algebra.ts), as sums of two doubles. The errors, in u² = 2^-106, for any |δD| < D:
 *
 *   s = √D/4     hi − s² exact, 2u of D, and D's lower half: 3u²; the quotient 1.5u², what Newton's step leaves 1.1u²: 4.1u²; D's own error: |δD|/s
 *   q = −(b ± s) with b's sign: lower halves 1.5u and u, their sums 4u², and what b and s are off.         together (δb + δD/s)/|q| + 9u²
 *   t = q/A, C/q  the rest is 2u and two lower halves, 4u in all: 9u²; by a quotient that is off by 2u, and without the lower half: 12u²
 *                hitAt's sums add 5u²:                                                                    26u²
 *
 * A number hi + lo whose error is below u/4 of it is faithful as hi: FAITHFUL. t = q/A is the lesser root if A and q differ in sign. The doubles keep that order: with
 * q² ≤ 2(b² + D) ≤ 6AmCm the bound of δD/s says s > 2^55 · 136u² AmCm/|q| > 2^-47 |q|, and the roots are 2s/|A| apart, t = |q/A|.
 * None is so small that its lower half is lost: D > SMALLEST_D makes |q/A| > 2^-535; |C| > 2^55 of its bound, 2^-47 Cm and 2^-817, so |C| > √(2^-864 Cm) and
 * |C/q| > 2^-432 √Cm/(3√(AmCm)) > 2^-534; by near-surface.ts > 2^-131 Cm and 2^-815, which makes it > 2^-575.
 */

/** No verdict. */
export const UNKNOWN = -1;

const UU = 2 ** -106;
export const ROUNDED_Q = 10 * UU;
export const QUOTIENT = 30 * UU;

/** Where C's bound is a larger share of it, E is so near to the surface that C cancels beyond twice the digits. */
const SHARP = FAITHFUL / 2;

const algebra = createAlgebra();
const roots = createRoots();

/** The roots of a ray, and NONE or TWO; UNKNOWN, and no roots, where a bound is too wide. */
export function plainRoots(q: Quadric, ray: Ray, slot: RootSlot): number {
  putAlgebra(q, ray, algebra);
  const D1 = algebra[D] as number;
  const sure = (algebra[SIZE] as number) > 0 && Math.abs(D1) > (algebra[OFF + 3] as number);
  if (!sure) return UNKNOWN;
  if (D1 < 0) return NONE;
  const near = !((algebra[OFF + 2] as number) <= SHARP * Math.abs(algebra[C] as number));
  if (near) sharpenC(algebra, q.r);
  if (!putRoots(algebra, roots)) return UNKNOWN;
  // No root is −0.
  slot.t0 = (roots[0] as number) + 0;
  slot.t1 = (roots[3] as number) + 0;
  return TWO;
}

/** Not where a root has vanished below the doubles, and its bound with it. */
const isFaithful = (roots: Roots, k: number): boolean =>
  (roots[k + 2] as number) < FAITHFUL * Math.abs(roots[k] as number);

/**
 * Puts both roots of `algebra`, whose SIZE says that its numbers are finite; false where one of
 * them is not known to be faithful.
 */
export function putRoots(algebra: Algebra, roots: Roots): boolean {
  const D1 = algebra[D] as number;
  const s = Math.sqrt(D1);
  const ss = s * s;
  const sl = (D1 - ss - squareError(s, ss) + (algebra[D + 1] as number)) / (2 * s);
  const b = algebra[B] as number;
  const turn = b < 0 ? 1 : -1;
  // q = −(b ± √D) with b's sign.
  const q0 = -b + turn * s;
  const q1 = sumError(-b, turn * s, q0) + (turn * sl - (algebra[B + 1] as number));
  const qh = q0 + q1;
  const ql = q1 - (qh - q0);
  const offQ =
    ((algebra[OFF + 1] as number) + (algebra[OFF + 3] as number) / s) / Math.abs(qh) + ROUNDED_Q;
  const A1 = algebra[A] as number;
  const lower = A1 > 0 === qh < 0 ? 0 : 3;
  quotient(
    roots,
    lower,
    qh,
    ql,
    A1,
    algebra[A + 1] as number,
    offQ + (algebra[OFF] as number) / Math.abs(A1) + QUOTIENT,
  );
  const C1 = algebra[C] as number;
  const zero = (algebra[OFF + 2] as number) === 0;
  const offC = zero ? 0 : (algebra[OFF + 2] as number) / Math.abs(C1);
  quotient(roots, 3 - lower, C1, algebra[C + 1] as number, qh, ql, offQ + offC + QUOTIENT);
  return isFaithful(roots, lower) && (zero || isFaithful(roots, 3 - lower));
}

function quotient(
  roots: Roots,
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
  roots[k] = hi;
  roots[k + 1] = lo - (hi - t);
  roots[k + 2] = off * Math.abs(hi);
}
