import { fresnel } from '../optics.ts';
import type { BounceBody, SurfaceMaterial, Wave } from './body.ts';
import { bent, cosineOf, mirrored } from './bounce.ts';

const COLOURS = ['red', 'green', 'blue'] as const;

/**
 * Fires what glass makes of red and blue, each by its own index, and takes them from the ray, so
 * that refraction, which comes next, has green alone to fire.
 */
export const body = (
  glassOf: (material: SurfaceMaterial) => { readonly spread: number },
): BounceBody => ({
  at: 'bounce',
  run(wave, { materials }, tools, all) {
    const next = tools.next(4 * wave.hitCount);
    const fired = { reflected: 0, refracted: 0 };
    /** Leaves a ray nothing but the colour; its weight was that of the whole ray. */
    const keep = (j: number, colour: 'red' | 'blue'): void => {
      for (const other of COLOURS) if (other !== colour) next[other][j] = 0;
    };
    const fire = (i: number, colour: 'red' | 'blue', index: number, share: number): void => {
      const cosine = cosineOf(wave, i);
      const eta = wave.back[i] === 1 ? index : 1 / index;
      const back = fresnel(eta, cosine);
      const weight = share * (wave[colour][i] as number);
      if (weight === 0) return;
      if (back > 0 && tools.worth(back * weight)) {
        keep(mirrored(wave, i, next, share * back), colour);
        fired.reflected += 1;
      }
      if (back < 1 && tools.worth((1 - back) * weight)) {
        keep(bent(wave, i, next, share * (1 - back), eta, cosine), colour);
        fired.refracted += 1;
      }
    };
    for (let h = 0; h < wave.hitCount; h++) {
      const i = wave.hits[h] as number;
      const material = materials[wave.surface[i] as number] as SurfaceMaterial;
      const { index, mirror, shine } = material;
      const { spread } = glassOf(material);
      if (index === 0 || spread === 0) {
        // Forced where nothing disperses: one ray of weight 0 for each camera ray that hits.
        if (all && wave.depth === 0) {
          mirrored(wave, i, next, 0);
          fired.reflected += 1;
        }
        continue;
      }
      const share = (1 - mirror) * (1 - shine);
      fire(i, 'red', Math.max(1, index - spread / 2), share);
      fire(i, 'blue', index + spread / 2, share);
      take(wave, i);
    }
    tools.fired('reflected', fired.reflected);
    tools.fired('refracted', fired.refracted);
  },
});

function take(wave: Wave, i: number): void {
  wave.red[i] = 0;
  wave.blue[i] = 0;
}
