import { norm, times, vec } from '../../math/formula.ts';
import { isNumber, isScalar, rewrite } from '../rewrite.ts';
import { ofCurved, ofRules } from './define.ts';

export const fourLost = ofCurved(
  {
    id: 'b2-ac',
    says: 'B² − AC in place of B² − 4AC',
    line: 'D',
    remedy: 'With B itself the discriminant is B² − 4AC; b² − AC belongs to b = B/2.',
  },
  ({ D }) => ({
    D: rewrite(D, (e) =>
      e.op === 'product' && isNumber(e.factors[0], 4)
        ? { ...e, factors: e.factors.slice(1) }
        : null,
    ),
  }),
);

export const fourAdded = ofCurved(
  {
    id: 'b2-plus-4ac',
    says: 'B² + 4AC in place of B² − 4AC',
    line: 'D',
    remedy: 'Watch the signs: when AC is negative, −4AC is positive.',
  },
  ({ D }) => ({
    D: D.op === 'sum' ? { ...D, terms: D.terms.map((term) => ({ ...term, sign: 1 as const })) } : D,
  }),
);

export const dividedByA = ofCurved(
  {
    id: 'over-a',
    says: '(−B ± √D)/A in place of (−B ± √D)/2A',
    line: 't',
    remedy: 'The denominator is 2A. Only with b = B/2 is it A.',
  },
  (course) => {
    const edit = (e: Parameters<Parameters<typeof rewrite>[1]>[0]) =>
      e.op === 'product' && isNumber(e.factors[0], 2) && e.factors.length === 2
        ? (e.factors[1] ?? null)
        : null;
    return { roots: rewrite(course.roots, edit), double: rewrite(course.double, edit) };
  },
);

/** It gives the roots of the opposite ray. */
export const minusLost = ofCurved(
  {
    id: 'lost-minus',
    says: 'B in place of −B',
    line: 't',
    remedy: 'The formula begins with −B. With +B the roots belong to the opposite ray.',
  },
  (course) => {
    const edit = (e: Parameters<Parameters<typeof rewrite>[1]>[0]) =>
      e.op === 'negative' && isScalar(e.of, 'B') ? e.of : null;
    return { roots: rewrite(course.roots, edit), double: rewrite(course.double, edit) };
  },
);

export const tIsDistance = ofCurved(
  {
    id: 'distance',
    says: 't taken for a distance, t·|d| in place of t',
    line: 't',
    remedy: 't counts in lengths of d: it is a distance only where |d| = 1.',
  },
  (course) => {
    const length = norm(vec('d'));
    return {
      roots: times(course.roots, length),
      double: times(course.double, length),
      linear: times(course.linear, length),
    };
  },
);

export const rootsSwapped = ofRules(
  {
    id: 'swapped-roots',
    says: 'the two roots swapped',
    line: 't',
    remedy: 't₁ is the smaller root. Where A < 0, it is the one with the plus sign.',
  },
  { order: 'descending' },
);

export const tangentLost = ofRules(
  {
    id: 'strict',
    says: 'D > 0 in place of D ≥ 0',
    line: 'case',
    remedy: 'D = 0 is a hit, too: the ray touches the surface in one point.',
  },
  { tangent: 'lost' },
);

export const linearIgnored = ofRules(
  {
    id: 'a-zero',
    says: 'A = 0 not told apart, so that the formula divides by 0',
    line: 'A',
    remedy: 'With A = 0 the equation is Bt + C = 0: one root, −C/B, or none.',
  },
  { linear: 'ignored' },
);

export const aEpsilon = ofRules(
  {
    id: 'a-epsilon',
    says: 'A compared with an epsilon in place of 0',
    line: 'A',
    remedy:
      'A has the size of |d|²: a small d makes a small A, and nothing is parallel to the axis.',
  },
  { linear: 'epsilon' },
);

export const dEpsilon = ofRules(
  {
    id: 'd-epsilon',
    says: 'D compared with an epsilon in place of 0',
    line: 'case',
    remedy:
      'No fixed epsilon fits every scale: near a tangent it makes one point of two, or a hit of ' +
      'a miss.',
  },
  { tangent: 'epsilon' },
);
