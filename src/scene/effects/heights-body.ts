import { dropStart } from '../drop-start.ts';
import type { RootsBody } from './body.ts';

export const body: RootsBody = {
  at: 'roots',
  choose(rays, out, { low, high, isKept, rounding }, tMin, leaving) {
    const { t0, t1 } = out;
    if (leaving) dropStart(out, rays.count);
    const { Ey, dy } = rays;

    function isThere(i: number, root: 0 | 1, t: number): boolean {
      const e = Ey[i] as number;
      const step = t * (dy[i] as number);
      const y = e + step;
      const near = rounding * (Math.abs(e) + Math.abs(step));
      // Asking the math module is dear. A missing root is NaN: each comparison is false for it.
      if (isKept && (Math.abs(y - low) <= near || Math.abs(y - high) <= near)) {
        return isKept(rays, i, root, t);
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
