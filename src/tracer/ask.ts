import {
  type Answers,
  createAnswers,
  createRays,
  kernelArray,
  NONE,
  type Rays,
} from '../math/batch.ts';
import { dropStart } from '../scene/drop-start.ts';
import type { RootsBody } from '../scene/effects/body.ts';
import { departs } from './departs.ts';
import type { Tally } from './ledger.ts';
import type { StartRule } from './types.ts';
import type { Target } from './world.ts';

/** Per ray: number of surfaces asked about it, and of those with a root that counts. */
interface Counted {
  readonly asked: Int32Array;
  readonly found: Int32Array;
}

/** Rays packed for one kernel call: the k-th is ray `index[k]` of the wave. */
interface Packed {
  readonly rays: Rays;
  readonly index: Int32Array;
}

export interface Asker {
  /** The rays that start elsewhere than on the target, and those that start on it. */
  readonly others: Packed;
  readonly leaving: Packed;
  readonly out: Answers;
  /** Begins with a wave, or shadow rays, of so many: what is asked and found is counted there. */
  begin(counted: Counted, count: number): void;
  /**
   * Packs rays list[0 … count − 1] for the target. Only under the start rule `from` are rays that
   * leave it kept apart.
   */
  pack(
    target: Target,
    rays: Rays,
    from: Int32Array,
    list: Int32Array,
    count: number,
    tally: Tally,
  ): void;
  /** Drops packed others whose whole line misses the target; computes no roots. */
  keepMeeting(target: Target, tally: Tally): void;
  /** Puts the first root that counts into out.t0, NaN without one; for rays that do not leave. */
  firstOf(target: Target, packed: Packed, tMin: number, tally: Tally): void;
  /** The same for packed rays that leave the target; the root at their start is dropped. */
  firstOfLeaving(target: Target, tally: Tally): void;
}

/** Least t that counts as t > 0, for kernels that take a closed interval. */
export const AHEAD = Number.MIN_VALUE;

/** The least t that counts for a ray that leaves a surface. */
export const startOf = (start: StartRule): number =>
  start.rule === 'epsilon' ? Math.max(start.epsilon, AHEAD) : AHEAD;

export interface HeightsEffect {
  readonly body: RootsBody;
  readonly clock: () => number;
  /** Called with the number of second roots that heights needed, and their time. */
  readonly spend: (solves: number, ms: number) => void;
}

/**
 * Asks methods about packed rays, for nearest hits and for shadow rays. `heights` is undefined if
 * no target is cut off.
 */
export function createAsker(
  capacity: number,
  start: StartRule,
  heights: HeightsEffect | undefined,
): Asker {
  const others: Packed = {
    rays: createRays(capacity, kernelArray),
    index: new Int32Array(capacity),
  };
  const leaving: Packed = {
    rays: createRays(capacity, kernelArray),
    index: new Int32Array(capacity),
  };
  const out = createAnswers(capacity, kernelArray);
  const byIdentity = start.rule === 'from';
  let asked = new Int32Array(0);
  let found = new Int32Array(0);

  function ask({ rays, index }: Packed, tally: Tally): void {
    tally.questions += rays.count;
    for (let k = 0; k < rays.count; k++) {
      const i = index[k] as number;
      asked[i] = (asked[i] as number) + 1;
    }
  }

  /** Counts the rays with a root in out.t0. */
  function find({ rays, index }: Packed, tally: Tally): void {
    const { t0 } = out;
    let n = 0;
    for (let k = 0; k < rays.count; k++) {
      if (Number.isNaN(t0[k])) continue;
      const i = index[k] as number;
      found[i] = (found[i] as number) + 1;
      n += 1;
    }
    tally.roots += n;
  }

  /** Chooses between both roots by height; the second root counts as a cost of the heights. */
  function choose(target: Target, rays: Rays, tMin: number, leaves: boolean, tally: Tally): void {
    target.kernel.both(rays, out);
    const second = target.flat ? 0 : rays.count;
    tally.solves += rays.count + (leaves ? second : 0);
    if (!heights) return;
    const before = heights.clock();
    heights.body.choose(rays, out, target, tMin, leaves);
    heights.spend(leaves ? 0 : second, heights.clock() - before);
  }

  return {
    others,
    leaving,
    out,
    begin(counted, count) {
      asked = counted.asked as typeof asked;
      found = counted.found as typeof found;
      asked.fill(0, 0, count);
      found.fill(0, 0, count);
    },
    pack(target, rays, from, list, count, tally) {
      const self = byIdentity ? target.surface : -2;
      const { proven } = target;
      const { a } = target.gradient;
      let n = 0;
      let m = 0;
      let gone = 0;
      for (let k = 0; k < count; k++) {
        const i = list[k] as number;
        if (from[i] === self) {
          // The only root of a flat shape is where the ray starts.
          if (target.flat) continue;
          if (proven && departs(proven, a, rays, i)) {
            gone += 1;
            asked[i] = (asked[i] as number) + 1;
            continue;
          }
          copyRay(rays, i, leaving.rays, m);
          leaving.index[m++] = i;
        } else {
          copyRay(rays, i, others.rays, n);
          others.index[n++] = i;
        }
      }
      others.rays.count = n;
      leaving.rays.count = m;
      tally.questions += gone;
    },
    keepMeeting(target, tally) {
      const { rays, index } = others;
      if (target.endless || rays.count === 0) return;
      target.kernel.classes(rays, out);
      ask(others, tally);
      const { margin } = out;
      // Rays in the rare list are decided there, not by their margin.
      for (let k = 0; k < out.rareCount; k++) {
        margin[out.rareIndex[k] as number] = out.rareVerdict[k] === NONE ? -1 : 1;
      }
      let n = 0;
      for (let k = 0; k < rays.count; k++) {
        if (!((margin[k] as number) >= 0)) continue;
        if (n < k) copyRay(rays, k, rays, n);
        index[n++] = index[k] as number;
      }
      rays.count = n;
    },
    firstOf(target, packed, tMin, tally) {
      const { rays } = packed;
      if (rays.count === 0) return;
      ask(packed, tally);
      if (target.cut) choose(target, rays, tMin, false, tally);
      else {
        target.kernel.first(rays, tMin, Number.POSITIVE_INFINITY, out);
        tally.solves += rays.count;
      }
      find(packed, tally);
    },
    firstOfLeaving(target, tally) {
      const { rays } = leaving;
      if (rays.count === 0) return;
      ask(leaving, tally);
      if (target.cut) {
        choose(target, rays, AHEAD, true, tally);
        find(leaving, tally);
        return;
      }
      target.kernel.both(rays, out);
      tally.solves += 2 * rays.count;
      dropStart(out, rays.count);
      const { t0, t1 } = out;
      for (let k = 0; k < rays.count; k++) {
        if ((t0[k] as number) >= AHEAD) continue;
        t0[k] = (t1[k] as number) >= AHEAD ? (t1[k] as number) : Number.NaN;
      }
      find(leaving, tally);
    },
  };
}

export function copyRay(from: Rays, i: number, to: Rays, k: number): void {
  to.Ex[k] = from.Ex[i] as number;
  to.Ey[k] = from.Ey[i] as number;
  to.Ez[k] = from.Ez[i] as number;
  to.dx[k] = from.dx[i] as number;
  to.dy[k] = from.dy[i] as number;
  to.dz[k] = from.dz[i] as number;
}
