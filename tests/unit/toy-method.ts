import { float64 } from '../../src/math/arithmetic/float64.ts';
import { momentForm } from '../../src/math/methods/forms.ts';
import { textbookSolver } from '../../src/math/methods/solvers.ts';
import { coefficientsBy, intersectBy } from '../../src/math/methods/tree-method.ts';
import type { TreeMethod } from '../../src/math/methods/tree-parts.ts';

/**
 * A method that is not Graze's own, as a newcomer would add it: a form and a solver that no method
 * combines.
 */
export const momentTextbook: TreeMethod<number> = {
  id: 'moment-textbook',
  title: 'moment, textbook root',
  idea: 'D from the moment of the ray, the roots by the textbook formula.',
  promise: 'As moment where it is hit at all; the smaller root loses digits as textbook does.',
  source: 'Both halves are those of methods of Graze; together they are only tested.',
  arithmetic: float64,
  form: momentForm,
  solver: textbookSolver,
  decidedBy: 'formula',
  coefficients: (shape, ray) => coefficientsBy(momentTextbook, shape, ray),
  intersect: (shape, ray) => intersectBy(momentTextbook, shape, ray),
  parts: (use) => use(momentTextbook),
};
