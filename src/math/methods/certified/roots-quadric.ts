import type { Answers, Rays } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { count, doubtful, ordinaryRoots, unsettled } from './lattice-roots.ts';
import { BLOCK, DOUBTS, UNSETTLED } from './lattice-scratch.ts';
import { recentredAroundAxis } from './recentred-axis.ts';
import { recentredInSpace } from './recentred-space.ts';
import { refine } from './refined-roots.ts';
import type { CertifiedQuadric } from './scaled-quadric.ts';

/** Rays that the fast stages leave open, in `open[0 … count − 1]`. */
export interface OpenRays {
  count: number;
  open: Int32Array;
}

/** Both roots as `bothRoots` finds them, to the bit. */
export type FastRoots = (
  q: Quadric,
  c: CertifiedQuadric,
  rays: Rays,
  out: Answers,
  left: OpenRays,
) => void;

/** Below, copying the rays costs more than is won. */
const LEAST_BATCH = 16;
let fast: FastRoots | null = null;

/**
 * From now on batches go through `roots`; null: through TypeScript again.
 *
 * @returns what they went through until now.
 */
export function useFastRoots(roots: FastRoots | null): FastRoots | null {
  const before = fast;
  fast = roots;
  return before;
}

/** Whether batches go through WebAssembly. */
export const isFast = (): boolean => fast !== null;

/**
 * Both roots of curved shapes, block by block, each of which stays in the first cache: ordinary rays in units, far and grazing ones about a
 * point near both roots, and what these leave root by root. Each stage certifies what it answers.
 */
export function bothRoots(
  q: Quadric,
  c: CertifiedQuadric,
  rays: Rays,
  out: Answers,
  left: OpenRays,
): void {
  if (fast && rays.count >= LEAST_BATCH) {
    fast(q, c, rays, out, left);
    return;
  }
  left.count = 0;
  const recentred = q.hasY ? recentredInSpace : recentredAroundAxis;
  for (let from = 0; from < rays.count; from += BLOCK) {
    const to = Math.min(from + BLOCK, rays.count);
    if (c.lattice) ordinaryRoots(c.lattice, q.hasY, rays, out, from, to);
    else leaveAll(from, to);
    const doubts = count[DOUBTS] as number;
    const far = doubts > 0 ? recentred(c.numbers, rays, out, doubtful, doubts) : 0;
    refineAndList(q, c, rays, out, left, doubtful, far);
    refineAndList(q, c, rays, out, left, unsettled, count[UNSETTLED] as number);
  }
}

function refineAndList(
  q: Quadric,
  c: CertifiedQuadric,
  rays: Rays,
  out: Answers,
  left: OpenRays,
  places: Int32Array,
  count: number,
): void {
  if (count === 0) return;
  const rest = refine(c.numbers, q.hasY, rays, out, places, count);
  for (let j = 0; j < rest; j++) left.open[left.count++] = places[j] as number;
}

function leaveAll(from: number, to: number): void {
  for (let i = from; i < to; i++) doubtful[i - from] = i;
  count[DOUBTS] = to - from;
  count[UNSETTLED] = 0;
}
