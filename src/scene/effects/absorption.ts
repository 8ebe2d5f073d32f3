import { isColouredGlass, isGlass } from '../facts.ts';
import { counted, defineEffect, needed, notNeeded } from './define.ts';

export const absorption = defineEffect({
  id: 'absorption',
  title: 'absorption',
  idea:
    'Along its chord through coloured glass light fades as e^(−σ · chord), each colour with ' +
    'its own σ.',
  neededBy(scene) {
    const glass = scene.things.filter(isGlass);
    const coloured = glass.filter(isColouredGlass);
    if (glass.length === 0) return notNeeded('no material is glass');
    if (coloured.length === 0) return notNeeded('the glass is clear');
    return needed(`${counted(coloured.length, 'thing')} of coloured glass`);
  },
  load: () => import('./absorption-body.ts').then(({ body }) => body),
});
