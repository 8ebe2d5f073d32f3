import {
  type Arithmetic,
  all,
  type Expr,
  evaluate,
  evaluateTriple,
  scalar,
  type Values,
  whichHold,
  withPoint,
  withScalars,
} from '../math/formula.ts';
import type { FlatCourse } from './course.ts';
import { ownNumber, ownTriple, roundedTriple } from './own-values.ts';
import { rewrite } from './rewrite.ts';
import { ABSENT, type Answer, type Answers } from './types.ts';

/**
 * N.d, N.(E-P), place, and where the plane is met t1, P1, N1, inside, case, first, and t and P of a
 * visible hit.
 */
export function flatWork<T>(
  course: FlatCourse,
  values: Values<T>,
  own: Answers,
  ar: Arithmetic<T>,
): Answers {
  const rate = ownNumber(own, RATE, ar) ?? evaluate(course.rate, ar, values);
  const offset = ownNumber(own, OFFSET, ar) ?? evaluate(course.offset, ar, values);
  const found: Record<string, Answer> = {
    [RATE]: ar.toNumber(rate),
    [OFFSET]: ar.toNumber(offset),
  };
  const ownT = ownNumber(own, 't1', ar);
  const isParallel = ar.sign(rate) === 0;
  if (isParallel && ownT === undefined) {
    return { ...found, ...parallel(ar.sign(offset) === 0, course) };
  }
  const scalars = { [RATE]: rate, [OFFSET]: offset };
  const t =
    own.t1 === ABSENT
      ? undefined
      : (ownT ?? evaluate(inTheirNames(course), ar, withScalars(values, scalars)));
  const computed =
    t === undefined ? undefined : evaluateTriple(course.P, ar, withScalars(values, { t }));
  const point = own.P1 === ABSENT ? undefined : (ownTriple(own, 'P1', ar) ?? computed);
  const place = { ...found, place: 'meets', ...(t === undefined ? {} : { t1: ar.toNumber(t) }) };
  if (!point) return place;
  const inside = all(whichHold(course.conditions, withPoint(values, point), ar)) ?? false;
  const ahead = t !== undefined && (ar.sign(t) >= 0 || course.rules.behind === 'accepted');
  const visible = inside && ahead;
  const P = roundedTriple(point, ar);
  const N = values.vectors.N ? { N1: roundedTriple(values.vectors.N, ar) } : {};
  return {
    ...place,
    ...{ P1: P, ...N },
    inside: inside ? 'inside' : 'outside',
    case: inside ? 'one' : 'none',
    first: visible ? 't1' : 'none',
    ...(visible ? { t: ar.toNumber(t), P } : {}),
  };
}

const RATE = 'N.d';
const OFFSET = 'N.(E-P)';

/** The tree of t in terms of the two lines before it, so that a student's values can be used. */
const inTheirNames = ({ t, rate, offset }: FlatCourse): Expr =>
  rewrite(t, (e) => (e === rate ? scalar(RATE) : e === offset ? scalar(OFFSET) : null));

function parallel(inPlane: boolean, { rules }: FlatCourse): Answers {
  const asked = rules.parallel === 'asked' ? inPlane : rules.parallel === 'always in';
  return { place: asked ? 'in' : 'beside', case: asked ? 'contained' : 'none', first: 'none' };
}
