import {
  type Answers,
  createAnswers,
  createRays,
  kernelArray,
  NONE,
  type Rays,
} from '../math/batch.ts';
import type { RootsBody } from '../scene/effects/body.ts';
import { dropStart } from '../scene/start.ts';
import { departs } from './departs.ts';
import type { Tally } from './ledger.ts';
import type { StartRule } from './types.ts';
import type { Target } from './world.ts';

/** Rays packed for one kernel call: `index[k]` says which ray of the wave the k-th is. */
interface Packed {
  readonly rays: Rays;
  readonly index: Int32Array;
}

export interface Asker {
  /** Those of the rays that do not leave the target, and those that do. */
  readonly others: Packed;
  readonly leaving: Packed;
  readonly out: Answers;
  /**
   * Packs rays list[0 … count − 1] for the target. Under a rule other than `from` nobody is said to
   * leave.
   */
  pack(
    target: Target,
    rays: Rays,
    from: Int32Array,
    list: Int32Array,
    count: number,
    tally: Tally,
  ): void;
  /**
   * Of the packed others only those whose whole line meets the target are kept: no root is worked
   * out.
   */
  keepMeeting(target: Target, tally: Tally): void;
  /**
   * The first root that counts into out.t0, NaN where there is none, for packed others (or any rays
   * that do not leave).
   */
  firstOf(target: Target, rays: Rays, tMin: number, tally: Tally): void;
  /** The same for the packed leaving ones, whose start is dropped. */
  firstOfLeaving(target: Target, tally: Tally): void;
}

/** t > 0, as the closed interval of a kernel says it. */
export const AHEAD = Number.MIN_VALUE;

/** The least t that counts for a ray that leaves a surface. */
export const startOf = (start: StartRule): number =>
  start.rule === 'epsilon' ? Math.max(start.epsilon, AHEAD) : AHEAD;

export interface HeightsEffect {
  readonly body: RootsBody;
  readonly clock: () => number;
  /** Told of the second roots that it had solved, and of its time. */
  readonly spend: (solves: number, ms: number) => void;
}

/**
 * Whoever asks: the same questions serve nearest hits and shadow rays. `heights` is undefined where
 * no target is cut.
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

  /** Both roots were asked for where one would do but for the heights: the second is theirs. */
  function choose(target: Target, rays: Rays, tMin: number, leaves: boolean, tally: Tally): void {
    target.kernel.both(rays, out);
    tally.questions += rays.count;
    const second = target.flat ? 0 : rays.count;
    tally.solves += rays.count + (leaves ? second : 0);
    if (!heights) return;
    const before = heights.clock();
    heights.body.choose(rays, out, target.low, target.high, tMin, leaves);
    heights.spend(leaves ? 0 : second, heights.clock() - before);
  }

  return {
    others,
    leaving,
    out,
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
          // A flat shape is met only once, and there the ray starts.
          if (target.flat) continue;
          if (proven && departs(proven, a, rays, i)) {
            gone += 1;
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
      tally.questions += rays.count;
      const { margin } = out;
      // Listed rays are no plain misses, whatever their margin says.
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
    firstOf(target, rays, tMin, tally) {
      if (rays.count === 0) return;
      if (target.cut) {
        choose(target, rays, tMin, false, tally);
        return;
      }
      target.kernel.first(rays, tMin, Number.POSITIVE_INFINITY, out);
      tally.questions += rays.count;
      tally.solves += rays.count;
    },
    firstOfLeaving(target, tally) {
      const { rays } = leaving;
      if (rays.count === 0) return;
      if (target.cut) {
        choose(target, rays, AHEAD, true, tally);
        return;
      }
      target.kernel.both(rays, out);
      tally.questions += rays.count;
      tally.solves += 2 * rays.count;
      dropStart(out, rays.count);
      const { t0, t1 } = out;
      for (let k = 0; k < rays.count; k++) {
        if ((t0[k] as number) >= AHEAD) continue;
        t0[k] = (t1[k] as number) >= AHEAD ? (t1[k] as number) : Number.NaN;
      }
    },
  };
}

function copyRay(from: Rays, i: number, to: Rays, k: number): void {
  to.Ex[k] = from.Ex[i] as number;
  to.Ey[k] = from.Ey[i] as number;
  to.Ez[k] = from.Ez[i] as number;
  to.dx[k] = from.dx[i] as number;
  to.dy[k] = from.dy[i] as number;
  to.dz[k] = from.dz[i] as number;
}
