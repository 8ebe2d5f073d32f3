import type { LightBody } from './body.ts';
import { addShadowRay } from './shadow-rays.ts';

/** A shadow ray to each light without a size. */
export const body: LightBody = {
  at: 'light',
  run(wave, lit, tools, all) {
    if (lit.light.radius > 0 && !all) return;
    const shadowRays = tools.shadowRays(lit.count);
    for (let k = 0; k < lit.count; k++) {
      const i = lit.ray[k] as number;
      const distance = lit.distance[k] as number;
      const [x, y, z] = [lit.Lx[k] as number, lit.Ly[k] as number, lit.Lz[k] as number];
      addShadowRay(wave, i, shadowRays, x, y, z, distance);
    }
    tools.findBlockers(shadowRays, lit.light);
    // Lights with a size are left to soft shadows, also if shadows are forced on.
    if (lit.light.radius > 0) return;
    for (let k = 0; k < lit.count; k++) {
      if ((shadowRays.blocker[k] as number) >= 0) lit.reach[k] = 0;
    }
  },
};
