import { counted, defineEffect, needed, notNeeded } from './define.ts';

export const pattern = defineEffect({
  id: 'pattern',
  title: 'patterns',
  idea: 'Where the surface is hit decides its colour: cubes or slices of space in two colours.',
  neededBy(scene) {
    const things = scene.things.filter(({ material }) => material.paint.pattern !== 'plain').length;
    if (things === 0) return notNeeded('every paint is plain');
    return needed(`${counted(things, 'thing')} with checker or stripes`);
  },
  load: () => import('./pattern-body.ts').then(({ body }) => body),
});
