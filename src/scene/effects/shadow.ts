import { blocks, whyNoShadow } from '../facts.ts';
import { counted, defineEffect, leftOut, needed, notNeeded } from './define.ts';

export const shadow = defineEffect({
  id: 'shadow',
  title: 'shadows',
  idea: 'Before a light is counted, a ray to it asks whether anything stands in between.',
  rays: { shadow: 'to lights without size' },
  neededBy(scene) {
    const lights = scene.lights.filter(({ light }) => light !== 'sphere').length;
    if (scene.lights.length === 0) return notNeeded('there is no light');
    if (lights === 0) return notNeeded('every light has a size: its shadows are soft');
    const why = whyNoShadow(scene);
    if (why) return (why.glass ? leftOut : notNeeded)(why.reason);
    const things = scene.things.filter(blocks).length;
    const can = things === 1 ? 'can stand in its own light' : 'can stand in the way';
    return needed(`${counted(lights, 'light')} without size; ${counted(things, 'thing')} ${can}`);
  },
  load: () => import('./shadow-body.ts').then(({ body }) => body),
});
