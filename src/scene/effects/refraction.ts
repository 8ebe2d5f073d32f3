import { isGlass } from '../facts.ts';
import { counted, defineEffect, needed, notNeeded } from './define.ts';

export const refraction = defineEffect({
  id: 'refraction',
  title: 'refraction',
  idea:
    'At glass a ray is bent (Snell) and a part of it is sent back (Fresnel): all of it ' +
    'beyond the critical angle.',
  rays: { reflected: 'by glass (Fresnel), under refraction' },
  neededBy(scene) {
    const things = scene.things.filter(isGlass).length;
    if (things === 0) return notNeeded('no material is glass');
    return needed(`${counted(things, 'thing')} of glass`);
  },
  load: () => import('./refraction-body.ts').then(({ body }) => body),
});
