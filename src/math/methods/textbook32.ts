import { float32 } from '../arithmetic/float32.ts';
import { courseForm } from './forms.ts';
import { textbookSolver } from './solvers.ts';
import { coefficientsBy, intersectBy } from './tree-method.ts';
import type { TreeMethod } from './tree-parts.ts';

export const textbook32: TreeMethod<number> = {
  id: 'textbook32',
  title: 'textbook, float32',
  hint: 'every step with 24 bits',
  idea:
    'The course’s formula with every number and every operation rounded to 24 bits, as on ' +
    'a graphics card.',
  promise:
    'None: the class and about seven digits at best, and only within 1e-38 … 3e38 for every ' +
    'intermediate result; overflow is undecided. The ray and the shape are rounded first, so ' +
    'it may answer for a neighbouring ray.',
  source: 'The course; Math.fround, ECMA-262; Figueroa 1995 on double rounding.',
  arithmetic: float32,
  form: courseForm,
  solver: textbookSolver,
  decidedBy: 'formula',
  coefficients: (shape, ray) => coefficientsBy(textbook32, shape, ray),
  intersect: (shape, ray) => intersectBy(textbook32, shape, ray),
  parts: (use) => use(textbook32),
};
