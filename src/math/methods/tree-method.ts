import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { exact } from '../arithmetic/exact.ts';
import type { Surd } from '../exact/surd.ts';
import { DISCRIMINANT, POINT } from '../formula/common.ts';
import {
  evaluate,
  evaluateTriple,
  lift,
  type Triple,
  type Values,
  withScalars,
} from '../formula/evaluate.ts';
import type {
  Coefficients,
  CurvedDetails,
  DecidedBy,
  FlatDetails,
  Hit,
  Intersection,
  PlaneHit,
  QuadraticAnswer,
  Sign,
} from '../intersection.ts';
import type { Ray } from '../ray.ts';
import type { CurvedFormula } from '../shapes/axial-quadric.ts';
import type { Shape } from '../shapes/index.ts';
import { definitionOf } from '../shapes/lookup.ts';
import { all, type Bound, type FlatFormula, withPoint } from '../shapes/planar.ts';
import type { Vec3 } from '../vec3.ts';
import type { Method } from './define.ts';
import { courseForm, type Form } from './forms.ts';
import type { Solver } from './solvers.ts';

interface Rung<T> {
  readonly arithmetic: Arithmetic<T>;
  readonly form: Form;
  readonly solver: Solver;
  readonly decidedBy: DecidedBy;
  readonly id: string;
}

type About = Pick<Method, 'id' | 'title' | 'idea' | 'promise' | 'source'>;

/**
 * A method that is an arithmetic, a way to form what decides and a way to solve the quadratic: the trees are evaluated in
 * that arithmetic, and whatever is shown of them is rounded to doubles at the very end.
 */
export function treeMethod<T>(
  about: About,
  arithmetic: Arithmetic<T>,
  solver: Solver,
  decidedBy: DecidedBy,
  form: Form = courseForm,
): Method {
  const rung: Rung<T> = { arithmetic, form, solver, decidedBy, id: about.id };
  return {
    ...about,
    coefficients(shape, ray) {
      const [A, B, C] = coefficientsOf(shape, valuesOf(shape, ray, arithmetic), arithmetic);
      const { toNumber } = arithmetic;
      return { A: toNumber(A), B: toNumber(B), C: toNumber(C) } satisfies Coefficients;
    },
    intersect(shape, ray) {
      const formula = formulaOf(shape);
      const values = valuesOf(shape, ray, arithmetic);
      return formula.family === 'curved'
        ? intersectCurved(formula, values, rung)
        : intersectFlat(formula, values, rung, () => valuesOf(shape, ray, exact));
    },
    solve: (A, B, C) => solveDoubles(A, B, C, rung),
    parts: (use) => use(arithmetic, form, solver),
  };
}

function formulaOf(shape: Shape): CurvedFormula | FlatFormula {
  return definitionOf(shape).formula(shape);
}

/** The ray's and the shape's symbols in the method's numbers. */
export function valuesOf<T>(shape: Shape, ray: Ray, arithmetic: Arithmetic<T>): Values<T> {
  const own = definitionOf(shape).values(shape);
  return lift(
    { scalars: own.scalars, vectors: { ...own.vectors, E: ray.origin, d: ray.direction } },
    arithmetic,
  );
}

/** A, B, C of f(t); for a flat shape f is the line (N·d) t + N·(E − P). */
function coefficientsOf<T>(shape: Shape, values: Values<T>, ar: Arithmetic<T>): Triple<T> {
  const formula = formulaOf(shape);
  if (formula.family === 'curved') {
    return evaluateTriple([formula.A, formula.B, formula.C], ar, values);
  }
  return [ar.of(0), evaluate(formula.rate, ar, values), evaluate(formula.offset, ar, values)];
}

function intersectCurved<T>(
  formula: CurvedFormula,
  values: Values<T>,
  { arithmetic: ar, form, solver, decidedBy, id }: Rung<T>,
): Intersection {
  const [A, B, C] = evaluateTriple([formula.A, formula.B, formula.C], ar, values);
  const D = form.discriminant(formula, withScalars(values, { A, B, C }), ar);
  const { class: verdict, roots } = solver(A, B, C, D, ar);
  const hits = roots.map((t) => hitAt(t, formula.normal, values, ar));
  const { toNumber } = ar;
  const details: CurvedDetails = {
    family: 'curved',
    A: toNumber(A),
    B: toNumber(B),
    C: toNumber(C),
    D: toNumber(D),
    signs: { A: signOf(A, ar), B: signOf(B, ar), C: signOf(C, ar), D: signOf(D, ar) },
  };
  return answer({ class: verdict, hits, method: id, decidedBy, details });
}

function intersectFlat<T>(
  formula: FlatFormula,
  values: Values<T>,
  { arithmetic: ar, form, decidedBy, id }: Rung<T>,
  exactValues: () => Values<Surd>,
): Intersection {
  const rate = evaluate(formula.rate, ar, values);
  const offset = evaluate(formula.offset, ar, values);
  const signs = { offset: signOf(offset, ar), rate: signOf(rate, ar) };
  const plane = signs.rate
    ? planeHit(formula, withScalars(values, { rate }), form, ar, exactValues)
    : null;
  const contained = signs.rate === 0 && signs.offset === 0;
  const details: FlatDetails = {
    family: 'flat',
    offset: ar.toNumber(offset),
    rate: ar.toNumber(rate),
    signs,
    plane,
    meetsFigure: contained && formula.bound ? formula.bound.meetsLine(values, ar) : null,
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
  formula: FlatFormula,
  values: Values<T>,
  form: Form,
  ar: Arithmetic<T>,
  exactValues: () => Values<Surd>,
): PlaneHit {
  const t = evaluate(formula.t, ar, values);
  const { x, holds } = form.meeting(formula, withScalars(values, { t }), ar);
  const { bound } = formula;
  const inside = all(holds);
  const N = values.vectors.N as Triple<T>;
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
        ? distanceOf(bound, ar.toNumber(bound.distance(x, values, ar)), point, exactValues)
        : 0,
  };
}

/**
 * The rung's own distance where that is one. Its squares may leave its range though the place does not, and a place beside the rim may be rounded
 * into the figure: then that of the point which it shows. Without such a point the distance is beyond what the rung can count.
 */
function distanceOf(
  bound: Bound,
  own: number,
  point: Vec3,
  exactValues: () => Values<Surd>,
): number {
  if (own >= 0) return own;
  if (!point.every(Number.isFinite)) return Number.POSITIVE_INFINITY;
  const [x, y, z] = point;
  const place: Triple<Surd> = [exact.of(x), exact.of(y), exact.of(z)];
  return Math.max(0, exact.toNumber(bound.distance(place, exactValues(), exact)));
}

const withoutPlace = ({ t, point, normal, singular }: PlaneHit): Hit => ({
  t,
  point,
  normal,
  singular,
});

function hitAt<T>(
  t: T,
  normalFormula: CurvedFormula['normal'],
  values: Values<T>,
  ar: Arithmetic<T>,
): Hit {
  const point = evaluateTriple(POINT, ar, withScalars(values, { t }));
  const normal = evaluateTriple(normalFormula, ar, withPoint(values, point));
  const singular = normal.every((n) => ar.sign(n) === 0);
  return {
    t: ar.toNumber(t),
    point: rounded(point, ar),
    normal: singular ? [0, 0, 0] : rounded(normal, ar),
    singular,
  };
}

function rounded<T>([x, y, z]: Triple<T>, { toNumber }: Arithmetic<T>): Vec3 {
  return [toNumber(x), toNumber(y), toNumber(z)];
}

function signOf<T>(x: T, ar: Arithmetic<T>): Sign | null {
  const sign = ar.sign(x);
  return Number.isNaN(sign) ? null : (sign as Sign);
}

/** A float rung whose roots or points overflowed into NaN says that it cannot tell, rather than print them. */
function answer(found: Intersection): Intersection {
  const numbers = found.hits.flatMap(({ t, point, normal }) => [t, ...point, ...normal]);
  const broken =
    numbers.some(Number.isNaN) ||
    (found.decidedBy !== 'exact' && found.hits.some(({ t }) => !Number.isFinite(t)));
  return broken ? { ...found, class: 'undecided', hits: [] } : found;
}

function solveDoubles<T>(A: number, B: number, C: number, rung: Rung<T>): QuadraticAnswer {
  const { arithmetic: ar, solver } = rung;
  const scalars = { A: ar.of(A), B: ar.of(B), C: ar.of(C) };
  const D = evaluate(DISCRIMINANT, ar, { scalars, vectors: {} });
  const solved = solver(scalars.A, scalars.B, scalars.C, D, ar);
  const roots = solved.roots.map(ar.toNumber);
  const broken =
    roots.some(Number.isNaN) || (rung.decidedBy !== 'exact' && !roots.every(Number.isFinite));
  return broken ? { class: 'undecided', roots: [] } : { class: solved.class, roots };
}
