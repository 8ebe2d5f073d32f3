import type { Shape } from '../shapes/index.ts';
import type { Kernel } from './batch.ts';
import { kernelOf, type SolveRay } from './loops.ts';
import { type Planar, planarOf } from './planar.ts';
import { type Quadric, quadricOf } from './quadric.ts';

/** A rung's kernels for the two families of shapes, joined. Throws RangeError for a shape that is in neither table. */
export const kernelFor =
  (curved: (q: Quadric) => Kernel, flat: (p: Planar) => SolveRay) =>
  (shape: Shape): Kernel => {
    const quadric = quadricOf(shape);
    if (quadric) return curved(quadric);
    const planar = planarOf(shape);
    if (!planar) throw new RangeError(`no kernel for a ${shape.kind}`);
    return kernelOf('one', flat(planar));
  };
