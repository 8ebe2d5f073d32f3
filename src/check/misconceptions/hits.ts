import { negative, norm, over, plus, scalar, times, vec } from '../../math/formula/expr.ts';
import { occurs, rewrite } from '../rewrite.ts';
import { ofCurved, ofRules } from './define.ts';

export const behindAccepted = ofRules(
  {
    id: 'behind',
    code: 'X2',
    says: 't < 0 accepted',
    line: 'first',
    remedy: 'A ray begins at E: what lies at t < 0 is behind it.',
  },
  { behind: 'accepted' },
);

export const farForNear = ofRules(
  {
    id: 'far-root',
    code: 'X11',
    says: 'the far root taken for the near one',
    line: 'first',
    remedy: 'Of the roots that are not negative, the smallest is seen first.',
  },
  { first: 'farthest' },
);

export const lightForgotten = ofRules(
  {
    id: 'no-light-bound',
    code: 'X10',
    says: 'a shadow ray that does not end at its light',
    line: 'first',
    remedy: 'What lies behind the light, at t > 1, casts no shadow here.',
  },
  { light: 'forgotten' },
);

export const oneNappe = ofCurved(
  {
    id: 'one-nappe',
    code: 'X7',
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
    code: 'X14',
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
    code: 'X14',
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
    code: 'X5',
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

export const normalTurned = ofCurved(
  {
    id: 'normal-turned',
    code: 'X4',
    says: 'the normal turned round, inside for outside',
    line: 'N',
    remedy: 'The course’s normal points away from the axis: it begins with x − Cx.',
  },
  ({ N: [x, y, z] }) => ({ N: [negative(x), negative(y), negative(z)] }),
);

export const normalOfSphere = ofCurved(
  {
    id: 'normal-sphere',
    code: 'X4',
    says: 'P − C taken for the normal, as on a sphere',
    line: 'N',
    remedy: 'The y component is not y − Cy: its factor comes from the surface’s equation.',
  },
  ({ N: [x, , z] }) => ({
    N: [
      x,
      rewrite(x, (e) => {
        if (e.op === 'scalar') return scalar('y');
        return e.op === 'component' ? { ...e, axis: 'y' } : null;
      }),
      z,
    ],
  }),
);

export const normalSign = ofCurved(
  {
    id: 'normal-plus',
    code: 'X4',
    says: 'the sign of the normal’s y component lost',
    line: 'N',
    remedy: 'The term in y is subtracted in f, so its derivative is negative.',
  },
  ({ N: [x, y, z] }) => ({
    N: [x, rewrite(y, (e) => (e.op === 'negative' ? e.of : null)), z],
  }),
);

export const normalFactor = ofCurved(
  {
    id: 'normal-factor',
    code: 'X4',
    says: 'c in place of c², or a² in place of a, in the normal',
    line: 'N',
    remedy:
      'The factor of y − Cy is the one of the surface’s equation: c² for a cone, a for a hyperboloid.',
  },
  ({ N: [x, y, z] }) => ({
    N: [
      x,
      rewrite(y, (e) => {
        if (e.op === 'square' && e.of.op === 'scalar') return e.of;
        return e.op === 'scalar' && e.id === 'a' ? times(e, e) : null;
      }),
      z,
    ],
  }),
);

export const normalIsPoint = ofCurved(
  {
    id: 'normal-is-P',
    code: 'X4',
    says: 'P itself taken for the normal, without the centre',
    line: 'N',
    remedy:
      'The normal is formed with x − Cx and z − Cz: it starts at the axis, not at the origin.',
  },
  ({ N: [x, y, z] }) => {
    const edit = (e: Parameters<typeof rewrite>[0]) =>
      rewrite(e, (part) =>
        part.op === 'sum' && part.terms.length === 2 ? plus(part.terms[0]?.expr ?? part) : null,
      );
    return { N: [edit(x), edit(y), edit(z)] };
  },
);
