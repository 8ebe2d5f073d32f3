import { createAnswers, packRays, verdictsOfRoots } from '../../../src/math/batch/batch.ts';
import { exactKernel } from '../../../src/math/batch/exact.ts';
import { nextDown, nextUp } from '../../../src/math/float/ulp.ts';
import { intersect } from '../../../src/math/intersect.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';

const out = createAnswers(1);

/** What certified gets wrong on this ray, in words, or null. */
export function disagreement(shape: Shape, ray: Ray): string | null {
  const kernel = exactKernel(shape);
  if (!kernel) return 'no exact kernel';
  kernel.both(packRays([ray]), out);
  const [verdict] = verdictsOfRoots(out, 1);
  const roots = [out.t0[0] as number, out.t1[0] as number].filter((t) => !Number.isNaN(t));
  const found = intersect(shape, ray, 'certified');
  const ts = found.hits.map(({ t }) => t);
  const wrong =
    found.class !== verdict ||
    ts.length !== roots.length ||
    ts.some((t, k) => !neighbours(t, roots[k] as number)) ||
    (ts.length === 2 && !((ts[0] as number) <= (ts[1] as number)));
  if (!wrong) return null;
  return `${JSON.stringify({ shape, ray })}: ${found.class} ${ts.map(String)} by ${found.decidedBy}, exactly ${verdict} ${roots.map(String)}`;
}

/**
 * A faithful root is the correctly rounded one or a neighbour of it. (That it is on the right side is left to the vectors, whose `faithful` has
 * both; and a root that is a double is checked there too.) The sign of zero counts.
 */
function neighbours(t: number, rounded: number): boolean {
  return Object.is(t, rounded) || (t !== 0 && (t === nextUp(rounded) || t === nextDown(rounded)));
}
