import { CONTAINED, NONE, ONE, TANGENT, TWO, VERDICTS } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { productError, sumError } from '../../float/eft.ts';
import type { CurvedDetails, Hit, Intersection, Sign } from '../../intersection.ts';
import { lazily } from '../../lazily.ts';
import type { Ray } from '../../ray.ts';
import {
  type Algebra,
  AT_A,
  AT_B,
  AT_C,
  AT_D,
  AT_FLARE,
  AT_OFF_B,
  AT_OFF_D,
  AT_PX,
  AT_PY,
  AT_PZ,
  AT_SIZE,
  bottomOf,
  createAlgebra,
  createRoots,
  FAR,
  NEAR,
  putAlgebra,
  putShort,
  putSingle,
  shortVerdict,
  topOf,
  wholeRoot,
} from './algebra.ts';
import { DIRECT_ERROR } from './class.ts';
import { putRoots } from './doubled.ts';
import { createFound, T0, T1, VERDICT } from './found.ts';
import { hitAt } from './hits.ts';
import { type CertifiedQuadric, FAITHFUL } from './numbers.ts';
import { findRoots } from './one-ray.ts';

/*
 * One ray against a curved shape, all that is asked in one go: class, A, B, C, D, roots, points and
 * normals. First where nothing rounds, then by twice the digits. Both have the ray in its own
 * units, in arrays of theirs: findRoots may go on to other units, with arrays of its own.
 */
const createScratch = () => ({
  algebra: createAlgebra(),
  roots: createRoots(),
  found: createFound(),
});
const ownScratch = lazily(createScratch);
type Scratch = ReturnType<typeof createScratch>;
const slot = { t0: Number.NaN, t1: Number.NaN };
const signOf = (x: number): Sign => (x > 0 ? 1 : x < 0 ? -1 : 0);

function detailsOf(algebra: Algebra): CurvedDetails {
  const at = (k: number): number => algebra[k] as number;
  return {
    family: 'curved',
    A: at(AT_A),
    B: 2 * at(AT_B),
    C: at(AT_C),
    D: 4 * at(AT_D),
    signs: { A: signOf(at(AT_A)), B: signOf(at(AT_B)), C: signOf(at(AT_C)), D: signOf(at(AT_D)) },
  };
}

/*
 * Where nothing rounds (putShort). A root n/m with whole n and m ≤ 2^53 has the point
 * (E m + d n)/m: two products with their errors, ≤ 2^69 units, their sum exact as two doubles; the
 * quotient by its remainder is off by 3u², so that rounding it once is faithful, and it is 0 where
 * the sum is. Other roots go by hitAt: no coordinate along which the line moves is 0 there.
 */

/** The whole answer, or null where a number is not short, or one of the answer's stays open. */
export function shortQuadric(q: Quadric, c: CertifiedQuadric, ray: Ray): Intersection | null {
  const own = ownScratch();
  const { algebra } = own;
  if (!putShort(q, ray, algebra)) return null;
  const verdict = shortVerdict(algebra);
  const hits = hitsOf(q, c, ray, verdict, own);
  return (
    hits && {
      class: VERDICTS[verdict] ?? 'undecided',
      hits,
      method: 'certified',
      decidedBy: stageOf(verdict, algebra),
      details: detailsOf(algebra),
    }
  );
}

/** As plainQuadric tells it; what no filter decides for any ray is exact. */
function stageOf(verdict: number, algebra: Algebra): Intersection['decidedBy'] {
  const single = verdict === ONE || verdict === TANGENT || verdict === CONTAINED;
  if (single || algebra[AT_A] === 0) return 'exact';
  const sure = Math.abs(algebra[AT_D] as number) > DIRECT_ERROR * (algebra[AT_SIZE] as number);
  return sure ? 'filter' : 'double-double';
}

function hitsOf(
  q: Quadric,
  c: CertifiedQuadric,
  ray: Ray,
  verdict: number,
  { algebra, roots, found }: Scratch,
): Hit[] | null {
  if (verdict === NONE || verdict === CONTAINED) return [];
  if (verdict !== TWO) {
    putSingle(algebra, verdict, slot);
    const n = topOf(algebra, verdict);
    return [hitAtQuotient(q, ray, algebra, n, bottomOf(algebra, verdict), slot.t0)];
  }
  findRoots(q, ray, found, c);
  if (found[VERDICT] !== TWO) return null;
  const t0 = found[T0] as number;
  const t1 = found[T1] as number;
  const m = algebra[AT_A] as number;
  const s = m > 0 ? wholeRoot(algebra) : -wholeRoot(algebra);
  if (!Number.isNaN(s)) {
    const b = algebra[AT_B] as number;
    return [
      hitAtQuotient(q, ray, algebra, -b - s, m, t0),
      hitAtQuotient(q, ray, algebra, -b + s, m, t1),
    ];
  }
  if (!putRoots(algebra, roots)) return null;
  const near = hitAt(q, ray, algebra, roots, NEAR, t0);
  const far = near && hitAt(q, ray, algebra, roots, FAR, t1);
  return far && [near, far];
}

/** Puts (e m + x n)/m, as two doubles. */
function putQuotient(quotient: Float64Array, e: number, x: number, n: number, m: number): void {
  const em = e * m;
  const xn = x * n;
  const sum = em + xn;
  const lost = sumError(em, xn, sum) + (productError(e, m, em) + productError(x, n, xn));
  const hi = sum + lost;
  const lo = sumError(sum, lost, hi);
  const first = hi / m;
  const p = first * m;
  const rest = (hi - p - productError(first, m, p) + lo) / m;
  const place = first + rest;
  quotient[HI] = place + 0;
  quotient[LO] = rest - (place - first);
}

const HI = 0;
const LO = 1;
/** The coordinate that hitAtQuotient put last: its low part is read before the next is put. */
const ownQuotient = lazily(() => new Float64Array(2));

function hitAtQuotient(
  q: Quadric,
  { origin: E, direction: d }: Ray,
  algebra: Algebra,
  ...at: Quotient
): Hit {
  const [n, m, t] = at;
  const quotient = ownQuotient();
  const coordinate = (e: number, x: number): number => {
    putQuotient(quotient, e, x, n, m);
    return quotient[HI] as number;
  };
  const a = algebra[AT_FLARE] as number;
  const normalX = coordinate(algebra[AT_PX] as number, d[0]);
  const normalZ = coordinate(algebra[AT_PZ] as number, d[2]);
  const above = q.hasY ? coordinate(algebra[AT_PY] as number, d[1]) : 0;
  const down = a * above;
  const low = q.hasY ? productError(a, above, down) + a * (quotient[LO] as number) : 0;
  const normalY = 0 - (down + low);
  return {
    t,
    point: [coordinate(E[0], d[0]), coordinate(E[1], d[1]), coordinate(E[2], d[2])],
    normal: [normalX, normalY, normalZ],
    singular: normalX === 0 && normalY === 0 && normalZ === 0,
  };
}

type Quotient = readonly [n: number, m: number, t: number];

/*
 * By twice the digits: what grids.ts leaves open and these settle, grazing, far and odd rays. Null
 * for the rest, which object.ts passes on. The errors: algebra.ts, doubled.ts.
 *
 * A and C are asked about by their roots. Where there are none, D = b² − AC < 0 says |AC| ≥ |D|: if
 * D is faithful, with 136u² AmCm and SMALLEST_ALGEBRA_D, then A and C are, with less of Am and Cm
 * and with SMALLEST_ALGEBRA, as both are below LARGE. And roots of a faithful D are so far apart
 * that they keep their order.
 */
/** The whole answer, or null where one of its numbers stays open; `c` as for findRoots. */
export function plainQuadric(q: Quadric, ray: Ray, c?: CertifiedQuadric): Intersection | null {
  const { algebra, roots, found } = ownScratch();
  putAlgebra(q, ray, algebra);
  const at = (k: number): number => algebra[k] as number;
  const D1 = at(AT_D);
  const faithful =
    at(AT_OFF_B) <= FAITHFUL * Math.abs(at(AT_B)) &&
    at(AT_OFF_D) <= FAITHFUL * Math.abs(D1) &&
    at(AT_SIZE) > 0;
  if (!faithful) return null;
  const details = detailsOf(algebra);
  // Where the filter of the batch kernels would have been sure, the lower halves were not needed
  // for the class.
  const decidedBy = Math.abs(D1) > DIRECT_ERROR * at(AT_SIZE) ? 'filter' : 'double-double';
  if (D1 < 0) return { class: 'none', hits: [], method: 'certified', decidedBy, details };
  if (!putRoots(algebra, roots)) return null;
  findRoots(q, ray, found, c);
  if (found[VERDICT] !== TWO) return null;
  const near = hitAt(q, ray, algebra, roots, NEAR, found[T0] as number);
  const far = near && hitAt(q, ray, algebra, roots, FAR, found[T1] as number);
  return far && { class: 'two', hits: [near, far], method: 'certified', decidedBy, details };
}
