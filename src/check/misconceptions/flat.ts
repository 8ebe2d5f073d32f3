import { minus, norm, num, over, squared, times, vec } from '../../math/formula.ts';
import { isScalar, rewriteRelation } from '../rewrite.ts';
import { ofFlat, ofRules } from './define.ts';

export const flatMinusLost = ofFlat(
  {
    id: 'flat-lost-minus',
    says: 'the minus sign lost, or P − E in place of E − P',
    line: 't',
    remedy: 't = −N·(E − P) / (N·d). With P − E the minus sign goes away, but not with E − P.',
  },
  ({ t }) => ({
    t: t.op === 'quotient' && t.over.op === 'negative' ? { ...t, over: t.over.of } : t,
  }),
);

export const flatInverted = ofFlat(
  {
    id: 'flat-inverted',
    says: 'E − P and d swapped, N·d divided by N·(E − P)',
    line: 't',
    remedy: 'N·d, how fast the ray nears the plane, is what is divided by.',
  },
  ({ t }) => ({
    t:
      t.op === 'quotient' && t.over.op === 'negative'
        ? over({ op: 'negative', of: t.under }, t.over.of)
        : t,
  }),
);

export const flatPointForgotten = ofFlat(
  {
    id: 'flat-no-P',
    says: 'N·E in place of N·(E − P)',
    line: 'N.(E-P)',
    remedy: 'The plane need not pass through the origin: its point P is subtracted from E.',
  },
  ({ t, offset }) => {
    if (t.op !== 'quotient' || offset.op !== 'dot') return null;
    const short = { ...offset, right: vec('E') };
    return { offset: short, t: { ...t, over: { op: 'negative', of: short } } };
  },
);

export const flatDistance = ofFlat(
  {
    id: 'flat-distance',
    says: 't taken for a distance, t·|d| in place of t',
    line: 't',
    remedy: 't counts in lengths of d: it is a distance only where |d| = 1.',
  },
  ({ t }) => ({ t: times(t, norm(vec('d'))) }),
);

export const rimSquared = ofFlat(
  {
    id: 'rim-squared',
    says: '|X − C|² compared with r in place of r²',
    line: 'inside',
    remedy: 'Compare |X − C| with r, or |X − C|² with r².',
  },
  ({ conditions }) => ({
    conditions: conditions.every(({ left }) => left.op !== 'norm')
      ? conditions
      : conditions.map((c) => ({ ...c, left: squared(c.left) })),
  }),
);

/** The corner taken for the middle: P − L/2 ≤ x ≤ P + L/2. */
export const cornerIsMiddle = ofFlat(
  {
    id: 'corner-as-middle',
    says: 'P taken for the middle of the square in place of its corner',
    line: 'inside',
    remedy: 'P is the lower-left corner: the square reaches from P to P + L.',
  },
  ({ conditions }) => {
    const half = over({ op: 'scalar', id: 'L' }, num(2));
    const edited = conditions.map((c) =>
      c.left.op === 'component'
        ? { ...c, left: minus(c.left, half) }
        : rewriteRelation(c, (e) => (isScalar(e, 'L') ? half : null)),
    );
    const touches = edited.some((c, i) => c.right !== conditions[i]?.right);
    return { conditions: touches ? edited : conditions };
  },
);

export const alwaysBeside = ofRules(
  {
    id: 'parallel-misses',
    says: 'N·d = 0 taken for a miss without asking where E is',
    line: 'case',
    remedy: 'With N·d = 0 the ray may also lie in the plane: N·(E − P) tells.',
  },
  { parallel: 'always beside' },
);

export const alwaysIn = ofRules(
  {
    id: 'parallel-lies-in',
    says: 'N·d = 0 taken to mean that the ray lies in the plane',
    line: 'case',
    remedy: 'N·d = 0 says parallel. Only N·(E − P) = 0 says in the plane.',
  },
  { parallel: 'always in' },
);

export const alwaysTheRoot = ofRules(
  {
    id: 'loss-always-t',
    says: 'the formula for the roots blamed for every lost digit',
    line: 't',
    remedy: 'Compare line by line: a root cannot have more digits than the D that it is made from.',
  },
  { loss: 'always t' },
);
