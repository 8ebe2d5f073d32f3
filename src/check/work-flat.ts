import type { Arithmetic } from '../math/arithmetic/arithmetic.ts';
import { evaluate, evaluateTriple, withScalars } from '../math/formula/evaluate.ts';
import { valuesOf } from '../math/methods/tree-method.ts';
import { all, whichHold, withPoint } from '../math/shapes/planar.ts';
import type { FlatCourse } from './course.ts';
import { ownNumber, ownTriple, roundedTriple } from './own-values.ts';
import type { Answer, Answers, Input } from './types.ts';

/** N.d, N.(E-P), place, and where the plane is met t, P1, inside, case, first, N1 and the first visible P and N. */
export function flatWork<T>(
  course: FlatCourse,
  { shape, ray }: Input,
  own: Answers,
  ar: Arithmetic<T>,
): Answers {
  const values = valuesOf(shape, ray, ar);
  const ownRate = ownNumber(own, 'N.d', ar);
  const ownOffset = ownNumber(own, 'N.(E-P)', ar);
  const rate = ownRate ?? evaluate(course.rate, ar, values);
  const offset = ownOffset ?? evaluate(course.offset, ar, values);
  const found: Record<string, Answer> = {
    'N.d': ar.toNumber(rate),
    'N.(E-P)': ar.toNumber(offset),
  };
  if (ar.sign(rate) === 0) return { ...found, ...parallel(ar.sign(offset) === 0, course) };
  const chained = ownRate !== undefined || ownOffset !== undefined;
  const computed = chained ? ar.div(ar.neg(offset), rate) : evaluate(course.t, ar, values);
  const t = ownNumber(own, 't1', ar) ?? computed;
  const point =
    ownTriple(own, 'P1', ar) ?? evaluateTriple(course.P, ar, withScalars(values, { t }));
  const inside = all(whichHold(course.conditions, withPoint(values, point), ar)) ?? false;
  const visible = inside && (ar.sign(t) >= 0 || course.rules.behind === 'accepted');
  const P = roundedTriple(point, ar);
  const N = values.vectors.N ? { N1: roundedTriple(values.vectors.N, ar) } : {};
  return {
    ...found,
    ...{ place: 'meets', t: ar.toNumber(t), t1: ar.toNumber(t), P1: P, ...N },
    inside: inside ? 'inside' : 'outside',
    case: inside ? 'one' : 'none',
    first: visible ? 't1' : 'none',
    ...(visible ? { P } : {}),
  };
}

function parallel(inPlane: boolean, { rules }: FlatCourse): Answers {
  const asked = rules.parallel === 'asked' ? inPlane : rules.parallel === 'always in';
  return { place: asked ? 'in' : 'beside', case: asked ? 'contained' : 'none', first: 'none' };
}
