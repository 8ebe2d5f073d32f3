import {
  type Answers,
  createAnswers,
  createRays,
  NONE,
  type Rays,
  TWO,
} from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import type { DecidedBy } from '../../intersection.ts';
import { lazily } from '../../lazily.ts';
import type { Ray } from '../../ray.ts';
import { solveSlowly } from './doubled.ts';
import { type Found, STAGE, T0, T1, VERDICT } from './found.ts';
import { oneAroundAxis, oneInSpace } from './generated/one-ray.ts';
import { type Lists, laterStages } from './kernel.ts';
import {
  type CertifiedQuadric,
  type CertifiedSlot,
  certifiedQuadric,
  certifiedSlot,
  type OpenRays,
} from './numbers.ts';
import { DOUBTS, HITS, STARTING, UNSETTLED } from './units.ts';

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
export function findRoots(
  q: Quadric,
  ray: Ray,
  found: Found,
  c: CertifiedQuadric = certifiedQuadric(q),
): void {
  if (c.inBox) {
    const form = q.hasY ? oneInSpace : oneAroundAxis;
    const list = c.lattice ? form(c.lattice, ray, found) : DOUBTS;
    if (list === HITS || isSettled(list, q, ray, found, c)) {
      found[VERDICT] = Number.isNaN(found[T0]) ? NONE : TWO;
      found[STAGE] = 0;
      return;
    }
  }
  slot ??= certifiedSlot();
  found[VERDICT] = solveSlowly(q, ray, slot);
  found[T0] = slot.t0;
  found[T1] = slot.t1;
  found[STAGE] = slot.exact ? 2 : 1;
}

let slot: CertifiedSlot | null = null;

/** The lists of a block of one ray. */
const ownLists = lazily((): Lists => {
  const list = (): Int32Array => new Int32Array(1);
  return { doubtful: list(), unsettled: list(), starting: list(), count: new Int32Array(4) };
});
const ownBatch = lazily(createOneRay);

/** By the stages for what the ordinary rays' passes have listed. */
function isSettled(list: number, q: Quadric, ray: Ray, found: Found, c: CertifiedQuadric): boolean {
  const { rays, out, left, setRay } = ownBatch();
  const lists = ownLists();
  setRay(ray);
  lists.doubtful[0] = 0;
  lists.unsettled[0] = 0;
  lists.starting[0] = 0;
  for (const k of [DOUBTS, UNSETTLED, STARTING]) lists.count[k] = k === list ? 1 : 0;
  left.count = 0;
  laterStages(lists, q, c, rays, out, left);
  found[T0] = out.t0[0] as number;
  found[T1] = out.t1[0] as number;
  return left.count === 0;
}

/** The stage after the filter that decided. */
export const stageOf = ({ exact }: CertifiedSlot): DecidedBy => (exact ? 'exact' : 'double-double');
