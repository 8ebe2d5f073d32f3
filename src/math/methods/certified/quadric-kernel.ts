import {
  type Answers,
  checkRay,
  chooseFirst,
  createAnswers,
  createRays,
  type Kernel,
  keepUnsettled,
  list,
  NONE,
  type Rays,
  TWO,
} from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import type { DecidedBy } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import { classesAroundAxis, classesByMoment, classesInSpace } from './class.ts';
import { solveSlowly } from './doubled.ts';
import { surfaceAroundAxis, surfaceInSpace, surfaceNumbers } from './from-surface.ts';
import {
  type CertifiedQuadric,
  type CertifiedSlot,
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

/** What a block's passes hand on; the lists are read as soon as these have ended. */
const scratch = createScratch();
const ordinaryRoots = ordinaryRootsWith(scratch);

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
    fast.roots(q, c, rays, out, left);
    return;
  }
  left.count = 0;
  const { doubtful, unsettled, starting, count } = scratch;
  const recentred = q.hasY ? recentredInSpace : recentredAroundAxis;
  for (let from = 0; from < rays.count; from += BLOCK) {
    const to = Math.min(from + BLOCK, rays.count);
    if (c.lattice) ordinaryRoots(c.lattice, q.hasY, rays, out, from, to);
    else leaveAll(scratch, from, to);
    const doubts = count[DOUBTS] as number;
    const far = doubts > 0 ? recentred(c.numbers, rays, out, doubtful, doubts) : 0;
    refineAndList(q, c, rays, out, left, doubtful, far);
    refineAndList(q, c, rays, out, left, starting, fromSurface(q, c, rays, out));
    refineAndList(q, c, rays, out, left, unsettled, count[UNSETTLED] as number);
  }
}

/** Writes D/4 where its sign is certain, and leaves the other rays open. */
export function openClasses(
  q: Quadric,
  c: CertifiedQuadric,
  rays: Rays,
  out: Answers,
  left: OpenRays,
): void {
  if (fast && rays.count >= LEAST_BATCH) fast.classes(q, c, rays, out, left);
  else {
    const pass = q.hasY ? classesInSpace : classesAroundAxis;
    left.count = pass(c.numbers, rays, out, left.open);
  }
  classesByMoment(q, c, rays, out, left);
}

/** How many of the rays that start on a surface or near it are left. */
function fromSurface(q: Quadric, c: CertifiedQuadric, rays: Rays, out: Answers): number {
  const starts = scratch.count[STARTING] as number;
  if (starts === 0) return 0;
  const pass = q.hasY ? surfaceInSpace : surfaceAroundAxis;
  return pass(surfaceNumbers(q, c), rays, out, scratch.starting, starts);
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
      if (fast && rays.count >= LEAST_BATCH) fast.first(out, rays.count, tMin, tMax);
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

/*
 * A batch of one: an object's roots are the batch's, to the bit, as a faithful root can be either
 * of two doubles.
 */

/** A batch of one ray with its answers, and the function that puts a ray into it. */
export interface OneRay {
  readonly rays: Rays;
  readonly out: Answers;
  readonly left: OpenRays;
  readonly setRay: (ray: Ray) => void;
}

/** A batch of one ray, not yet put. */
export function createOneRay(): OneRay {
  const rays = Object.assign(createRays(1), { count: 1 });
  const left = { count: 0, open: new Int32Array(1) };
  return { rays, out: createAnswers(1), left, setRay: into(rays) };
}

/**
 * What was found of a ray: the two roots, NaN where there is none, the verdict, and by which stage.
 * In doubles: fields of an object would be boxed.
 */
export type Found = Float64Array;
/** A `Found` of zeros. */
export const createFound = (): Found => new Float64Array(4);
/** Indices into `Found`. */
export const T0 = 0;
export const T1 = 1;
export const VERDICT = 2;
export const STAGE = 3;
const STAGES: readonly DecidedBy[] = ['filter', 'double-double', 'exact'];
/** The stage that decided, from `found[STAGE]`. */
export const stageFound = (found: Found): DecidedBy => STAGES[found[STAGE] as number] ?? 'exact';

/** A closure over its arrays, as in units.ts. */
function into({ Ex, Ey, Ez, dx, dy, dz }: Rays): (ray: Ray) => void {
  return ({ origin: E, direction: d }) => {
    Ex[0] = E[0];
    Ey[0] = E[1];
    Ez[0] = E[2];
    dx[0] = d[0];
    dy[0] = d[1];
    dz[0] = d[2];
  };
}

/**
 * Fills `found` by the stages that a batch goes through. `c` is what certifiedQuadric makes of `q`,
 * for whoever has it at hand.
 */
export const findRoots = finder();

function finder(): (q: Quadric, ray: Ray, found: Found, c?: CertifiedQuadric) => void {
  const { rays, out, left, setRay } = createOneRay();
  const { t0, t1 } = out;
  const slot = certifiedSlot();
  return (q, ray, found, c = certifiedQuadric(q)) => {
    if (c.inBox) {
      setRay(ray);
      bothRoots(q, c, rays, out, left);
      if (left.count === 0) {
        const t = t0[0] as number;
        found[T0] = t;
        found[T1] = t1[0] as number;
        found[VERDICT] = Number.isNaN(t) ? NONE : TWO;
        found[STAGE] = 0;
        return;
      }
    }
    found[VERDICT] = solveSlowly(q, ray, slot);
    found[T0] = slot.t0;
    found[T1] = slot.t1;
    found[STAGE] = slot.exact ? 2 : 1;
  };
}

/** The stage after the filter that decided. */
export const stageOf = ({ exact }: CertifiedSlot): DecidedBy => (exact ? 'exact' : 'double-double');
