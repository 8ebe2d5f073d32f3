import { counted, defineEffect, needed, notNeeded } from './define.ts';

export const reflection = defineEffect({
  id: 'reflection',
  title: 'reflection',
  idea: 'From a mirror a ray goes on, at the same angle on the other side of the normal.',
  rays: { reflected: 'by mirrors' },
  neededBy(scene) {
    const mirrors = scene.things.filter(({ material }) => material.mirror > 0).length;
    if (mirrors === 0) return notNeeded('no material is a mirror');
    return needed(`${counted(mirrors, 'thing')} of mirror`);
  },
  load: () => import('./reflection-body.ts').then(({ body }) => body),
});
