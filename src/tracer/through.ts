import { createAnswers, createRays, kernelArray } from '../math/batch.ts';
import { dropStart } from '../scene/drop-start.ts';
import type { Chords, ShadowRays } from '../scene/effects/body.ts';
import { copyRay } from './ask.ts';
import { askBoxed, type Groups } from './groups.ts';
import type { Tally } from './ledger.ts';
import type { Scratch } from './scratch.ts';
import type { Target } from './world.ts';

interface Crossing {
  readonly t: number;
  readonly surface: number;
  /** Whether the ray leaves the glass of the surface there. */
  readonly leaves: boolean;
}

/**
 * How far each ray runs, before its limit, through the glass of each surface of these groups. As
 * for rays that are bent, the stretch before a point where a ray leaves a surface's glass is in
 * that glass, and around glass is air.
 */
export function createChords(groups: Groups, targets: readonly Target[], scratch: Scratch) {
  let rays = createRays(0, kernelArray);
  let out = createAnswers(0, kernelArray);

  return (shadowRays: ShadowRays, tally: Tally): readonly Chords[] => {
    const { count, from, limit, asked, found } = shadowRays;
    shadowRays.rays.count = count;
    asked.fill(0, 0, count);
    found.fill(0, 0, count);
    scratch.need(count);
    if (out.t0.length < count) {
      rays = createRays(2 * count, kernelArray);
      out = createAnswers(2 * count, kernelArray);
    }
    const crossings = new Map<number, Crossing[]>();
    const chords: Chords[] = [];

    /** Crossings of the rays of the list that start on the target, or that do not. */
    function cross(target: Target, list: Int32Array, n: number, start: boolean): void {
      const { low, high, surface } = target;
      for (let k = 0; k < n; k++) {
        const j = list[k] as number;
        if ((from[j] === surface) !== start) continue;
        for (const t of [out.t0[k] as number, out.t1[k] as number]) {
          const y = (rays.Ey[k] as number) + t * (rays.dy[k] as number);
          // A missing root is NaN, for which each comparison is false.
          if (!(t > 0 && t < (limit[j] as number) && y >= low && y <= high)) continue;
          const crossing = { t, surface, leaves: leavesAt(target, shadowRays, j, t) };
          const others = crossings.get(j);
          if (others) others.push(crossing);
          else crossings.set(j, [crossing]);
          found[j] = (found[j] as number) + 1;
          tally.roots += 1;
        }
      }
    }

    function ask(target: Target, list: Int32Array, n: number): void {
      let starts = false;
      for (let k = 0; k < n; k++) {
        const j = list[k] as number;
        copyRay(shadowRays.rays, j, rays, k);
        asked[j] = (asked[j] as number) + 1;
        starts ||= from[j] === target.surface;
      }
      rays.count = n;
      target.kernel.both(rays, out);
      tally.questions += n;
      tally.solves += target.flat ? n : 2 * n;
      cross(target, list, n, false);
      if (!starts) return;
      dropStart(out, n);
      cross(target, list, n, true);
    }

    for (const target of groups.open) ask(target, scratch.everyone(), count);
    askBoxed(groups, shadowRays, scratch, (k, list, n) => ask(targets[k] as Target, list, n));
    const lengths = new Map<number, Float64Array>();
    for (const [j, of] of crossings) {
      let before = 0;
      // In the order of surfaces where t is equal, however they were asked.
      for (const { t, surface, leaves } of of.sort((a, b) => a.t - b.t || a.surface - b.surface)) {
        if (leaves) {
          const glass = lengths.get(surface) ?? new Float64Array(count);
          lengths.set(surface, glass);
          glass[j] = (glass[j] as number) + t - before;
        }
        before = t;
      }
    }
    // Products of colours do not depend on the order in which boxes were met.
    for (const surface of [...lengths.keys()].sort((a, b) => a - b)) {
      chords.push({ surface, lengths: lengths.get(surface) as Float64Array });
    }
    return chords;
  };
}

/** Whether a ray runs along the surface's normal at t, which points out of its glass. */
function leavesAt({ gradient }: Target, { rays }: ShadowRays, j: number, t: number): boolean {
  const [dx, dy, dz] = [rays.dx[j] as number, rays.dy[j] as number, rays.dz[j] as number];
  const [nx, ny, nz] = gradient.at(
    (rays.Ex[j] as number) + t * dx,
    (rays.Ey[j] as number) + t * dy,
    (rays.Ez[j] as number) + t * dz,
  );
  return nx * dx + ny * dy + nz * dz > 0;
}
