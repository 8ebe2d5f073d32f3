import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { DISCRIMINANT, POINT } from '../formula/common.ts';
import { evaluate, evaluateTriple, lift, type Values, withScalars } from '../formula/evaluate.ts';
import type { Hit, Intersection, QuadraticAnswer } from '../intersection.ts';
import type { Ray } from '../ray.ts';
import type { CurvedFormula } from '../shapes/axial-quadric.ts';
import { withPoint } from '../shapes/planar.ts';
import { solveBy } from './solvers.ts';
import { answer, curvedDetails, type MethodParts, rounded } from './tree-parts.ts';

/** The symbols of a shape, whose values are `own`, and of a ray, in the numbers of `arithmetic`. */
export const symbolsOf = <T>(
  own: Values<number>,
  { origin, direction }: Ray,
  arithmetic: Arithmetic<T>,
): Values<T> =>
  lift({ scalars: own.scalars, vectors: { ...own.vectors, E: origin, d: direction } }, arithmetic);

/** A curved shape by its trees. */
export function intersectCurved<T>(
  formula: CurvedFormula,
  values: Values<T>,
  { arithmetic: ar, form, solver, decidedBy, id }: MethodParts<T>,
): Intersection {
  const [A, B, C] = evaluateTriple([formula.A, formula.B, formula.C], ar, values);
  const D = form.discriminant(formula, withScalars(values, { A, B, C }), ar);
  const { class: verdict, roots } = solveBy(solver, A, B, C, D, ar);
  const hits = roots.map((t) => hitAt(t, formula.normal, values, ar));
  const details = curvedDetails([A, B, C], D, ar);
  return answer({ class: verdict, hits, method: id, decidedBy, details });
}

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

/** A t² + B t + C = 0 for doubles, by a method's arithmetic and solver. */
export function solveDoubles<T>(
  A: number,
  B: number,
  C: number,
  parts: Pick<MethodParts<T>, 'arithmetic' | 'solver' | 'decidedBy'>,
): QuadraticAnswer {
  const { arithmetic: ar, solver } = parts;
  const scalars = { A: ar.of(A), B: ar.of(B), C: ar.of(C) };
  const D = evaluate(DISCRIMINANT, ar, { scalars, vectors: {} });
  const solved = solveBy(solver, scalars.A, scalars.B, scalars.C, D, ar);
  const roots = solved.roots.map(ar.toNumber);
  const broken =
    roots.some(Number.isNaN) || (parts.decidedBy !== 'exact' && !roots.every(Number.isFinite));
  return broken ? { class: 'undecided', roots: [] } : { class: solved.class, roots };
}
