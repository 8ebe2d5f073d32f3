import {
  type Answers,
  checkRay,
  chooseFirst,
  type Kernel,
  keepUnsettled,
  list,
  NONE,
  type Rays,
  TWO,
} from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { lazily } from '../../lazily.ts';
import { classesAroundAxis, classesByMoment, classesInSpace } from './class.ts';
import { solveSlowly } from './doubled.ts';
import { surfaceAroundAxis, surfaceInSpace, surfaceNumbers } from './from-surface.ts';
import {
  type CertifiedQuadric,
  certifiedQuadric,
  certifiedSlot,
  type OpenRays,
} from './numbers.ts';
import { recentredAroundAxis, recentredInSpace } from './recentred.ts';
import { refine } from './refined.ts';
import {
  BLOCK,
  createScratch,
  DOUBTS,
  ordinaryRootsWith,
  type Scratch,
  STARTING,
  UNSETTLED,
} from './units.ts';

/** Both roots as `bothRoots` finds them, to the bit. */
export type FastRoots = (
  q: Quadric,
  c: CertifiedQuadric,
  rays: Rays,
  out: Answers,
  left: OpenRays,
) => void;

/** What a batch's stages may go through instead of TypeScript. */
export interface FastStages {
  readonly roots: FastRoots;
  /** As a ClassPass, of all the rays: the direct form's answers and what it leaves open. */
  readonly classes: FastRoots;
  /** As chooseFirst, of all the rays. */
  readonly first: (out: Answers, count: number, tMin: number, tMax: number) => void;
}

/** Below, copying the rays costs more than is won. */
const LEAST_BATCH = 16;
let fast: FastStages | null = null;

/**
 * From now on batches go through `stages`; null: through TypeScript again.
 *
 * @returns what they went through until now.
 */
export function useFastStages(stages: FastStages | null): FastStages | null {
  const before = fast;
  fast = stages;
  return before;
}

/**
 * Whether batches go through WebAssembly.
 *
 * @example
 * accelerate(); // → true
 * isFast(); // → true
 * decelerate();
 * isFast(); // → false
 */
export const isFast = (): boolean => fast !== null;

/** What a batch of so many rays goes through instead of TypeScript; null: nothing. */
const fastFor = (count: number): FastStages | null => (count >= LEAST_BATCH ? fast : null);

/** What a block's passes hand on, its lists read as soon as they have ended; and the passes. */
const ordinary = lazily(() => {
  const scratch = createScratch();
  return { scratch, roots: ordinaryRootsWith(scratch) };
});

/**
 * Both roots of curved shapes, block by block, each of which stays in the first cache: ordinary
 * rays in units, far and grazing ones about a point near both roots, and what these leave root by
 * root. Each stage certifies what it answers.
 */
function bothRoots(
  q: Quadric,
  c: CertifiedQuadric,
  rays: Rays,
  out: Answers,
  left: OpenRays,
): void {
  const stages = fastFor(rays.count);
  if (stages) {
    stages.roots(q, c, rays, out, left);
    return;
  }
  const { scratch, roots } = ordinary();
  left.count = 0;
  for (let from = 0; from < rays.count; from += BLOCK) {
    const to = Math.min(from + BLOCK, rays.count);
    if (c.lattice) roots(c.lattice, q.hasY, rays, out, from, to);
    else leaveAll(scratch, from, to);
    laterStages(scratch, q, c, rays, out, left);
  }
}

/** What the passes over a block list. */
export type Lists = Pick<Scratch, 'doubtful' | 'unsettled' | 'starting' | 'count'>;

/** The stages for the rays that are listed; what these leave is put into `left`. */
export function laterStages(
  { doubtful, unsettled, starting, count }: Lists,
  q: Quadric,
  c: CertifiedQuadric,
  rays: Rays,
  out: Answers,
  left: OpenRays,
): void {
  const doubts = count[DOUBTS] as number;
  const starts = count[STARTING] as number;
  if (doubts > 0) {
    const pass = q.hasY ? recentredInSpace : recentredAroundAxis;
    const rest = pass(c.numbers, rays, out, doubtful, doubts);
    refineAndList(q, c, rays, out, left, doubtful, rest);
  }
  if (starts > 0) {
    const pass = q.hasY ? surfaceInSpace : surfaceAroundAxis;
    const rest = pass(surfaceNumbers(q, c), rays, out, starting, starts);
    refineAndList(q, c, rays, out, left, starting, rest);
  }
  refineAndList(q, c, rays, out, left, unsettled, count[UNSETTLED] as number);
}

/** Writes D/4 where its sign is certain, and leaves the other rays open. */
export function openClasses(
  q: Quadric,
  c: CertifiedQuadric,
  rays: Rays,
  out: Answers,
  left: OpenRays,
): void {
  const stages = fastFor(rays.count);
  if (stages) stages.classes(q, c, rays, out, left);
  else {
    const pass = q.hasY ? classesInSpace : classesAroundAxis;
    left.count = pass(c.numbers, rays, out, left.open);
  }
  classesByMoment(q, c, rays, out, left);
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

/** As the passes over a block of a shape that is not ordinary. */
function leaveAll({ doubtful, count }: Scratch, from: number, to: number): void {
  for (let i = from; i < to; i++) doubtful[i - from] = i;
  count[DOUBTS] = to - from;
  count[UNSETTLED] = 0;
  count[STARTING] = 0;
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
      const stages = fastFor(rays.count);
      if (stages) stages.first(out, rays.count, tMin, tMax);
      else chooseFirst(out, 0, rays.count, tMin, tMax);
      keepUnsettled(out);
    },
    classes(rays, out) {
      prepare(rays, out);
      if (c.inBox) openClasses(q, c, rays, out, left);
      else leaveAllOpen(rays);
      finish(rays, out);
    },
  };
}
