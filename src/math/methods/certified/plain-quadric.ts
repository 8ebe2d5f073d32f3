import { TWO } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import type { CurvedDetails, Intersection, Sign } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import { A, B, C, createAlgebra, D, OFF, putAlgebra, SIZE } from './algebra.ts';
import { FAITHFUL } from './faithful.ts';
import { createRoots, hitAt } from './hit-quadric.ts';
import { DIRECT_ERROR } from './moment-bound.ts';
import { createFound, findRoots, T0, T1, VERDICT } from './one-ray.ts';
import { putRoots } from './plain-roots.ts';

/*
 * One ray against a curved shape, all that is asked in one go: A, B, C, D, class, roots, points and normals as plain numbers. For what grid-quadric.ts
 * leaves open and twice the digits settle: grazing, far and odd rays; null for the rest, which object.ts passes on. The errors: algebra.ts, plain-roots.ts.
 *
 * A and C are asked about by their roots. Where there are none, D = b² − AC < 0 says |AC| ≥ |D|: if D is faithful, with 136u² AmCm and SMALLEST_D, then A and C are, with
 * less of Am and Cm and with SMALLEST, as both are below LARGE. And roots of a faithful D are so far apart that they keep their order.
 */

/* In the ray's own units: findRoots may go on to others, with arrays of its own. */
const algebra = createAlgebra();
const roots = createRoots();
const found = createFound();
const at = (k: number): number => algebra[k] as number;
const signOf = (x: number): Sign => (x > 0 ? 1 : -1);

/** The whole answer, or null where one of its numbers stays open. */
export function plainQuadric(q: Quadric, ray: Ray): Intersection | null {
  putAlgebra(q, ray, algebra);
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
  if (!putRoots(algebra, roots)) return null;
  findRoots(q, ray, found);
  if (found[VERDICT] !== TWO) return null;
  const near = hitAt(q, ray, algebra, roots, 0, found[T0] as number);
  const far = near && hitAt(q, ray, algebra, roots, 3, found[T1] as number);
  return far && { class: 'two', hits: [near, far], method: 'certified', decidedBy, details };
}
