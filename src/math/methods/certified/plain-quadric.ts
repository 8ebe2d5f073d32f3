import { TWO } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { squareError, sumError } from '../../float/eft.ts';
import type { CurvedDetails, Intersection, Sign } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import { A, ALGEBRA, B, C, D, lost, OFF, putAlgebra, SIZE, SPLITTER } from './algebra.ts';
import { DIRECT_ERROR } from './class-quadric.ts';
import { FAITHFUL } from './faithful.ts';
import { hitAt, ROOTS } from './hit-quadric.ts';
import { FOUND, findRoots, T0, T1, VERDICT } from './one-ray.ts';

/*
 * One ray against a curved shape, all that is asked in one go: A, B, C, D, class, roots, points and normals as plain numbers. For what grid-quadric.ts
 * leaves open and twice the digits settle: grazing, far and odd rays; null for the rest, which object.ts passes on. The errors, beyond those of algebra.ts:
 *
 *   s = √D/4     hi − s² exact, 2u of D, and D's lower half: 3u²; the quotient 1.5u², what Newton's step leaves 1.1u²: 4.1u²; D's own error: |δD|/s
 *   q = −(b ± s) with b's sign: lower halves 1.5u and u, their sums 4u², and what b and s are off.         together (δb + δD/s)/|q| + 9u²
 *   t = q/A, C/q  the rest is 2u and two lower halves, 4u in all: 9u²; by a quotient that is off by 2u, and without the lower half: 12u²
 *                hitAt's sums add 5u²:                                                                    26u²
 *
 * A and C are asked about by their roots. Where there are none, D = b² − AC < 0 says |AC| ≥ |D|: if D is faithful, with 136u² AmCm and SMALLEST_D, then A and C are, with
 * less of Am and Cm and with SMALLEST, as both are below LARGE.
 *
 * A number hi + lo whose error is below u/4 of it is faithful as hi: FAITHFUL. Roots keep their order: t = q/A is the lesser one if A and q differ in sign.
 */
const UU = 2 ** -106;
export const ROUNDED_Q = 10 * UU;
export const QUOTIENT = 30 * UU;

const at = (k: number): number => ALGEBRA[k] as number;
const signOf = (x: number): Sign => (x > 0 ? 1 : -1);

/** The whole answer, or null where one of its numbers stays open. */
export function plainQuadric(q: Quadric, ray: Ray): Intersection | null {
  putAlgebra(q, ray);
  const D1 = at(D);
  const faithful =
    at(OFF + 1) <= FAITHFUL * Math.abs(at(B)) &&
    at(OFF + 3) <= FAITHFUL * Math.abs(D1) &&
    at(SIZE) > 0;
  if (!faithful) return null;
  const details: CurvedDetails = {
    family: 'curved',
    A: at(A),
    B: 2 * at(B),
    C: at(C),
    D: 4 * D1,
    signs: { A: signOf(at(A)), B: signOf(at(B)), C: signOf(at(C)), D: signOf(D1) },
  };
  // Where the filter of the batch kernels would have been sure, the lower halves were not needed for the class.
  const decidedBy = Math.abs(D1) > DIRECT_ERROR * at(SIZE) ? 'filter' : 'double-double';
  if (D1 < 0) return { class: 'none', hits: [], method: 'certified', decidedBy, details };
  if (!putRoots()) return null;
  findRoots(q, ray);
  if (FOUND[VERDICT] !== TWO) return null;
  const near = hitAt(q, ray, 0, FOUND[T0] as number);
  const far = near && hitAt(q, ray, 3, FOUND[T1] as number);
  return far && { class: 'two', hits: [near, far], method: 'certified', decidedBy, details };
}

/** False where one of them is not known to be faithful. */
function putRoots(): boolean {
  const D1 = at(D);
  const s = Math.sqrt(D1);
  const ss = s * s;
  const sl = (D1 - ss - squareError(s, ss) + at(D + 1)) / (2 * s);
  const b = at(B);
  const turn = b < 0 ? 1 : -1;
  // q = −(b ± √D) with b's sign.
  const q0 = -b + turn * s;
  const q1 = sumError(-b, turn * s, q0) + (turn * sl - at(B + 1));
  const qh = q0 + q1;
  const ql = q1 - (qh - q0);
  const offQ = (at(OFF + 1) + at(OFF + 3) / s) / Math.abs(qh) + ROUNDED_Q;
  const A1 = at(A);
  const lower = A1 > 0 === qh < 0 ? 0 : 3;
  quotient(lower, qh, ql, A1, at(A + 1), offQ + at(OFF) / Math.abs(A1) + QUOTIENT);
  const C1 = at(C);
  quotient(3 - lower, C1, at(C + 1), qh, ql, offQ + at(OFF + 2) / Math.abs(C1) + QUOTIENT);
  return (
    (ROOTS[2] as number) < FAITHFUL * Math.abs(ROOTS[0] as number) &&
    (ROOTS[5] as number) < FAITHFUL * Math.abs(ROOTS[3] as number)
  );
}

function quotient(k: number, n: number, nl: number, m: number, ml: number, off: number): void {
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
  ROOTS[k] = hi;
  ROOTS[k + 1] = lo - (hi - t);
  ROOTS[k + 2] = off * Math.abs(hi);
}
