import { exact as exactly } from '../../../src/math/arithmetic/exact.ts';
import {
  createAnswers,
  packRays,
  verdictsOfClasses,
  verdictsOfRoots,
} from '../../../src/math/batch/batch.ts';
import { batchOf } from '../../../src/math/batch/kernels.ts';
import { bracket } from '../../../src/math/exact/faithful.ts';
import type { Surd } from '../../../src/math/exact/surd.ts';
import type { Question } from '../../../src/math/families.ts';
import { intersect } from '../../../src/math/intersect.ts';
import type { Hit } from '../../../src/math/intersection.ts';
import { certified } from '../../../src/math/methods/certified.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { type ExactHit, exactHits, faithful, straight } from './exact-hits.ts';

const out = createAnswers(1);

/**
 * What certified gets wrong on this ray, in words, or null: as an object, in a batch by roots, and
 * in a batch by class only. Each root must be one of the doubles around the exact one.
 */
export function disagreement(shape: Shape, ray: Ray, truth = exactHits(shape, ray)): string | null {
  const found = intersect(shape, ray, 'certified');
  const kernel = batchOf(certified, shape);
  if (!kernel) return `no kernel for ${shape.kind}`;
  const rays = packRays([ray]);
  kernel.classes(rays, out);
  const [byClass] = verdictsOfClasses(out, 1, kernel.met);
  kernel.both(rays, out);
  const [byRoots] = verdictsOfRoots(out, 1);
  const object = found.hits.map(({ t }) => t);
  const batch = [out.t0[0] as number, out.t1[0] as number].filter((t) => !Number.isNaN(t));
  const right =
    found.class === truth.class &&
    byClass === truth.class &&
    byRoots === truth.class &&
    allFaithful(object, truth.hits) &&
    allFaithful(batch, truth.hits);
  if (right) return null;
  return (
    `${JSON.stringify({ shape, ray })}: object ${found.class} ${object.map(String)} by ` +
    `${found.decidedBy}, batch ${byClass} ${byRoots} ${batch.map(String)}, exactly ` +
    `${truth.class} ${truth.hits.map(({ t }) => bracket(t).join(' … '))}`
  );
}

const allFaithful = (ts: readonly number[], truth: readonly ExactHit[]): boolean =>
  ts.length === truth.length &&
  ts.every((t, k) => faithful((truth[k] as ExactHit).t, t)) &&
  (ts.length < 2 || (ts[0] as number) <= (ts[1] as number));

/**
 * The hits whose point is not faithful in each coordinate, or whose normal points elsewhere or is
 * not exactly zero where it must be. Where a normal leaves the doubles it has no way to keep: then
 * each component is one of the doubles around the exact one.
 */
export function misplaced({ shape, ray }: Question, truth = exactHits(shape, ray)): Hit[] {
  return intersect(shape, ray, 'certified').hits.filter(({ point, normal, singular }, k) => {
    const hit = truth.hits[k] as ExactHit;
    const zero = hit.normal.every((n) => exactly.sign(n) === 0);
    const inRange = normal.every(Number.isFinite) && Math.hypot(...normal) > 1e-290;
    const upright = zero
      ? normal.every((n) => Object.is(n, 0))
      : inRange
        ? straight(hit.normal, normal)
        : normal.every((n, i) => faithful(hit.normal[i] as Surd, n));
    return (
      !point.every((x, i) => faithful(hit.point[i] as Surd, x)) || singular !== zero || !upright
    );
  });
}
