import {
  batchOf,
  createAnswers,
  type Kernel,
  kernelArray,
  packRays,
  type Rays,
  verdictsOfRoots,
} from '../math/batch.ts';
import { exactMethod as exact } from '../math/exact.ts';
import type { Family } from '../math/families.ts';
import type { Ray, Shape, Verdict } from '../math/index.ts';
import { type Random, seeded } from '../math/rng.ts';
import type { Method } from '../math/shapes.ts';
import type { Task } from './run.ts';

/** A shape of a family with rays for it, and their exact classes and roots. */
export interface Batch {
  readonly shape: Shape;
  readonly rays: Rays;
  readonly verdicts: readonly Verdict[];
  readonly t0: Float64Array;
  readonly t1: Float64Array;
}

/**
 * How many of a family's rays: `shapes` shapes with `count` rays each, drawn in order from `seed`.
 */
export interface Sample {
  readonly seed: number;
  readonly shapes: number;
  readonly count: number;
  /** Value of the family's dial; absent if the family draws it for each ray. */
  readonly difficulty?: number | undefined;
}

export function batchesOf(family: Family, { seed, shapes, count, difficulty }: Sample): Batch[] {
  const random: Random = seeded(seed);
  return Array.from({ length: shapes }, () => {
    const { shape, rays: list } = family.batch(random, count, difficulty);
    const rays = packRays(list, kernelArray);
    const out = createAnswers(count);
    batchOf(exact, shape).both(rays, out);
    return { shape, rays, verdicts: verdictsOfRoots(out, count), t0: out.t0, t1: out.t1 };
  });
}

/** The question of a batch: class and both roots, or the class alone. */
export type Form = 'both' | 'classes';

/**
 * A task for each method, with the method's own kernels unless `kernelOf` gives others. Results are
 * read, so that an engine cannot skip computing them.
 */
export function tasksOf(
  methods: readonly Method[],
  batches: readonly Pick<Batch, 'shape' | 'rays'>[],
  form: Form,
  kernelOf: (method: Method, shape: Shape) => Kernel = batchOf,
  out = createAnswers(Math.max(0, ...batches.map(({ rays }) => rays.count)), kernelArray),
): readonly (Task & { readonly checksum: () => number })[] {
  return methods.map((method) => {
    const kernels = batches.map(({ shape, rays }) => ({ kernel: kernelOf(method, shape), rays }));
    let seen = 0;
    return {
      id: method.id,
      run() {
        for (const { kernel, rays } of kernels) {
          kernel[form](rays, out);
          seen += out.rareCount + ((out.t0[0] as number) > (out.margin[0] as number) ? 1 : 0);
        }
      },
      checksum: () => seen,
    };
  });
}

/** Ray i of a batch as an object again. */
export const rayAt = ({ rays }: Pick<Batch, 'rays'>, i: number): Ray => ({
  origin: [rays.Ex[i] as number, rays.Ey[i] as number, rays.Ez[i] as number],
  direction: [rays.dx[i] as number, rays.dy[i] as number, rays.dz[i] as number],
});
