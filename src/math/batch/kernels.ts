import { certifiedPlanar } from '../methods/certified/planar.ts';
import { certifiedKernel, useFastRoots } from '../methods/certified/quadric-kernel.ts';
import type { Method } from '../methods/define.ts';
import type { Shape } from '../shapes/index.ts';
import type { Kernel } from './batch.ts';
import { exactKernel } from './exact.ts';
import { kernelOf } from './loops.ts';
import { machinePlanar } from './machine-planar.ts';
import { machineQuadric } from './machine-quadric.ts';
import { doubleDoubleMachine, intervalMachine } from './machines.ts';
import { momentQuadric } from './moment.ts';
import { momentPlanar } from './moment-planar.ts';
import { type Planar, planarOf } from './planar.ts';
import { type Quadric, quadricInTreeOrder, quadricOf } from './quadric.ts';
import { stableQuadric } from './stable.ts';
import { isAccelerated, type Target } from './target.ts';
import { textbookQuadric } from './textbook.ts';
import { textbookPlanar } from './textbook-planar.ts';
import { textbook32Quadric } from './textbook32.ts';
import { textbook32Planar } from './textbook32-planar.ts';
import { treeKernel } from './trees.ts';

/**
 * A method's answers for many rays at once: class and roots bit-equal to its `intersect`. The
 * fastest kernel that there is; by default `intersect`, asked ray by ray. Kernels are not a part of
 * a method, because a page that asks for one ray at a time is not to load them.
 *
 * @param target TypeScript, or SIMD where there is such a kernel and `accelerate()` has succeeded;
 *   absent: SIMD as long as the module is accelerated. `targetOf` tells which one it is.
 * @example
 * const certified = METHODS.find(({ id }) => id === 'certified')!;
 * const kernel = batchOf(certified, { kind: 'cylinder', center: [0, 0, 0], radius: 5 });
 * const out = createAnswers(1);
 * kernel.both(packRays([{ origin: [-10, 0, 3], direction: [1, 0, 0] }]), out);
 * [out.t0[0], out.t1[0]]; // → [6, 14]
 */
export function batchOf(method: Method, shape: Shape, target?: Target): Kernel {
  const kernel = KERNELS[method.id]?.(shape) ?? treeKernel(shape, method.intersect);
  return target === 'typescript' && hasSimd(method, shape) ? inTypeScript(kernel) : kernel;
}

/**
 * What the kernel that `batchOf` gives for the same runs as: 'simd' only where there is a SIMD
 * kernel and `accelerate()` has succeeded.
 *
 * @param target as for `batchOf`.
 * @example
 * const exact = METHODS.find(({ id }) => id === 'exact')!;
 * targetOf(exact, { kind: 'cylinder', center: [0, 0, 0], radius: 5 }, 'simd'); // → 'typescript'
 */
export const targetOf = (method: Method, shape: Shape, target?: Target): Target =>
  target !== 'typescript' && isAccelerated() && hasSimd(method, shape) ? 'simd' : 'typescript';

const hasSimd = (method: Method, shape: Shape): boolean =>
  method.id === 'certified' && quadricOf(shape) !== null;

/** The stages of `certified` in TypeScript, whatever batches go through otherwise. */
function inTypeScript(kernel: Kernel): Kernel {
  function slowly(ask: () => void): void {
    const before = useFastRoots(null);
    try {
      ask();
    } finally {
      useFastRoots(before);
    }
  }
  return {
    met: kernel.met,
    classes: (rays, out) => slowly(() => kernel.classes(rays, out)),
    first: (rays, tMin, tMax, out) => slowly(() => kernel.first(rays, tMin, tMax, out)),
    both: (rays, out) => slowly(() => kernel.both(rays, out)),
  };
}

/** For each method that has kernels of its own; null for a shape that they do not know. */
const KERNELS: Readonly<Record<string, (shape: Shape) => Kernel | null>> = {
  textbook32: kernelFor(textbook32Quadric, (p) => kernelOf('one', textbook32Planar(p))),
  textbook: kernelFor(textbookQuadric, textbookPlanar),
  stable: kernelFor(stableQuadric, textbookPlanar),
  moment: kernelFor(momentQuadric, (p) => kernelOf('one', momentPlanar(p))),
  compensated: kernelFor(
    (q) => machineQuadric(q, doubleDoubleMachine, 'course'),
    (p) => kernelOf('one', machinePlanar(p, doubleDoubleMachine, 'course')),
  ),
  interval: kernelFor(
    (q) => machineQuadric(q, intervalMachine, 'moment'),
    (p) => kernelOf('one', machinePlanar(p, intervalMachine, 'moment')),
  ),
  certified: kernelFor(certifiedKernel, certifiedPlanar, quadricOf),
  exact: exactKernel,
};

/** For the two groups of shapes whose numbers a kernel can take. */
function kernelFor(
  curved: (q: Quadric) => Kernel,
  flat: (p: Planar) => Kernel,
  numbers: (shape: Shape) => Quadric | null = quadricInTreeOrder,
): (shape: Shape) => Kernel | null {
  return (shape) => {
    const quadric = numbers(shape);
    if (quadric) return curved(quadric);
    const planar = planarOf(shape);
    return planar && flat(planar);
  };
}
