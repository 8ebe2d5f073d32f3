import { float64 } from '../arithmetic/float64.ts';
import { ONE_RAY } from '../batch/generated/stable-one.ts';
import { lazily } from '../lazily.ts';
import { intersectByPieces } from './by-pieces.ts';
import type { Method } from './define.ts';
import { courseForm } from './forms.ts';
import { stableSolver } from './solvers.ts';
import { coefficientsBy, intersectBy } from './tree-method.ts';
import type { TreeMethod } from './tree-parts.ts';

/** The method by its trees, with which tests compare the faster one. */
export const stableByTrees: TreeMethod<number> = {
  id: 'stable',
  title: 'stable root',
  hint: 'q = −(B ± √D)/2, then q/A and C/q',
  idea: 'q = −(B ± √D)/2 with the sign that adds, then t = q/A and t = C/q.',
  promise:
    'From the same A, B, C and D as textbook, no digit is lost in the root formula. What A, B, ' +
    'C and D have lost stays lost. For B = 0 both signs add, and −d, which turns the roots ' +
    'around, may change their last bit.',
  source:
    'Forsythe 1970, Pitfalls in computation, or why a math book is not enough; Press et al., ' +
    'Numerical Recipes, section 5.6.',
  arithmetic: float64,
  form: courseForm,
  solver: stableSolver,
  decidedBy: 'formula',
  coefficients: (shape, ray) => coefficientsBy(stableByTrees, shape, ray),
  intersect: (shape, ray) => intersectBy(stableByTrees, shape, ray),
  parts: (use) => use(stableByTrees),
};

const intersectFast = lazily(() => intersectByPieces(stableByTrees, ONE_RAY));

export const stable: Method = {
  ...stableByTrees,
  intersect: (shape, ray) => intersectFast()(shape, ray),
};
