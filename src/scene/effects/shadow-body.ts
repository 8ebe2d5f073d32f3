import type { LightBody } from './body.ts';

/** A shadow ray to each light without a size. */
export const body: LightBody = {
  at: 'light',
  run(wave, lit, tools, all) {
    if (lit.light.radius > 0 && !all) return;
    const feelers = tools.feelers(lit.count);
    const { rays } = feelers;
    for (let k = 0; k < lit.count; k++) {
      const i = lit.ray[k] as number;
      rays.Ex[k] = wave.Px[i] as number;
      rays.Ey[k] = wave.Py[i] as number;
      rays.Ez[k] = wave.Pz[i] as number;
      rays.dx[k] = lit.Lx[k] as number;
      rays.dy[k] = lit.Ly[k] as number;
      rays.dz[k] = lit.Lz[k] as number;
      feelers.limit[k] = lit.distance[k] as number;
      feelers.from[k] = wave.surface[i] as number;
      feelers.node[k] = wave.node[i] as number;
    }
    feelers.count = lit.count;
    tools.feel(feelers, lit.light);
    // Lights with a size are left to soft shadows, also if shadows are forced on.
    if (lit.light.radius > 0) return;
    for (let k = 0; k < lit.count; k++) {
      if ((feelers.blocker[k] as number) >= 0) lit.reach[k] = 0;
    }
  },
};
