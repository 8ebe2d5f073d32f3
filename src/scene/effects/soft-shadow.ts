import { whyNoShadow } from '../facts.ts';
import { counted, defineEffect, leftOut, needed, notNeeded } from './define.ts';

export const softShadow = defineEffect({
  id: 'soft-shadow',
  title: 'soft shadows',
  idea:
    'Rays to many points of a light that has a size: the share of them that arrives is the ' +
    'light.',
  rays: { shadow: 'to lights with a size' },
  neededBy(scene) {
    const lights = scene.lights.filter(({ light }) => light === 'sphere').length;
    if (scene.lights.length === 0) return notNeeded('there is no light');
    if (lights === 0) return notNeeded('no light has a size');
    const why = whyNoShadow(scene);
    if (why) return (why.glass ? leftOut : notNeeded)(why.reason);
    return needed(`${counted(lights, 'light')} with a size`);
  },
  load: () => import('./soft-shadow-body.ts').then(({ body }) => body),
});
