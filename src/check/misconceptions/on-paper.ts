import {
  type Expr,
  type ExprTriple,
  negative,
  norm,
  num,
  over,
  root,
  scalar,
  times,
  vec,
  vecMinus,
} from '../../math/formula.ts';
import { rewrite } from '../rewrite.ts';
import { type Misconception, ofCurved, ofFlat } from './define.ts';

/** D/4, which belongs to the formula with b = B/2. */
const quarterOfD = ofCurved(
  {
    id: 'quarter-d',
    says: 'a quarter of D, the b² − AC of b = B/2, in place of B² − 4AC',
    line: 'D',
    remedy: 'With B itself the discriminant is B² − 4AC; b² − AC belongs to b = B/2.',
  },
  ({ D }) => ({ D: over(D, num(4)) }),
);

/** √D written in the line D, and not again in the formula for the roots. */
const rootForD = ofCurved(
  {
    id: 'root-for-d',
    says: '√D in place of D',
    line: 'D',
    remedy: 'D is B² − 4AC itself. Its root is drawn on the line of the roots.',
  },
  ({ D, roots }) => ({ D: root(D), roots: withoutRoot(roots) }),
);

const rootForgotten = ofCurved(
  {
    id: 'no-root',
    says: '(−B ± D)/2A in place of (−B ± √D)/2A',
    line: 't',
    remedy: 'It is the square root of D that is added and subtracted.',
  },
  ({ roots }) => ({ roots: withoutRoot(roots) }),
);

const turningPoint = ofCurved(
  {
    id: 'turning-point',
    says: '−B/2A in place of (−B ± √D)/2A',
    line: 't',
    remedy: '−B/2A is where f turns, in the middle between the roots: √D/2A leads to them.',
  },
  ({ double }) => ({ roots: double }),
);

function withoutRoot(roots: Expr): Expr {
  return rewrite(roots, (e) => (e.op === 'root' ? e.of : null));
}

/** (−B ± √D)/2*A, as often written in programs. */
const timesA = ofCurved(
  {
    id: 'times-a',
    says: '(−B ± √D)/2 · A in place of (−B ± √D)/(2A)',
    line: 't',
    remedy: 'All of 2A is divided by. On one line it needs brackets: /(2*A).',
  },
  (course) => {
    const edit = (e: Expr): Expr | null =>
      e.op === 'quotient' ? times(over(e.over, num(2)), scalar('A')) : null;
    return { roots: rewrite(course.roots, edit), double: rewrite(course.double, edit) };
  },
);

const onlyRootDivided = ofCurved(
  {
    id: 'only-root-over-2a',
    says: '−B ± √D/2A in place of (−B ± √D)/2A',
    line: 't',
    remedy: 'The fraction bar goes under −B as well: −B is divided by 2A, too.',
  },
  ({ roots }) => {
    if (roots.op !== 'quotient' || roots.over.op !== 'plus-minus') return null;
    const { left, right } = roots.over;
    return { roots: { ...roots.over, right: over(right, roots.under) }, double: left };
  },
);

const linearSign = ofCurved(
  {
    id: 'linear-sign',
    says: 'C/B in place of −C/B',
    line: 't',
    remedy: 'From Bt + C = 0 follows t = −C/B.',
  },
  ({ linear }) => ({ linear: rewrite(linear, (e) => (e.op === 'negative' ? e.of : null)) }),
);

const flatDifferenceTurned = ofFlat(
  {
    id: 'flat-P-minus-E',
    says: 'P − E in place of E − P',
    line: 'N.(E-P)',
    remedy: 'E − P leads from the plane’s point to E: N·(E − P) says on which side E is.',
  },
  ({ t, offset }) => {
    if (t.op !== 'quotient' || offset.op !== 'dot' || offset.right.op !== 'difference') return null;
    const { left, right } = offset.right;
    const turned = { ...offset, right: vecMinus(right, left) };
    return { offset: turned, t: { ...t, over: negative(turned) } };
  },
);

/** Mistakes in P as for curved shapes. */
const flatFromOrigin = ofFlat(
  {
    id: 'flat-from-origin',
    says: 'P = t d in place of P = E + t d',
    line: 'P',
    remedy: 'The ray starts at E: add it.',
  },
  ({ P }) => ({ P: inEach(P, (e) => (e.op === 'sum' ? (e.terms[1]?.expr ?? e) : e)) }),
);

const flatBackwards = ofFlat(
  {
    id: 'flat-backwards',
    says: 'P = E − t d in place of P = E + t d',
    line: 'P',
    remedy: 'The ray runs along d, not against it.',
  },
  ({ P }) => ({ P: inEach(P, (e) => (e.op === 'sum' ? turnedSecond(e) : e)) }),
);

const turnedSecond = (e: Extract<Expr, { op: 'sum' }>): Expr => ({
  ...e,
  terms: e.terms.map((term, i) => (i === 1 ? { ...term, sign: -1 } : term)),
});

const flatAlongUnit = ofFlat(
  {
    id: 'flat-unit-d',
    says: 'P = E + t d/|d| in place of P = E + t d',
    line: 'P',
    remedy: 't counts in lengths of d, whatever its length: do not divide by |d|.',
  },
  ({ P }) => ({
    P: inEach(P, (e) =>
      rewrite(e, (part) =>
        part.op === 'product' ? times(...part.factors, over(num(1), norm(vec('d')))) : null,
      ),
    ),
  }),
);

const inEach = ([x, y, z]: ExprTriple, edit: (e: Expr) => Expr): ExprTriple => [
  edit(x),
  edit(y),
  edit(z),
];

/** Mistakes that only lines on paper can show: a program returns no points, only roots. */
export const ON_PAPER: readonly Misconception[] = [
  quarterOfD,
  rootForD,
  rootForgotten,
  turningPoint,
  timesA,
  onlyRootDivided,
  linearSign,
  flatDifferenceTurned,
  flatFromOrigin,
  flatBackwards,
  flatAlongUnit,
];
