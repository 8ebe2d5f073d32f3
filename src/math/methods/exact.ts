import { exact as exactArithmetic } from '../arithmetic/exact.ts';
import { textbookSolver } from './solvers.ts';
import { treeMethod } from './tree-method.ts';

export const exact = treeMethod(
  {
    id: 'exact',
    title: 'exact',
    idea:
      'The course’s formula in whole-number arithmetic on the stored doubles, rounded once ' +
      'at the end.',
    promise:
      'For every finite input: the class of exact arithmetic; roots, points and normals ' +
      'correctly rounded, ties to even, over the whole range of doubles.',
    source:
      'A double is m · 2^e, so A, B, C and D are too; roots, points and normals are (u + v√D)/w, ' +
      'whose sign and rounding are decided by whole numbers.',
  },
  exactArithmetic,
  textbookSolver,
  'exact',
);
