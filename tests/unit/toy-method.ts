import { float64 } from '../../src/math/arithmetic/float64.ts';
import { momentForm } from '../../src/math/methods/forms.ts';
import { textbookSolver } from '../../src/math/methods/solvers.ts';
import { treeMethod } from '../../src/math/methods/tree-method.ts';

/**
 * A method that is not Graze's own, as a newcomer would add it: a form and a solver that no method
 * combines.
 */
export const momentTextbook = treeMethod(
  {
    id: 'moment-textbook',
    title: 'moment, textbook root',
    idea: 'D from the moment of the ray, the roots by the textbook formula.',
    promise: 'As moment where it is hit at all; the smaller root loses digits as textbook does.',
    source: 'Both halves are those of methods of Graze; together they are only tested.',
  },
  float64,
  textbookSolver,
  'formula',
  momentForm,
);
