import { type Answers, createAnswers, kernelArray } from '../math/batch.ts';
import type { Chords, Feelers } from '../scene/effects/body.ts';
import { dropStart } from '../scene/start.ts';
import type { Tally } from './ledger.ts';
import type { Target } from './world.ts';

interface Crossing {
  readonly t: number;
  /** Index into the surfaces. */
  readonly at: number;
  /** Whether the ray leaves the glass of the surface there. */
  readonly leaves: boolean;
}

/**
 * How far each ray runs, before its limit, through the glass of each of these surfaces. As for rays
 * that are bent, the stretch before a point where a ray leaves a surface's glass is in that glass,
 * and around glass is air.
 */
export function chordsOf(
  feelers: Feelers,
  targets: readonly Target[],
  tally: Tally,
): readonly Chords[] {
  const { count, rays, from, limit, asked, found } = feelers;
  rays.count = count;
  asked.fill(targets.length, 0, count);
  found.fill(0, 0, count);
  const out: Answers = createAnswers(count, kernelArray);
  const crossings: Crossing[][] = Array.from({ length: count }, () => []);

  function cross(target: Target, at: number, start: boolean): void {
    const { low, high } = target;
    for (let j = 0; j < count; j++) {
      if (((from[j] as number) === target.surface) !== start) continue;
      for (const t of [out.t0[j] as number, out.t1[j] as number]) {
        const y = (rays.Ey[j] as number) + t * (rays.dy[j] as number);
        // A missing root is NaN, for which each comparison is false.
        if (!(t > 0 && t < (limit[j] as number) && y >= low && y <= high)) continue;
        crossings[j]?.push({ t, at, leaves: leavesAt(target, feelers, j, t) });
        found[j] = (found[j] as number) + 1;
        tally.roots += 1;
      }
    }
  }

  targets.forEach((target, at) => {
    target.kernel.both(rays, out);
    tally.questions += count;
    tally.solves += target.flat ? count : 2 * count;
    cross(target, at, false);
    if (!from.subarray(0, count).includes(target.surface)) return;
    dropStart(out, count);
    cross(target, at, true);
  });
  const lengths = targets.map(() => new Float64Array(count));
  crossings.forEach((of, j) => {
    let before = 0;
    for (const { t, at, leaves } of of.sort((a, b) => a.t - b.t)) {
      const glass = lengths[at];
      if (leaves && glass) glass[j] = (glass[j] as number) + t - before;
      before = t;
    }
  });
  return targets.map(({ surface }, at) => ({ surface, lengths: lengths[at] as Float64Array }));
}

/** Whether a ray runs along the surface's normal at t, which points out of its glass. */
function leavesAt({ gradient }: Target, { rays }: Feelers, j: number, t: number): boolean {
  const [dx, dy, dz] = [rays.dx[j] as number, rays.dy[j] as number, rays.dz[j] as number];
  const [nx, ny, nz] = gradient.at(
    (rays.Ex[j] as number) + t * dx,
    (rays.Ey[j] as number) + t * dy,
    (rays.Ez[j] as number) + t * dz,
  );
  return nx * dx + ny * dy + nz * dz > 0;
}
