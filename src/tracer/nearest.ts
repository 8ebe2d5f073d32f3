import type { Wave } from '../scene/effects/body.ts';
import { AHEAD } from './ask.ts';
import { askBoxed, type Groups } from './groups.ts';
import type { Tally } from './ledger.ts';
import type { Scratch } from './scratch.ts';
import { NOTHING } from './types.ts';
import type { Target } from './world.ts';

/** Puts each ray's nearest hit into t and surface. `tMin`: least t of rays that leave a surface. */
export function findNearest(
  wave: Wave,
  groups: Groups,
  targets: readonly Target[],
  tMin: number,
  scratch: Scratch,
  tally: Tally,
): void {
  const { count, t, surface, rays, from } = wave;
  scratch.need(count);
  const asker = scratch.asker();
  const everyone = scratch.everyone();
  const all = { rays, index: everyone };
  asker.begin(wave, count);
  t.fill(Number.POSITIVE_INFINITY, 0, count);
  surface.fill(NOTHING, 0, count);
  // Camera rays leave no surface: any t > 0 counts, and they need not be packed.
  const camera = wave.depth === 0;
  const least = camera ? AHEAD : tMin;

  function ask(target: Target, list: Int32Array, n: number): void {
    if (camera && list === everyone) {
      asker.firstOf(target, all, least, tally);
      takeNearer(target.surface, everyone, asker.out.t0, count, wave);
      return;
    }
    const { others, leaving, out } = asker;
    asker.pack(target, rays, from, list, n, tally);
    asker.firstOf(target, others, least, tally);
    takeNearer(target.surface, others.index, out.t0, others.rays.count, wave);
    asker.firstOfLeaving(target, tally);
    takeNearer(target.surface, leaving.index, out.t0, leaving.rays.count, wave);
  }

  for (const target of groups.open) ask(target, everyone, count);
  askBoxed(groups, { rays, count, limit: t }, scratch, (k, list, n) =>
    ask(targets[k] as Target, list, n),
  );
  for (let i = 0; i < count; i++) {
    if (surface[i] === NOTHING) t[i] = Number.NaN;
  }
}

/** Keeps the nearer hit; at equal t the surface that is first in the scene. */
function takeNearer(
  target: number,
  index: Int32Array,
  found: Float64Array,
  count: number,
  { t, surface }: Wave,
): void {
  for (let k = 0; k < count; k++) {
    const i = index[k] as number;
    const x = found[k] as number;
    const best = t[i] as number;
    if (x < best || (x === best && target < (surface[i] as number))) {
      t[i] = x;
      surface[i] = target;
    }
  }
}
