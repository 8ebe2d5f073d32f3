import type { Intersection } from '../intersection.ts';
import type { Ray } from '../ray.ts';
import type { Shape } from '../shapes/index.ts';
import type { Kernel } from './batch.ts';
import { kernelOf, type SolveRay } from './loops.ts';
import { type Planar, planarOf } from './planar.ts';
import { type Quadric, quadricInTreeOrder } from './quadric.ts';
import { treeKernel } from './trees.ts';

/** A method's kernels for the two families of shapes; any other shape is served by `intersect`. */
export const kernelFor =
  (
    intersect: (shape: Shape, ray: Ray) => Intersection,
    curved: (q: Quadric) => Kernel,
    flat: (p: Planar) => SolveRay,
  ) =>
  (shape: Shape): Kernel => {
    const quadric = quadricInTreeOrder(shape);
    if (quadric) return curved(quadric);
    const planar = planarOf(shape);
    return planar ? kernelOf('one', flat(planar)) : treeKernel(shape, intersect);
  };
