import { certifiedKernel, useFastStages } from '../methods/certified/kernel.ts';
import { certifiedPlanar } from '../methods/certified/planar.ts';
import type { Method } from '../methods/define.ts';
import type { Shape } from '../shapes/index.ts';
import type { Kernel } from './batch.ts';
import { exactKernel } from './exact.ts';
import { planarOf } from './planar.ts';
import { quadricOf } from './quadric.ts';
import { inTypeScript, straightKernel } from './straight.ts';
import { simdNow, type Target } from './target.ts';
import { treeKernel } from './trees.ts';

/**
 * A method's answers for many rays at once: class and roots bit-equal to its `intersect`. The
 * fastest kernel that there is; by default `intersect`, asked ray by ray. Kernels are not a part of
 * a method, because a page that asks for one ray at a time is not to load them.
 *
 * @param method one of METHODS.
 * @param shape as for `intersect`, checked before.
 * @param target TypeScript, or SIMD where there is such a kernel and `accelerate()` has succeeded;
 *   absent: SIMD as long as the module is accelerated. `targetOf` tells which one it is.
 * @see NUMERICS.md, section 5 for `certified`, section 3 for the others; each method names its
 *   `source`.
 * @example
 * const certified = METHODS.find(({ id }) => id === 'certified')!;
 * const kernel = batchOf(certified, { kind: 'cylinder', center: [0, 0, 0], radius: 5 });
 * const out = createAnswers(1);
 * kernel.both(packRays([{ origin: [-10, 0, 3], direction: [1, 0, 0] }]), out);
 * [out.t0[0], out.t1[0]]; // → [6, 14]
 */
export function batchOf(method: Method, shape: Shape, target?: Target): Kernel {
  const kernel = KERNELS[method.id]?.(shape);
  if (kernel) return target === 'typescript' ? withoutSimd(kernel) : kernel;
  const plain = straightKernel(method, shape, inTypeScript);
  if (!plain) return treeKernel(shape, method.intersect);
  return target === 'typescript' ? plain : asAccelerated(method, shape, plain);
}

/**
 * What the kernel that `batchOf` gives for the same runs as: 'simd' only where there is a SIMD
 * kernel and `accelerate()` has succeeded.
 *
 * @param method one of METHODS.
 * @param shape as for `intersect`, checked before.
 * @param target as for `batchOf`.
 * @example
 * const found = METHODS.find(({ id }) => id === 'exact')!;
 * targetOf(found, { kind: 'cylinder', center: [0, 0, 0], radius: 5 }, 'simd'); // → 'typescript'
 */
export const targetOf = (method: Method, shape: Shape, target?: Target): Target =>
  target !== 'typescript' && simdNow() !== null && hasSimd(method, shape) ? 'simd' : 'typescript';

function hasSimd(method: Method, shape: Shape): boolean {
  if (method.id === 'certified') return quadricOf(shape) !== null;
  return straightKernel(method, shape, inTypeScript) !== null;
}

/** SIMD as long as the module is accelerated. */
function asAccelerated(method: Method, shape: Shape, plain: Kernel): Kernel {
  let fast: Kernel | null = null;
  const now = (): Kernel => {
    const simd = simdNow();
    if (!simd) return plain;
    fast ??= straightKernel(method, shape, simd.source, simd.choose);
    return fast ?? plain;
  };
  return {
    met: plain.met,
    classes: (rays, out) => now().classes(rays, out),
    first: (rays, tMin, tMax, out) => now().first(rays, tMin, tMax, out),
    both: (rays, out) => now().both(rays, out),
  };
}

/** The stages of `certified` in TypeScript, whatever batches go through otherwise. */
function withoutSimd(kernel: Kernel): Kernel {
  function slowly(ask: () => void): void {
    const before = useFastStages(null);
    try {
      ask();
    } finally {
      useFastStages(before);
    }
  }
  return {
    met: kernel.met,
    classes: (rays, out) => slowly(() => kernel.classes(rays, out)),
    first: (rays, tMin, tMax, out) => slowly(() => kernel.first(rays, tMin, tMax, out)),
    both: (rays, out) => slowly(() => kernel.both(rays, out)),
  };
}

/** Kernels that are not made of a method's trees; null for a shape that they do not know. */
const KERNELS: Readonly<Record<string, (shape: Shape) => Kernel | null>> = {
  certified: certifiedOf,
  exact: exactKernel,
};

function certifiedOf(shape: Shape): Kernel | null {
  const quadric = quadricOf(shape);
  if (quadric) return certifiedKernel(quadric);
  const planar = planarOf(shape);
  return planar && certifiedPlanar(planar);
}
