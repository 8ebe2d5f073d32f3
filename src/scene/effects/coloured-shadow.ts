import { isColouredGlass, isLit } from '../facts.ts';
import { counted, defineEffect, leftOut, needed, notNeeded } from './define.ts';
import { bodyValues, defineFields, valuesOf } from './fields.ts';

const world = defineFields('coloured-shadow', 'scene', {
  light: {
    type: 'choice',
    label: 'light through coloured glass',
    default: 'undimmed',
    options: [
      ['undimmed', 'passes undimmed'],
      ['dimmed', 'fades on the way'],
    ],
  },
});

export const colouredShadow = defineEffect({
  id: 'coloured-shadow',
  title: 'coloured shadows',
  idea:
    'Light on its way through coloured glass fades as e^(−σ · chord), so the glass casts a ' +
    'shadow of its colour.',
  fields: [world],
  rays: { shadow: 'through coloured glass' },
  neededBy(scene) {
    const glass = scene.things.filter(isColouredGlass).length;
    if (glass === 0) return notNeeded('no glass is coloured');
    if (scene.lights.length === 0) return notNeeded('there is no light');
    if (!scene.things.some(isLit)) return notNeeded('nothing shows light');
    if (valuesOf(world, scene).light === 'undimmed')
      return leftOut('light passes coloured glass undimmed: a simplification');
    return needed(`${counted(glass, 'thing')} of coloured glass before a light`);
  },
  load: () => import('./coloured-shadow-body.ts').then(({ body }) => body(bodyValues(world))),
});
