import type { LightBody, SurfaceMaterial, World } from './body.ts';
import { addShadowRay } from './shadow-rays.ts';

/**
 * A ray to each light, straight through all glass: of a lamp with a size, to its middle. What its
 * chords leave of each colour arrives.
 */
export const body = (worldOf: (world: World) => { readonly light: string }): LightBody => ({
  at: 'light',
  run(wave, lit, tools, all, world) {
    // Forced on where light passes undimmed: its rays are followed, and all of it arrives.
    const fades = worldOf(world).light === 'dimmed';
    if (!fades && !all) return;
    const shadowRays = tools.shadowRays(lit.count);
    const hits = new Int32Array(lit.count);
    for (let k = 0; k < lit.count; k++) {
      if ((lit.reach[k] as number) === 0) continue;
      hits[shadowRays.count] = k;
      const [x, y, z] = [lit.Lx[k] as number, lit.Ly[k] as number, lit.Lz[k] as number];
      addShadowRay(wave, lit.ray[k] as number, shadowRays, x, y, z, lit.distance[k] as number);
    }
    const chords = tools.through(shadowRays, lit.light);
    if (!fades) return;
    for (const { surface, lengths } of chords) {
      const { absorption } = world.materials[surface] as SurfaceMaterial;
      for (let j = 0; j < shadowRays.count; j++) {
        const chord = lengths[j] as number;
        if (chord === 0) continue;
        const k = hits[j] as number;
        lit.red[k] = (lit.red[k] as number) * Math.exp(-absorption[0] * chord);
        lit.green[k] = (lit.green[k] as number) * Math.exp(-absorption[1] * chord);
        lit.blue[k] = (lit.blue[k] as number) * Math.exp(-absorption[2] * chord);
      }
    }
  },
});
