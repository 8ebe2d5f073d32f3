import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { exact } from '../arithmetic/exact.ts';
import type { Surd } from '../exact/surd.ts';
import { evaluate, type Triple, type Values, withScalars } from '../formula/evaluate.ts';
import type { FlatDetails, Hit, Intersection, PlaneHit } from '../intersection.ts';
import { all, type Bound, type FlatFormula, notPositive } from '../shapes/planar.ts';
import type { Vec3 } from '../vec3.ts';
import { answer, type MethodParts, rounded, signOf } from './tree-parts.ts';

/** A flat shape by its trees. `exactly`: its symbols for exact arithmetic, if it comes to that. */
export function intersectFlat<T>(
  formula: FlatFormula,
  values: Values<T>,
  parts: MethodParts<T>,
  exactly: () => Values<Surd>,
): Intersection {
  const { arithmetic: ar, form } = parts;
  const rate = evaluate(formula.rate, ar, values);
  const offset = evaluate(formula.offset, ar, values);
  return flatAnswer(formula, rate, offset, parts, {
    N: values.vectors.N as Triple<T>,
    meeting() {
      const t = evaluate(formula.t, ar, withScalars(values, { rate }));
      return { t, ...form.meeting(formula, withScalars(values, { rate, t }), ar) };
    },
    values: () => values,
    exactly,
  });
}

/** Further quantities of a ray and a flat shape, each computed only where it is needed. */
interface FlatQuestion<T> {
  readonly N: Triple<T>;
  /** Where N·d is not 0: t, its place, and left − right of each condition there. */
  meeting(): { readonly t: T; readonly x: Triple<T>; readonly excesses: readonly T[] };
  values(): Values<T>;
  exactly(): Values<Surd>;
}

/** The answer from N·d and N·(E − P). */
export function flatAnswer<T>(
  { bound }: FlatFormula,
  rate: T,
  offset: T,
  { arithmetic: ar, decidedBy, id }: Pick<MethodParts<T>, 'arithmetic' | 'decidedBy' | 'id'>,
  question: FlatQuestion<T>,
): Intersection {
  const signs = { offset: signOf(offset, ar), rate: signOf(rate, ar) };
  const plane = signs.rate ? planeHit(bound, ar, question) : null;
  const contained = signs.rate === 0 && signs.offset === 0;
  const details: FlatDetails = {
    family: 'flat',
    offset: ar.toNumber(offset),
    rate: ar.toNumber(rate),
    signs,
    plane,
    meetsFigure: contained && bound ? bound.meetsLine(question.values(), ar) : null,
  };
  const hits = plane?.inside ? [withoutPlace(plane)] : [];
  return answer({ class: flatClass(details), hits, method: id, decidedBy, details });
}

function flatClass({ signs, plane }: FlatDetails): Intersection['class'] {
  if (plane) return plane.inside === null ? 'undecided' : plane.inside ? 'one' : 'none';
  if (signs.rate === null || signs.offset === null) return 'undecided';
  return signs.offset === 0 ? 'contained' : 'none';
}

function planeHit<T>(
  bound: Bound | null,
  ar: Arithmetic<T>,
  { N, meeting, values, exactly }: FlatQuestion<T>,
): PlaneHit {
  const { t, x, excesses } = meeting();
  const holds = excesses.map((excess) => notPositive(ar.sign(excess)));
  const inside = all(holds);
  const point = rounded(x, ar);
  return {
    t: ar.toNumber(t),
    point,
    normal: rounded(N, ar),
    singular: false,
    holds,
    inside,
    distance:
      bound && inside === false
        ? distanceOf(bound, ar.toNumber(bound.distance(x, values(), ar)), point, exactly)
        : 0,
  };
}

/**
 * The method's own distance where that is one. Its squares may leave its range though the place
 * does not, and a place beside the rim may be rounded into the figure: then that of the point which
 * it shows. Without such a point the distance is beyond what the method can count.
 */
function distanceOf(bound: Bound, own: number, point: Vec3, exactly: () => Values<Surd>): number {
  if (own >= 0) return own;
  if (!point.every(Number.isFinite)) return Number.POSITIVE_INFINITY;
  const [x, y, z] = point;
  const place: Triple<Surd> = [exact.of(x), exact.of(y), exact.of(z)];
  return Math.max(0, exact.toNumber(bound.distance(place, exactly(), exact)));
}

const withoutPlace = ({ t, point, normal, singular }: PlaneHit): Hit => ({
  t,
  point,
  normal,
  singular,
});
