import {
  createAnswers,
  packRays,
  type Rays,
  verdictsOfClasses,
  verdictsOfRoots,
} from '../../src/math/batch/batch.ts';
import { exactKernel } from '../../src/math/batch/exact.ts';
import type { Family } from '../../src/math/families.ts';
import { ulpDistance } from '../../src/math/float/ulp.ts';
import type { Verdict } from '../../src/math/intersection.ts';
import type { Method } from '../../src/math/methods/define.ts';
import { type Random, seeded } from '../../src/math/rng.ts';
import type { Shape } from '../../src/math/shapes/index.ts';

/** Shapes of a family with rays for each, and what is exactly right. */
export interface Batch {
  readonly shape: Shape;
  readonly rays: Rays;
  readonly verdicts: readonly Verdict[];
  readonly t0: Float64Array;
  readonly t1: Float64Array;
}

export function batchesOf(family: Family, seed: number, shapes: number, count: number): Batch[] {
  const random: Random = seeded(seed);
  return Array.from({ length: shapes }, () => {
    const { shape, rays: list } = family.batch(random, count);
    const rays = packRays(list);
    const out = createAnswers(count);
    exactKernel(shape)?.both(rays, out);
    return { shape, rays, verdicts: verdictsOfRoots(out, count), t0: out.t0, t1: out.t1 };
  });
}

/** What a method gets wrong, told beside its price. */
export interface Quality {
  wrong: number;
  undecided: number;
  /** Of the roots of rays whose class is right. */
  readonly ulps: number[];
}

export function qualityOf(method: Method, batches: readonly Batch[]): Quality {
  const found: Quality = { wrong: 0, undecided: 0, ulps: [] };
  for (const { shape, rays, verdicts, t0, t1 } of batches) {
    const kernel = method.batch?.(shape);
    const out = createAnswers(rays.count);
    kernel?.classes(rays, out);
    const byClasses = verdictsOfClasses(out, rays.count, kernel?.met ?? 'two');
    kernel?.both(rays, out);
    verdictsOfRoots(out, rays.count).forEach((verdict, i) => {
      if (verdict === 'undecided') found.undecided += 1;
      else if (verdict !== verdicts[i] || byClasses[i] !== verdict) found.wrong += 1;
      else {
        if (!Number.isNaN(t0[i]))
          found.ulps.push(ulpDistance(out.t0[i] as number, t0[i] as number));
        if (!Number.isNaN(t1[i]))
          found.ulps.push(ulpDistance(out.t1[i] as number, t1[i] as number));
      }
    });
  }
  found.ulps.sort((a, b) => a - b);
  return found;
}
