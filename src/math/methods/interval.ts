import { type Interval, interval as intervalArithmetic } from '../arithmetic/interval.ts';
import { momentForm } from './forms.ts';
import { stableSolver } from './solvers.ts';
import { coefficientsBy, intersectBy } from './tree-method.ts';
import type { TreeMethod } from './tree-parts.ts';

export const interval: TreeMethod<Interval> = {
  id: 'interval',
  title: 'interval',
  hint: 'a bound below and above each step',
  idea:
    'The moment form with a lower and an upper bound for every number, rounded outwards: ' +
    'it knows what it does not know.',
  promise:
    'For every finite input: a class that it gives is the right one; where its bounds leave ' +
    'room for another, it answers undecided. Every number it shows is the middle of an ' +
    'interval that holds the exact one.',
  source:
    'Moore 1966, Interval analysis; Pharr, Jakob, Humphreys, Physically based rendering 4, ' +
    'section 6.8 (pbrt rejects an uncertain hit, here it is named).',
  get arithmetic() {
    return intervalArithmetic();
  },
  form: momentForm,
  solver: stableSolver,
  decidedBy: 'formula',
  coefficients: (shape, ray) => coefficientsBy(interval, shape, ray),
  intersect: (shape, ray) => intersectBy(interval, shape, ray),
  parts: (use) => use(interval),
};
