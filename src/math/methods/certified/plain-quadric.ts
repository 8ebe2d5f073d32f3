import type { Quadric } from '../../batch/quadric.ts';
import { productError, squareError, sumError } from '../../float/eft.ts';
import type { CurvedDetails, Hit, Intersection, Sign } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import { A, ALGEBRA, B, C, D, FLARE, lost, OFF, P, putAlgebra, SIZE, SPLITTER } from './algebra.ts';
import { DIRECT_ERROR } from './class-quadric.ts';

/*
 * One ray against a curved shape, all that is asked in one go: A, B, C, D, class, roots, points and normals as plain numbers. For the nine
 * rays in ten where twice the digits settle every one of them; null for the rest, which object.ts passes on. The errors, beyond those of algebra.ts:
 *
 *   s = √D/4     hi − s² exact, its lower half rounded: 10u²; D's own error: |δD|/s
 *   q = −(b ± s) with b's sign: 4u² and what b and s are off.                                     together (δb + δD/s)/|q| + 16u²
 *   t = q/A, C/q Dekker's division, 29u²                                                                   QUOTIENT has room for the 5u² of t·d below
 *   E + t d      the product and the sum split without loss; rest ≤ u(|X| + 2|t d|) rounded: 5u² of |t d|, u² of |X|
 *   p + t d      the same, and p's lower half
 *
 * A number hi + lo whose error is below u/4 of it is faithful as hi: FAITHFUL. Roots keep their order: t = q/A is the lesser one if A and q differ in sign.
 */
const UU = 2 ** -106;
const QUOTIENT = 48 * UU;
const FAITHFUL = 2 ** -55;
/** Of the normal’s longest component: its direction is promised within 2^-50. */
const STRAIGHT = 2 ** -52;
const LOST = 2 ** -1070;
const SMALLEST = 2 ** -600;

const at = (k: number): number => ALGEBRA[k] as number;
const signOf = (x: number): Sign => (x > 0 ? 1 : -1);

/** The whole answer, or null where one of its numbers stays open. */
export function plainQuadric(q: Quadric, ray: Ray): Intersection | null {
  putAlgebra(q, ray);
  const D1 = at(D);
  const faithful =
    at(OFF) <= FAITHFUL * Math.abs(at(A)) &&
    at(OFF + 1) <= FAITHFUL * Math.abs(at(B)) &&
    at(OFF + 2) <= FAITHFUL * Math.abs(at(C)) &&
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
  roots();
  const near = hitAt(q, ray, 0);
  const far = near && hitAt(q, ray, 3);
  return far && { class: 'two', hits: [near, far], method: 'certified', decidedBy, details };
}

/** Near root hi, lo, relative error; the same for the far one. */
const T = new Float64Array(6);

function roots(): void {
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
  const offQ = (at(OFF + 1) + at(OFF + 3) / s) / Math.abs(qh) + 16 * UU;
  const A1 = at(A);
  const lower = A1 > 0 === qh < 0 ? 0 : 3;
  quotient(lower, qh, ql, A1, at(A + 1), offQ + at(OFF) / Math.abs(A1) + QUOTIENT);
  const C1 = at(C);
  quotient(3 - lower, C1, at(C + 1), qh, ql, offQ + at(OFF + 2) / Math.abs(C1) + QUOTIENT);
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
  T[k] = hi;
  T[k + 1] = lo - (hi - t);
  T[k + 2] = off;
}

function hitAt(q: Quadric, { origin: E, direction: d }: Ray, k: number): Hit | null {
  const t = T[k] as number;
  const tl = T[k + 1] as number;
  const off = T[k + 2] as number;
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
  const offX = dx === 0 ? 0 : off * Math.abs(mx) + LOST;
  const offY = dy === 0 ? 0 : off * Math.abs(my) + LOST;
  const offZ = dz === 0 ? 0 : off * Math.abs(mz) + LOST;
  const faithful =
    off < FAITHFUL &&
    offX + 16 * UU * Math.abs(X) <= FAITHFUL * Math.abs(pointX) &&
    offY + 16 * UU * Math.abs(Y) <= FAITHFUL * Math.abs(pointY) &&
    offZ + 16 * UU * Math.abs(Z) <= FAITHFUL * Math.abs(pointZ);
  if (!faithful) return null;
  const px = at(P);
  const py = at(P + 2);
  const pz = at(P + 4);
  const nx = px + mx;
  const ny = py + my;
  const nz = pz + mz;
  const normalX = nx + (sumError(px, mx, nx) + lx + at(P + 1));
  const rise = sumError(py, my, ny) + ly + at(P + 3);
  const above = ny + rise;
  const normalZ = nz + (sumError(pz, mz, nz) + lz + at(P + 5));
  const a = at(FLARE);
  const down = a * above;
  const normalY = q.hasY
    ? -(down + (productError(a, above, down) + a * (rise - (above - ny)) + at(FLARE + 1) * above))
    : 0;
  const size = Math.abs(a);
  const long = Math.max(Math.abs(normalX), Math.abs(normalY), Math.abs(normalZ));
  const around = Math.abs(px) + Math.abs(pz) + size * Math.abs(py);
  if (!(offX + offZ + size * offY + 32 * UU * around + SMALLEST <= STRAIGHT * long)) return null;
  return {
    t,
    point: [pointX + 0, pointY + 0, pointZ + 0],
    normal: [normalX + 0, normalY + 0, normalZ + 0],
    singular: false,
  };
}
