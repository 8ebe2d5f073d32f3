import { accelerate, decelerate } from '../../../src/math/accelerate.ts';
import {
  type Answers,
  createAnswers,
  createRays,
  type Rays,
} from '../../../src/math/batch/batch.ts';
import { batchOf } from '../../../src/math/batch/kernels.ts';
import { kernelArray } from '../../../src/math/batch/memory.ts';
import { certified } from '../../../src/math/methods/certified.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';

/* The same questions with the stages in TypeScript and with the kernels. */

/** Where arrays are: `memory` is the kernels'. */
export type Where = 'memory' | 'ordinary';

/** Runs `make` where the arrays of kernelArray are made there. */
export function arraysIn<T>(where: Where, make: () => T): T {
  if (where === 'memory') accelerate();
  else decelerate();
  try {
    return make();
  } finally {
    decelerate();
  }
}

/** As packRays, in arrays that may be longer; what is in them beyond is no number of any ray. */
export function packed(list: readonly Ray[], capacity = list.length): Rays {
  const rays = createRays(capacity, kernelArray);
  for (const array of [rays.Ex, rays.Ey, rays.Ez, rays.dx, rays.dy, rays.dz]) array.fill(BESIDE);
  rays.count = list.length;
  list.forEach(({ origin, direction }, i) => {
    [rays.Ex[i], rays.Ey[i], rays.Ez[i]] = origin;
    [rays.dx[i], rays.dy[i], rays.dz[i]] = direction;
  });
  return rays;
}

/** What answers hold before, and beyond the count after, too. */
export const BESIDE = 77.5;

export function blank(capacity: number): Answers {
  const out = createAnswers(capacity, kernelArray);
  for (const array of [out.t0, out.t1, out.margin]) array.fill(BESIDE);
  out.rareIndex.fill(-1);
  return out;
}

interface Found {
  readonly t0: Float64Array;
  readonly t1: Float64Array;
  /** `ray verdict`, sorted. */
  readonly rare: readonly string[];
}

/** Copies: what lies in the kernels' memory is written over. */
export function found(out: Answers): Found {
  const rare = Array.from(
    { length: out.rareCount },
    (_, k) => `${out.rareIndex[k]} ${out.rareVerdict[k]}`,
  );
  return { t0: out.t0.slice(), t1: out.t1.slice(), rare: rare.sort() };
}

export type Ask = 'both' | 'first' | 'classes';

/** Asks certified, by the kernels or without them. */
export function ask(fast: boolean, form: Ask, shape: Shape, rays: Rays, out: Answers): void {
  if (fast) {
    if (!accelerate()) throw new Error('this engine has no WebAssembly vectors');
  } else decelerate();
  try {
    const kernel = batchOf(certified, shape);
    if (!kernel) throw new Error(`no kernel for ${shape.kind}`);
    if (form === 'first') kernel.first(rays, 0, Number.POSITIVE_INFINITY, out);
    else kernel[form](rays, out);
  } finally {
    decelerate();
  }
}

/**
 * The first place where two arrays are not the same doubles (all NaN are alike), in words; null if
 * there is none.
 */
export function difference(a: Float64Array, b: Float64Array): string | null {
  if (a.length !== b.length) return `${a.length} and ${b.length} numbers`;
  const at = a.findIndex((x, i) => !Object.is(x, b[i]));
  return at < 0 ? null : `at ${at}: ${a[at]} and ${b[at]}`;
}
