import { isGlass } from '../facts.ts';
import { counted, defineEffect, leftOut, needed, notNeeded } from './define.ts';
import { bodyValues, defineFields, valuesOf } from './fields.ts';

const glass = defineFields('dispersion', 'material', {
  spread: {
    type: 'number',
    label: 'dispersion: index of blue above red by',
    default: 0,
    range: [0, 1],
    slider: [0, 0.2],
    step: 0.01,
    unit: '',
  },
});

export const dispersion = defineEffect({
  id: 'dispersion',
  title: 'dispersion',
  idea: 'Glass bends blue more than red: each of the three colours goes its own way.',
  fields: [glass],
  rays: { reflected: 'red and blue, by glass', refracted: 'red and blue, apart' },
  neededBy({ things }) {
    const all = things.filter(isGlass);
    const spreads = all.filter(({ material }) => valuesOf(glass, material).spread > 0).length;
    if (spreads > 0)
      return needed(`${counted(spreads, 'thing')} of glass with an index for each colour`);
    if (all.length === 0) return notNeeded('no material is glass');
    if (all.every(({ material }) => material.glass?.index === 1))
      return notNeeded('the glass bends no light');
    return leftOut('glass has one index for all colours: a simplification');
  },
  load: () => import('./dispersion-body.ts').then(({ body }) => body(bodyValues(glass))),
});
