import { norm, over, times, vec } from '../../math/formula.ts';
import { occurs, rewrite } from '../rewrite.ts';
import { ofCurved, ofRules } from './define.ts';

export const behindAccepted = ofRules(
  {
    id: 'behind',
    says: 't < 0 accepted',
    line: 'first',
    remedy: 'A ray begins at E: what lies at t < 0 is behind it.',
  },
  { behind: 'accepted' },
);

export const farForNear = ofRules(
  {
    id: 'far-root',
    says: 'the far root taken for the near one',
    line: 'first',
    remedy: 'Of the roots that are not negative, the smallest is seen first.',
  },
  { first: 'farthest' },
);

export const lightForgotten = ofRules(
  {
    id: 'no-light-bound',
    says: 'a shadow ray that does not end at its light',
    line: 'first',
    remedy: 'What lies behind the light, at t > 1, casts no shadow here.',
  },
  { light: 'forgotten' },
);

export const oneNappe = ofCurved(
  {
    id: 'one-nappe',
    says: 'the second nappe forgotten',
    line: 'case',
    remedy:
      'The cone has two nappes: below the vertex the radius is |c·h|, and points there count.',
  },
  ({ A, rules }) =>
    occurs(A, (e) => e.op === 'scalar' && e.id === 'c')
      ? { rules: { ...rules, nappes: 'upper' } }
      : null,
);

export const startForgotten = ofCurved(
  {
    id: 'from-origin',
    says: 'P = t d in place of P = E + t d',
    line: 'P',
    remedy: 'The ray starts at E: add it.',
  },
  ({ P: [x, y, z] }) => ({ P: [withoutStart(x), withoutStart(y), withoutStart(z)] }),
);

const withoutStart: typeof keep = (e) => (e.op === 'sum' ? (e.terms[1]?.expr ?? e) : e);
const keep = (e: Parameters<typeof rewrite>[0]) => e;

export const backwards = ofCurved(
  {
    id: 'backwards',
    says: 'P = E − t d in place of P = E + t d',
    line: 'P',
    remedy: 'The ray runs along d, not against it.',
  },
  ({ P: [x, y, z] }) => ({ P: [turned(x), turned(y), turned(z)] }),
);

const turned: typeof keep = (e) =>
  e.op === 'sum'
    ? { ...e, terms: e.terms.map((term, i) => (i === 1 ? { ...term, sign: -1 } : term)) }
    : e;

export const alongUnit = ofCurved(
  {
    id: 'unit-d',
    says: 'P = E + t d/|d| in place of P = E + t d',
    line: 'P',
    remedy: 't counts in lengths of d, whatever its length: do not divide by |d|.',
  },
  ({ P: [x, y, z] }) => ({ P: [perUnit(x), perUnit(y), perUnit(z)] }),
);

const perUnit: typeof keep = (e) =>
  rewrite(e, (part) =>
    part.op === 'product' ? times(...part.factors, over(ONE, norm(vec('d')))) : null,
  );
const ONE = { op: 'number', value: 1 } as const;
