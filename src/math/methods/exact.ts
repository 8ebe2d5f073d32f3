import { exact as exactArithmetic } from '../arithmetic/exact.ts';
import type { Surd } from '../exact/surd.ts';
import { courseForm } from './forms.ts';
import { textbookSolver } from './solvers.ts';
import { coefficientsBy, intersectBy } from './tree-method.ts';
import type { TreeMethod } from './tree-parts.ts';

/**
 * The method that decides everything by whole numbers: what the others are compared with.
 *
 * @example
 * const ray = { origin: [1e8, 0, 1], direction: [-1, 0, 0] } as const;
 * exactMethod.intersect({ kind: 'sphere', center: [0, 0, 0], radius: 1 }, ray).class;
 * // → 'tangent'
 */
export const exact: TreeMethod<Surd> = {
  id: 'exact',
  title: 'exact',
  hint: 'whole numbers, rounded once',
  idea:
    'The course’s formula in whole-number arithmetic on the stored doubles, rounded once ' +
    'at the end.',
  promise:
    'For every finite input: the class of exact arithmetic; roots, points and normals ' +
    'correctly rounded, ties to even, over the whole range of doubles.',
  source:
    'A double is m · 2^e, so A, B, C and D are too; roots, points and normals are (u + v√D)/w, ' +
    'whose sign and rounding are decided by whole numbers.',
  proven: 'rounded',
  arithmetic: exactArithmetic,
  form: courseForm,
  solver: textbookSolver,
  decidedBy: 'exact',
  coefficients: (shape, ray) => coefficientsBy(exact, shape, ray),
  intersect: (shape, ray) => intersectBy(exact, shape, ray),
  parts: (use) => use(exact),
};
