import { dropStart } from '../start.ts';
import type { RootsBody } from './body.ts';

/**
 * A height computed here is off by a few roundings of its terms, and by those of a root that is
 * not exact. Nearer to an end than this part of the terms, the math module is asked.
 */
const NEAR = 2 ** -20;

export const body: RootsBody = {
  at: 'roots',
  choose(rays, out, { low, high, isKept }, tMin, leaving) {
    const { t0, t1 } = out;
    if (leaving) dropStart(out, rays.count);
    const { Ey, dy } = rays;

    function isThere(i: number, root: 0 | 1, t: number): boolean {
      const e = Ey[i] as number;
      const step = t * (dy[i] as number);
      const y = e + step;
      const near = NEAR * (Math.abs(e) + Math.abs(step));
      // A missing root is NaN, for which each comparison is false.
      if (isKept && (Math.abs(y - low) <= near || Math.abs(y - high) <= near)) {
        return isKept(rays, i, root);
      }
      return y >= low && y <= high;
    }

    for (let i = 0; i < rays.count; i++) {
      const near = t0[i] as number;
      const far = t1[i] as number;
      if (near >= tMin && isThere(i, 0, near)) continue;
      t0[i] = far >= tMin && isThere(i, 1, far) ? far : Number.NaN;
    }
  },
};
