import type { GlossBody, SurfaceMaterial } from './body.ts';

/** Phong 1975: the cosine between the mirrored light and the way back along the ray, to a power. */
export const body: GlossBody = {
  at: 'gloss',
  run(wave, lit, { materials }, all) {
    const [red, green, blue] = lit.light.colour;
    for (let k = 0; k < lit.count; k++) {
      const i = lit.ray[k] as number;
      const { shine, exponent, glossy } = materials[wave.surface[i] as number] as SurfaceMaterial;
      const reach = lit.reach[k] as number;
      if ((shine === 0 && !all) || reach === 0) continue;
      const twice = 2 * (lit.cosine[k] as number);
      const x = twice * (wave.Nx[i] as number) - (lit.Lx[k] as number);
      const y = twice * (wave.Ny[i] as number) - (lit.Ly[k] as number);
      const z = twice * (wave.Nz[i] as number) - (lit.Lz[k] as number);
      const { dx, dy, dz } = wave.rays;
      const back = -(x * (dx[i] as number) + y * (dy[i] as number) + z * (dz[i] as number));
      if (!(back > 0)) continue;
      const amount = shine * glossy * reach * Math.min(back, 1) ** exponent;
      wave.glossR[i] = (wave.glossR[i] as number) + amount * red * (lit.red[k] as number);
      wave.glossG[i] = (wave.glossG[i] as number) + amount * green * (lit.green[k] as number);
      wave.glossB[i] = (wave.glossB[i] as number) + amount * blue * (lit.blue[k] as number);
    }
  },
};
