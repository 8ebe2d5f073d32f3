import type { Answers, Rays } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { count, doubtful, ordinaryRoots } from './lattice-roots.ts';
import { BLOCK, DOUBTS } from './lattice-scratch.ts';
import { recentredAroundAxis, recentredInSpace } from './recentred.ts';
import { refine } from './refined.ts';
import type { CertifiedQuadric } from './scaled-quadric.ts';

export { LEAST_A, momentError } from './moment-bound.ts';

/** Rays that the fast stages leave open, in `open[0 … count − 1]`. */
export interface OpenRays {
  count: number;
  open: Int32Array;
}

/**
 * Both roots of curved shapes, block by block, each of which stays in the first cache: ordinary rays in units, then what that leaves
 * about a point near both roots, for far and grazing rays, and then root by root. Each stage certifies what it answers.
 */
export function bothRoots(
  q: Quadric,
  c: CertifiedQuadric,
  rays: Rays,
  out: Answers,
  left: OpenRays,
): void {
  left.count = 0;
  const recentred = q.hasY ? recentredInSpace : recentredAroundAxis;
  for (let from = 0; from < rays.count; from += BLOCK) {
    const to = Math.min(from + BLOCK, rays.count);
    if (c.lattice) ordinaryRoots(c.lattice, q.hasY, rays, out, from, to);
    else leaveAll(from, to);
    let doubts = count[DOUBTS] as number;
    if (doubts > 0) doubts = recentred(c.numbers, rays, out, doubtful, doubts);
    if (doubts > 0) doubts = refine(c.numbers, q.hasY, rays, out, doubtful, doubts);
    for (let j = 0; j < doubts; j++) left.open[left.count++] = doubtful[j] as number;
  }
}

function leaveAll(from: number, to: number): void {
  for (let i = from; i < to; i++) doubtful[i - from] = i;
  count[DOUBTS] = to - from;
}
