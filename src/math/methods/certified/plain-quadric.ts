import { TWO } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import type { CurvedDetails, Intersection, Sign } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import { DIRECT_ERROR } from './class.ts';
import {
  AT_A,
  AT_B,
  AT_C,
  AT_D,
  AT_OFF,
  AT_SIZE,
  createAlgebra,
  createRoots,
  putAlgebra,
} from './doubled.ts';
import { putRoots } from './doubled-roots.ts';
import { hitAt } from './hits.ts';
import { createFound, findRoots, T0, T1, VERDICT } from './one-ray.ts';
import type { CertifiedQuadric } from './quadric-numbers.ts';
import { FAITHFUL } from './stage.ts';

/*
 * One ray against a curved shape, all that is asked in one go: A, B, C, D, class, roots, points and
 * normals as plain numbers. For what grid-quadric.ts leaves open and twice the digits settle:
 * grazing, far and odd rays; null for the rest, which object.ts passes on. The errors: doubled.ts,
 * doubled.ts.
 *
 * A and C are asked about by their roots. Where there are none, D = b² − AC < 0 says |AC| ≥ |D|: if
 * D is faithful, with 136u² AmCm and SMALLEST_D, then A and C are, with less of Am and Cm and with
 * SMALLEST_ALGEBRA, as both are below LARGE. And roots of a faithful D are so far apart that they
 * keep their order.
 */

/* In the ray's own units: findRoots may go on to others, with arrays of its own. */
const algebra = createAlgebra();
const roots = createRoots();
const found = createFound();
const at = (k: number): number => algebra[k] as number;
const signOf = (x: number): Sign => (x > 0 ? 1 : -1);

/** The whole answer, or null where one of its numbers stays open; `c` as for findRoots. */
export function plainQuadric(q: Quadric, ray: Ray, c?: CertifiedQuadric): Intersection | null {
  putAlgebra(q, ray, algebra);
  const D1 = at(AT_D);
  const faithful =
    at(AT_OFF + 1) <= FAITHFUL * Math.abs(at(AT_B)) &&
    at(AT_OFF + 3) <= FAITHFUL * Math.abs(D1) &&
    at(AT_SIZE) > 0;
  if (!faithful) return null;
  const details: CurvedDetails = {
    family: 'curved',
    A: at(AT_A),
    B: 2 * at(AT_B),
    C: at(AT_C),
    D: 4 * D1,
    signs: {
      A: signOf(at(AT_A)),
      B: signOf(at(AT_B)),
      C: signOf(at(AT_C)),
      D: signOf(D1),
    },
  };
  // Where the filter of the batch kernels would have been sure, the lower halves were not needed
  // for the class.
  const decidedBy = Math.abs(D1) > DIRECT_ERROR * at(AT_SIZE) ? 'filter' : 'double-double';
  if (D1 < 0) return { class: 'none', hits: [], method: 'certified', decidedBy, details };
  if (!putRoots(algebra, roots)) return null;
  findRoots(q, ray, found, c);
  if (found[VERDICT] !== TWO) return null;
  const near = hitAt(q, ray, algebra, roots, 0, found[T0] as number);
  const far = near && hitAt(q, ray, algebra, roots, 3, found[T1] as number);
  return far && { class: 'two', hits: [near, far], method: 'certified', decidedBy, details };
}
