import { defineEffect, needed, notNeeded } from '../../src/scene/effects/define.ts';
import { bodyValues, defineFields, valuesOf } from '../../src/scene/effects/fields.ts';

export const aura = defineFields('glow', 'material', {
  power: {
    type: 'number',
    label: 'glow',
    default: 0,
    range: [0, 1e6],
    slider: [0, 2],
    step: 0.1,
    unit: '',
  },
});

export const lamp = defineFields('glow', 'light', {
  feeds: {
    type: 'choice',
    label: 'glow',
    default: 'nothing',
    options: [
      ['nothing', 'feeds no glow'],
      ['glow', 'feeds the glow of things'],
    ],
  },
});

/** Whatever looks at a glowing thing sees more light than is there: it adds and dims nothing. */
export const glow = defineEffect({
  id: 'glow',
  title: 'glow',
  idea: 'A ray to a glowing thing gets light of the lights that feed it.',
  fields: [aura, lamp],
  neededBy: ({ things }) =>
    things.some(({ material }) => valuesOf(aura, material).power > 0)
      ? needed('something glows')
      : notNeeded('nothing glows'),
  load: () =>
    import('./toy-glow-body.ts').then(({ body }) => body(bodyValues(aura), bodyValues(lamp))),
});
