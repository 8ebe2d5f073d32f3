import type { Intersection } from '../intersection.ts';
import type { Ray } from '../ray.ts';
import type { Shape } from '../shapes/index.ts';
import { definitionOf } from '../shapes/lookup.ts';
import { type Answers, checkRay, type Kernel, type Rays, VERDICTS } from './batch.ts';
import { kernelOf } from './loops.ts';

/**
 * The kernel of a method for a shape without numbers: `intersect`, asked ray by ray. It makes an
 * object a ray, and costs what single rays cost.
 */
export function treeKernel(
  shape: Shape,
  intersect: (shape: Shape, ray: Ray) => Intersection,
): Kernel {
  const curved = definitionOf(shape).formula(shape).family === 'curved';
  return kernelOf(curved ? 'two' : 'one', (rays: Rays, i: number, out: Answers): number => {
    checkRay(rays, i, true, out);
    const found = intersect(shape, {
      origin: [rays.Ex[i] as number, rays.Ey[i] as number, rays.Ez[i] as number],
      direction: [rays.dx[i] as number, rays.dy[i] as number, rays.dz[i] as number],
    });
    const [near, far] = found.hits;
    out.t0[i] = near?.t ?? Number.NaN;
    out.t1[i] = far?.t ?? Number.NaN;
    return VERDICTS.indexOf(found.class);
  });
}
