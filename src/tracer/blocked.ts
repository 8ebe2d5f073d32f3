import type { ShadowRays } from '../scene/effects/body.ts';
import { askBoxed, type Groups } from './groups.ts';
import type { Tally } from './ledger.ts';
import type { Scratch } from './scratch.ts';
import { NOTHING } from './types.ts';
import type { Target } from './world.ts';

/**
 * Puts into blocker a surface that is hit before the limit, the first that is found. Rays whose
 * whole line misses a surface are sorted out first, for which no root has to be computed.
 */
export function findBlocked(
  shadowRays: ShadowRays,
  groups: Groups,
  targets: readonly Target[],
  tMin: number,
  scratch: Scratch,
  tally: Tally,
): void {
  const { count, rays, from, blocker, limit, t } = shadowRays;
  scratch.need(count);
  const asker = scratch.asker();
  asker.begin(shadowRays, count);
  blocker.fill(NOTHING, 0, count);
  t.set(limit.subarray(0, count));

  function take(target: Target, index: Int32Array, n: number): void {
    const { t0 } = asker.out;
    for (let k = 0; k < n; k++) {
      const i = index[k] as number;
      if (!((t0[k] as number) < (limit[i] as number))) continue;
      blocker[i] = target.surface;
      t[i] = t0[k] as number;
    }
  }

  function ask(target: Target, list: Int32Array, n: number): void {
    const { others, leaving } = asker;
    asker.pack(target, rays, from, list, n, tally);
    asker.keepMeeting(target, tally);
    asker.firstOf(target, others, tMin, tally);
    take(target, others.index, others.rays.count);
    asker.firstOfLeaving(target, tally);
    take(target, leaving.index, leaving.rays.count);
  }

  /** The rays of the list that are not blocked so far. */
  function free(list: Int32Array, n: number, kept: Int32Array): number {
    let m = 0;
    for (let k = 0; k < n; k++) {
      const i = list[k] as number;
      kept[m] = i;
      m += blocker[i] === NOTHING ? 1 : 0;
    }
    return m;
  }

  askBoxed(
    groups,
    shadowRays,
    scratch,
    (k, list, n) => ask(targets[k] as Target, list, n),
    (list, n) => free(list, n, list),
  );
  for (const target of groups.open) {
    const kept = scratch.meeting();
    const left = free(scratch.everyone(), count, kept);
    if (left > 0) ask(target, kept, left);
  }
}
