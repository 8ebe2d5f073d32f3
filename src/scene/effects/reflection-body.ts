import type { BounceBody, SurfaceMaterial } from './body.ts';
import { mirrored, weightOf } from './bounce.ts';

export const body: BounceBody = {
  at: 'bounce',
  run(wave, { materials }, tools, all) {
    const next = tools.next(wave.hitCount);
    const before = next.count;
    for (let h = 0; h < wave.hitCount; h++) {
      const i = wave.hits[h] as number;
      const { mirror } = materials[wave.surface[i] as number] as SurfaceMaterial;
      // Forced where nothing is a mirror: one ray of weight 0 for each camera ray that hits.
      const goes = mirror > 0 ? tools.worth(mirror * weightOf(wave, i)) : all && wave.depth === 0;
      if (goes) mirrored(wave, i, next, mirror);
    }
    tools.fired('reflected', next.count - before);
  },
};
