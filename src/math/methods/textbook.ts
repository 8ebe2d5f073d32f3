import { float64 } from '../arithmetic/float64.ts';
import { ONE_RAY } from '../batch/generated/textbook-one.ts';
import { direct } from './direct.ts';
import { textbookSolver } from './solvers.ts';
import { treeMethod } from './tree-method.ts';

/** By its trees: what the fast form is tested against. */
export const textbookByTrees = treeMethod(
  {
    id: 'textbook',
    title: 'textbook',
    hint: '(−B ± √D) / 2A with 53 bits',
    idea: 't = (−B ± √D) / 2A, just as the course writes it, every operation rounded to a double.',
    promise:
      'None: the class and the digits are what float64 makes of the formula. It loses hits far ' +
      'away and digits where B and √D or B² and 4AC nearly cancel.',
    source: 'The course; Hearn & Baker, Computer Graphics, section on ray tracing.',
  },
  float64,
  textbookSolver,
  'formula',
);

export const textbook = direct(textbookByTrees, ONE_RAY);
