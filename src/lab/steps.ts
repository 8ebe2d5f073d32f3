import { exactMethod as exact } from '../math/exact.ts';
import {
  type Arithmetic,
  alongAxes,
  type CurvedFormula,
  comp,
  courseForm,
  DISCRIMINANT,
  DOUBLE_ROOT,
  type Expr,
  type ExprTriple,
  evaluate,
  evaluateTriple,
  type FlatFormula,
  type Form,
  LINEAR_ROOT,
  POINT,
  ROOTS,
  type Solver,
  STABLE_Q,
  STABLE_ROOTS,
  scalar,
  solveBy,
  type Triple,
  type Values,
  withScalars,
  withVector,
} from '../math/formula.ts';
import type { Ray, Shape } from '../math/index.ts';
import { AXES, definitionOf, type Method } from '../math/shapes.ts';
import { type Operation, type Trace, type Traced, traceIn } from './trace.ts';

/**
 * Every operation of the method on this ray beside the exact result, named by the course's letters.
 * For a method that is not made of trees (certified): the operations of `exact`, which has the same
 * class.
 */
export function operationsOf(method: Method, shape: Shape, ray: Ray): readonly Operation[] {
  const parts = method.parts ?? exact.parts;
  return parts
    ? parts(({ arithmetic, form, solver }) => run(arithmetic, form, solver, shape, ray))
    : [];
}

/** The arithmetic of those operations. */
export const formatOf = (method: Method): string =>
  (method.parts ?? exact.parts)?.(({ arithmetic }) => arithmetic.id) ?? exact.id;

function run<T>(
  own: Arithmetic<T>,
  form: Form,
  solver: Solver,
  shape: Shape,
  ray: Ray,
): readonly Operation[] {
  const trace = traceIn(own);
  const definition = definitionOf(shape);
  const given = definition.values(shape);
  const vectors = { ...given.vectors, E: ray.origin, d: ray.direction };
  const values = trace.symbols({ scalars: given.scalars, vectors });
  const formula = definition.formula(shape);
  if (formula.family === 'curved') curved(trace, form, solver, formula, values);
  else flat(trace, form, formula, values);
  return [...trace.inputs, ...trace.operations];
}

/** Placeholders for letters, used to name trees: names are found by the trees, not by values. */
const letters = <T>(trace: Trace<T>, ...ids: readonly string[]): Record<string, Traced<T>> =>
  Object.fromEntries(ids.map((id) => [id, trace.placeholder(scalar(id))]));

const vectorLetter = <T>(trace: Trace<T>, id: string): Triple<Traced<T>> =>
  alongAxes((axis) => trace.placeholder(comp(id, axis)));

function curved<T>(
  trace: Trace<T>,
  form: Form,
  solver: Solver,
  formula: CurvedFormula,
  values: Values<Traced<T>>,
): void {
  const { arithmetic: ar } = trace;
  const { A, B, C, moment, momentD } = formula;
  const solved = letters(trace, 'A', 'B', 'C', 'D', 'q');
  const named = withScalars(withVector(values, 'm', vectorLetter(trace, 'm')), solved);
  for (const [id, tree] of Object.entries({ A, B, C })) trace.name(scalar(id), tree, values);
  nameVector(trace, 'm', moment, values);
  trace.name(scalar('D'), form === courseForm ? DISCRIMINANT : momentD, named);
  for (const q of STABLE_Q) trace.name(scalar('q'), q, named);
  for (const t of [DOUBLE_ROOT, LINEAR_ROOT, ...STABLE_ROOTS, ROOTS]) {
    trace.name(scalar('t'), t, named);
  }
  trace.name(scalar('t'), ROOTS, named, -1);
  const [a, b, c] = evaluateTriple([A, B, C], ar, values);
  const withABC = withScalars(values, { A: a, B: b, C: c });
  solveBy(solver, a, b, c, form.discriminant(formula, withABC, ar), ar);
}

function nameVector<T>(
  trace: Trace<T>,
  id: string,
  trees: ExprTriple,
  values: Values<Traced<T>>,
): void {
  AXES.forEach((axis, i) => {
    trace.name(comp(id, axis), trees[i] as Expr, values);
  });
}

function flat<T>(
  trace: Trace<T>,
  form: Form,
  formula: FlatFormula,
  values: Values<Traced<T>>,
): void {
  const { arithmetic: ar } = trace;
  trace.name(formula.rate, formula.rate, values);
  trace.name(formula.offset, formula.offset, values);
  const rate = evaluate(formula.rate, ar, values);
  evaluate(formula.offset, ar, values);
  if (!ar.sign(rate)) return;
  trace.name(scalar('t'), formula.t, values);
  const { m, w } = formula.byMoment;
  const named = withScalars(withVector(values, 'm', vectorLetter(trace, 'm')), {
    t: trace.placeholder(scalar('t')),
  });
  nameVector(trace, 'm', m, values);
  nameVector(trace, 'w', w, named);
  nameVector(trace, 'X', POINT, named);
  const t = evaluate(formula.t, ar, values);
  form.meeting(formula, withScalars(values, { t, rate }), ar);
}
