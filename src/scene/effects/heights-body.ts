import { dropStart } from '../start.ts';
import type { RootsBody } from './body.ts';

export const body: RootsBody = {
  at: 'roots',
  choose(rays, out, low, high, tMin, leaving) {
    const { t0, t1 } = out;
    if (leaving) dropStart(out, rays.count);
    const { Ey, dy } = rays;
    for (let i = 0; i < rays.count; i++) {
      const near = t0[i] as number;
      const far = t1[i] as number;
      const e = Ey[i] as number;
      const d = dy[i] as number;
      const yNear = e + near * d;
      const yFar = e + far * d;
      // A missing root is NaN, for which each comparison is false.
      if (near >= tMin && yNear >= low && yNear <= high) continue;
      t0[i] = far >= tMin && yFar >= low && yFar <= high ? far : Number.NaN;
    }
  },
};
