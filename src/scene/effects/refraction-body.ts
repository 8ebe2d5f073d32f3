import { fresnel } from '../optics.ts';
import type { BounceBody, SurfaceMaterial } from './body.ts';
import { bent, cosineOf, mirrored, weightOf } from './bounce.ts';

export const body: BounceBody = {
  at: 'bounce',
  run(wave, { materials }, tools, all) {
    const next = tools.next(2 * wave.hitCount);
    let reflected = 0;
    let refracted = 0;
    for (let h = 0; h < wave.hitCount; h++) {
      const i = wave.hits[h] as number;
      const { index, mirror, shine } = materials[wave.surface[i] as number] as SurfaceMaterial;
      const forced = index === 0 && all && wave.depth === 0;
      if (index === 0 && !forced) continue;
      const share = forced ? 0 : (1 - mirror) * (1 - shine);
      const inside = wave.back[i] === 1;
      const eta = forced ? 1 : inside ? index : 1 / index;
      const cosine = cosineOf(wave, i);
      const back = fresnel(eta, cosine);
      const weight = share * weightOf(wave, i);
      // Nothing is left of a ray whose colour dispersion has fired.
      if (weight === 0 && !forced) continue;
      if (back > 0 && share > 0 && tools.worth(back * weight)) {
        mirrored(wave, i, next, share * back);
        reflected += 1;
      }
      if (back < 1 && (forced || (share > 0 && tools.worth((1 - back) * weight)))) {
        bent(wave, i, next, share * (1 - back), eta, cosine);
        refracted += 1;
      }
    }
    tools.fired('reflected', reflected);
    tools.fired('refracted', refracted);
  },
};
