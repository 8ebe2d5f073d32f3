import { type DoubleDouble, doubleDouble } from '../arithmetic/double-double.ts';
import { courseForm } from './forms.ts';
import { stableSolver } from './solvers.ts';
import { coefficientsBy, intersectBy } from './tree-method.ts';
import type { TreeMethod } from './tree-parts.ts';

export const compensated: TreeMethod<DoubleDouble> = {
  id: 'compensated',
  title: 'compensated',
  hint: 'A, B, C, D with 106 bits',
  idea:
    'A, B, C, D and the roots in double-double: each number is a sum of two doubles, the ' +
    'second one the error of the first.',
  promise:
    'What loses up to half of its digits in float64 keeps all of them here; an exact tangent ' +
    'or generator with long fractions is still a matter of luck. Every product must lie ' +
    'between 2^-968 and 2^1020: above, the answer is undecided; below, digits are lost in ' +
    'silence.',
  source:
    'Dekker 1971; Knuth, TAOCP 2, 4.2.2; error bounds by Joldes, Muller, Popescu 2017, Tight ' +
    'and rigorous error bounds for basic building blocks of double-word arithmetic.',
  get arithmetic() {
    return doubleDouble();
  },
  form: courseForm,
  solver: stableSolver,
  decidedBy: 'double-double',
  coefficients: (shape, ray) => coefficientsBy(compensated, shape, ray),
  intersect: (shape, ray) => intersectBy(compensated, shape, ray),
  parts: (use) => use(compensated),
};
