import { counted, defineEffect, needed, notNeeded } from './define.ts';

export const highlights = defineEffect({
  id: 'highlights',
  title: 'highlights',
  idea: 'A shiny surface shows each light as a bright spot where it would mirror it (Phong).',
  neededBy(scene) {
    const things = scene.things.filter(({ material }) => material.shine.strength > 0).length;
    if (things === 0) return notNeeded('nothing is shiny');
    if (scene.lights.length === 0) return notNeeded('there is no light');
    return needed(`${counted(things, 'shiny thing')}`);
  },
  load: () => import('./highlights-body.ts').then(({ body }) => body),
});
