import { type Expr, scalar, squared } from '../../math/formula.ts';
import type { CurvedCourse } from '../course.ts';
import { isNumber, isScalar, mentionsAxis, rewrite } from '../rewrite.ts';
import { ofCurved } from './define.ts';

/** The same edit in A, B and C, and in nothing else. */
const inCoefficients = ({ A, B, C }: CurvedCourse, edit: (e: Expr) => Expr | null) => ({
  A: rewrite(A, edit),
  B: rewrite(B, edit),
  C: rewrite(C, edit),
});

const withoutSquare =
  (id: string) =>
  (e: Expr): Expr | null =>
    e.op === 'square' && isScalar(e.of, id) ? scalar(id) : null;

export const radiusNotSquared = ofCurved(
  {
    id: 'r-for-r2',
    says: 'r in place of r²',
    line: 'C',
    remedy: 'The surface’s equation has r², the square of the radius.',
  },
  (course) => inCoefficients(course, withoutSquare('r')),
);

export const slopeNotSquared = ofCurved(
  {
    id: 'c-for-c2',
    says: 'c in place of c²',
    line: 'A',
    remedy: 'At height h the radius is c·h, and its square is c²h².',
  },
  (course) => inCoefficients(course, withoutSquare('c')),
);

export const flareSquared = ofCurved(
  {
    id: 'a2-for-a',
    says: 'a² in place of a',
    line: 'A',
    remedy: 'In the hyperboloid’s equation a stands as it is; only the cone’s c is squared.',
  },
  (course) => inCoefficients(course, (e) => (isScalar(e, 'a') ? squared(e) : null)),
);

export const radiusAdded = ofCurved(
  {
    id: 'plus-r2',
    says: '+ r² in place of − r²',
    line: 'C',
    remedy: 'r² comes from the right side of the equation: its sign turns.',
  },
  ({ C }) => ({
    C: flipTerms(C, (e) => e.op === 'square' && isScalar(e.of, 'r')),
  }),
);

export const heightAdded = ofCurved(
  {
    id: 'plus-y',
    says: 'a lost minus sign: the term in y added in place of subtracted',
    line: 'A',
    remedy: 'The term in y comes from the right side of the equation: its sign turns.',
  },
  ({ A, B, C }) => {
    const inY = (e: Expr): boolean => mentionsAxis(e, 'y');
    return { A: flipTerms(A, inY), B: flipTerms(B, inY), C: flipTerms(C, inY) };
  },
);

function flipTerms(expr: Expr, which: (e: Expr) => boolean): Expr {
  if (expr.op !== 'sum' || !expr.terms.some((term) => term.sign === -1 && which(term.expr))) {
    return expr;
  }
  return {
    ...expr,
    terms: expr.terms.map((term) => (which(term.expr) ? { ...term, sign: 1 } : term)),
  };
}

export const twoInBLost = ofCurved(
  {
    id: 'half-b',
    says: 'b = B/2 in place of B',
    line: 'B',
    remedy: 'B carries a factor 2 in every term. With b = B/2 the other formulas change, too.',
  },
  ({ B }) => ({
    B: rewrite(B, (e) => {
      if (e.op !== 'product' || !isNumber(e.factors[0], 2)) return null;
      return { ...e, factors: e.factors.slice(1) };
    }),
  }),
);

export const swappedInB = ofCurved(
  {
    id: 'swap-E-d',
    says: 'E and d swapped in B',
    line: 'B',
    remedy: 'In B each component of d multiplies the matching component of E − C.',
  },
  ({ B }) => ({
    B: rewrite(B, (e) => {
      if (e.op !== 'component') return null;
      const vector = SWAPPED[e.vector];
      return vector ? { ...e, vector } : null;
    }),
  }),
);

const SWAPPED: Readonly<Record<string, string>> = { E: 'd', d: 'E' };

export const differenceTurned = ofCurved(
  {
    id: 'C-minus-E',
    says: 'C − E in place of E − C in B',
    line: 'B',
    remedy: 'B is formed with E − C, from the centre to E. C − E turns its sign.',
  },
  ({ B }) => ({
    B: rewrite(B, (e) => {
      const [first, second] = e.op === 'sum' ? e.terms : [];
      if (e.op !== 'sum' || first?.expr.op !== 'component' || !second) return null;
      return {
        ...e,
        terms: [
          { sign: 1, expr: second.expr },
          { sign: -1, expr: first.expr },
        ],
      };
    }),
  }),
);
