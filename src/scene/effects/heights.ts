import { counted, defineEffect, needed, notNeeded } from './define.ts';

export const heights = defineEffect({
  id: 'heights',
  title: 'finite heights',
  idea: 'Of both roots the first whose point lies between the two heights counts.',
  neededBy(scene) {
    const things = scene.things.filter(({ between }) => between).length;
    if (things === 0) return notNeeded('no shape is cut off');
    return needed(`${counted(things, 'thing')} between two heights`);
  },
  load: () => import('./heights-body.ts').then(({ body }) => body),
});
