import { negative, plus, scalar, times } from '../../math/formula.ts';
import { rewrite } from '../rewrite.ts';
import { ofCurved } from './define.ts';

export const normalTurned = ofCurved(
  {
    id: 'normal-turned',
    says: 'the normal turned round, inside for outside',
    line: 'N',
    remedy: 'The course’s normal points away from the axis: it begins with x − Cx.',
  },
  ({ N: [x, y, z] }) => ({ N: [negative(x), negative(y), negative(z)] }),
);

export const normalOfSphere = ofCurved(
  {
    id: 'normal-sphere',
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
    says: 'c in place of c², or a² in place of a, in the normal',
    line: 'N',
    remedy:
      'The factor of y − Cy is the one of the surface’s equation: c² for a cone, a for a ' +
      'hyperboloid.',
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
