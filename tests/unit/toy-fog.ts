import { defineEffect, needed, notNeeded } from '../../src/scene/effects/define.ts';
import { bodyValues, defineFields, valuesOf } from '../../src/scene/effects/fields.ts';

export const air = defineFields('fog', 'scene', {
  density: {
    type: 'number',
    label: 'fog density',
    default: 0,
    range: [0, 1000],
    slider: [0, 1],
    step: 0.01,
    unit: '1/length',
  },
  colour: { type: 'colour', label: 'fog colour', default: '#c8ccd0' },
});

/** T = e^(−density · distance) of the light gets through, 1 − T of the fog's colour is added. */
export const fog = defineEffect({
  id: 'fog',
  title: 'fog',
  idea: 'Along its way a ray loses light to the fog, and gets light of the fog’s colour.',
  fields: [air],
  neededBy: (scene) =>
    valuesOf(air, scene).density > 0 ? needed('the air is foggy') : notNeeded('the air is clear'),
  load: () => import('./toy-fog-body.ts').then(({ body }) => body(bodyValues(air))),
});
