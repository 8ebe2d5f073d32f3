import { float64 } from '../arithmetic/float64.ts';
import { ONE_RAY } from '../batch/generated/textbook-one.ts';
import { lazily } from '../lazily.ts';
import { intersectByPieces } from './by-pieces.ts';
import type { Method } from './define.ts';
import { courseForm } from './forms.ts';
import { textbookSolver } from './solvers.ts';
import { coefficientsBy, intersectBy } from './tree-method.ts';
import type { TreeMethod } from './tree-parts.ts';

/** The method by its trees, with which tests compare the faster one. */
export const textbookByTrees: TreeMethod<number> = {
  id: 'textbook',
  title: 'textbook',
  hint: '(−B ± √D) / 2A with 53 bits',
  idea: 't = (−B ± √D) / 2A, just as the course writes it, every operation rounded to a double.',
  promise:
    'None: the class and the digits are what float64 makes of the formula. It loses hits far ' +
    'away and digits where B and √D or B² and 4AC nearly cancel.',
  source: 'The course; Hearn & Baker, Computer Graphics, section on ray tracing.',
  arithmetic: float64,
  form: courseForm,
  solver: textbookSolver,
  decidedBy: 'formula',
  coefficients: (shape, ray) => coefficientsBy(textbookByTrees, shape, ray),
  intersect: (shape, ray) => intersectBy(textbookByTrees, shape, ray),
  parts: (use) => use(textbookByTrees),
};

const intersectFast = lazily(() => intersectByPieces(textbookByTrees, ONE_RAY));

export const textbook: Method = {
  ...textbookByTrees,
  intersect: (shape, ray) => intersectFast()(shape, ray),
};
