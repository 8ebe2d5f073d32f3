import { counted, defineEffect, leftOut, needed, notNeeded } from './define.ts';
import { bodyValues, defineFields, valuesOf } from './fields.ts';

const lamp = defineFields('fall-off', 'light', {
  full: {
    type: 'number',
    label: 'falls off from',
    default: 0,
    range: [0, 1e6],
    slider: [0, 20],
    step: 0.1,
    unit: 'length',
  },
});

/** A lamp has its full strength up to a distance, and beyond it falls as the square. */
export const fallOff = defineEffect({
  id: 'fall-off',
  title: 'fall-off with distance',
  idea: 'A lamp twice as far away lights a fourth: its light is spread over four times the area.',
  fields: [lamp],
  neededBy({ lights }) {
    const lamps = lights.filter(({ light }) => light !== 'sun');
    const falling = lamps.filter((light) => valuesOf(lamp, light).full > 0).length;
    if (falling > 0) return needed(`${counted(falling, 'lamp')} with a distance to fall off from`);
    if (lights.length === 0) return notNeeded('there is no light');
    if (lamps.length === 0) return notNeeded('a sun is as strong everywhere');
    const one = lamps.length === 1 ? 'the lamp is' : 'lamps are';
    return leftOut(`${one} as strong far away as near: a simplification`);
  },
  load: () => import('./fall-off-body.ts').then(({ body }) => body(bodyValues(lamp))),
});
