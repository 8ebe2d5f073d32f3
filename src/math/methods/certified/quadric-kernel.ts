import {
  type Answers,
  checkRay,
  type Kernel,
  list,
  NONE,
  type Rays,
  selectFirst,
  TWO,
} from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { openClasses } from './class.ts';
import { solveSlowly } from './doubled-roots.ts';
import { type CertifiedQuadric, certifiedQuadric } from './quadric-numbers.ts';
import { recentredAroundAxis, recentredInSpace } from './recentred.ts';
import { refine } from './refined.ts';
import { certifiedSlot, type OpenRays } from './stage.ts';
import { count, doubtful, ordinaryRoots, unsettled } from './units-roots.ts';
import { BLOCK, DOUBTS, UNSETTLED } from './units-rough.ts';

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
 * Both roots of curved shapes, block by block, each of which stays in the first cache: ordinary
 * rays in units, far and grazing ones about a point near both roots, and what these leave root by
 * root. Each stage certifies what it answers.
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

/** Fast stages over all rays, then what they left open, one by one. */
export function certifiedKernel(q: Quadric): Kernel {
  const c = certifiedQuadric(q);
  const slot = certifiedSlot();
  const E: [number, number, number] = [0, 0, 0];
  const d: [number, number, number] = [0, 0, 0];
  const ray = { origin: E, direction: d };
  const left: OpenRays = { count: 0, open: new Int32Array(0) };

  function leaveAllOpen(rays: Rays): void {
    left.count = rays.count;
    for (let i = 0; i < rays.count; i++) left.open[i] = i;
  }

  function finish(rays: Rays, out: Answers): void {
    const { Ex, Ey, Ez, dx, dy, dz } = rays;
    for (let k = 0; k < left.count; k++) {
      const i = left.open[k] as number;
      checkRay(rays, i, q.hasY, out);
      E[0] = Ex[i] as number;
      E[1] = Ey[i] as number;
      E[2] = Ez[i] as number;
      d[0] = dx[i] as number;
      d[1] = dy[i] as number;
      d[2] = dz[i] as number;
      const verdict = solveSlowly(q, ray, slot);
      out.t0[i] = verdict === NONE ? Number.NaN : slot.t0;
      out.t1[i] = verdict === NONE ? Number.NaN : slot.t1;
      out.margin[i] = verdict === NONE ? -1 : 1;
      if (verdict !== NONE && verdict !== TWO) list(out, i, verdict);
    }
  }

  function prepare(rays: Rays, out: Answers): void {
    out.rareCount = 0;
    if (left.open.length < rays.count) left.open = new Int32Array(rays.count);
  }

  function both(rays: Rays, out: Answers): void {
    prepare(rays, out);
    if (c.inBox) bothRoots(q, c, rays, out, left);
    else leaveAllOpen(rays);
    finish(rays, out);
  }

  return {
    met: 'two',
    both,
    first(rays, tMin, tMax, out) {
      both(rays, out);
      selectFirst(out, rays.count, tMin, tMax);
    },
    classes(rays, out) {
      prepare(rays, out);
      if (c.inBox) openClasses(q, c, rays, out, left);
      else leaveAllOpen(rays);
      finish(rays, out);
    },
  };
}
