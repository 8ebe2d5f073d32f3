import { exact } from '../arithmetic/exact.ts';
import { add, compare, div, fromNumber, mul, type Surd, sub, toNumber } from '../exact/surd.ts';
import { DISCRIMINANT } from '../formula/common.ts';
import {
  evaluate,
  evaluateTriple,
  type Triple,
  type Values,
  withScalars,
} from '../formula/evaluate.ts';
import type { Intersection, Sign } from '../intersection.ts';
import type { Ray } from '../ray.ts';
import type { ShapeDefinition } from '../shapes/define.ts';
import type { Vec3 } from '../vec3.ts';
import { courseForm } from './forms.ts';
import { solveBy, textbookSolver } from './solvers.ts';
import { intersectCurved, symbolsOf } from './tree-answer.ts';
import { intersectFlat } from './tree-flat.ts';

type Entry = Pick<ShapeDefinition<never>, 'formula' | 'values'>;

const PARTS = {
  arithmetic: exact,
  form: courseForm,
  solver: textbookSolver,
  decidedBy: 'exact',
  id: 'exact',
} as const;

/** A point where the line has a given height. */
export interface AtHeight {
  readonly t: number;
  readonly point: Vec3;
  /** Of f there: −1 inside of the surface, 0 on it. */
  readonly side: Sign;
}

/** One line and one shape in exact arithmetic; each answer is computed when it is asked for. */
export interface ExactLine {
  /** As the method `exact` answers. */
  readonly answer: () => Intersection;
  /** The sign of root k − t, k counted from the least. */
  readonly rootVsT: (k: number, t: number) => Sign;
  /** The sign of (root k) − (t where the line has this height). */
  readonly rootVsHeight: (k: number, height: number) => Sign;
  /** The sign of (t where the line has this height) − t. */
  readonly heightVsT: (height: number, t: number) => Sign;
  /** The sign of y − height at root k. */
  readonly yVsHeight: (k: number, height: number) => Sign;
  /** Where y is `height`, correctly rounded; d may not be horizontal. */
  readonly atHeight: (height: number) => AtHeight;
  /** The signs of A and B of a curved shape. */
  readonly signs: () => { readonly A: Sign; readonly B: Sign };
}

/** The sign of C for a ray from `at`: −1 inside of a curved surface; null for a flat shape. */
export function exactSide(entry: Entry, shape: unknown, at: Vec3): Sign | null {
  const formula = entry.formula(shape as never);
  if (formula.family === 'flat') return null;
  const ray = { origin: at, direction: [1, 0, 0] } as const;
  const values = symbolsOf(entry.values(shape as never), ray, exact);
  return exact.sign(evaluate(formula.C, exact, values)) as Sign;
}

/** @param shape of the entry's kind, checked before; the ray too. */
export function exactLine(entry: Entry, shape: unknown, ray: Ray): ExactLine {
  const formula = entry.formula(shape as never);
  const values = symbolsOf(entry.values(shape as never), ray, exact);
  const [e, d] = [values.vectors.E, values.vectors.d] as [Triple<Surd>, Triple<Surd>];
  const once = <T>(work: () => T): (() => T) => {
    let known: { readonly value: T } | null = null;
    return () => {
      known ??= { value: work() };
      return known.value;
    };
  };
  const coefficients = once((): Triple<Surd> => {
    if (formula.family === 'curved') {
      return evaluateTriple([formula.A, formula.B, formula.C], exact, values);
    }
    return [
      fromNumber(0),
      evaluate(formula.rate, exact, values),
      evaluate(formula.offset, exact, values),
    ];
  });
  const roots = once(() => {
    const [A, B, C] = coefficients();
    const D = evaluate(DISCRIMINANT, exact, { scalars: { A, B, C }, vectors: {} });
    return solveBy(textbookSolver, A, B, C, D, exact).roots;
  });
  const root = (k: number): Surd => roots()[k] as Surd;
  const timeOf = (height: number): Surd => div(sub(fromNumber(height), e[1]), d[1]);
  return {
    answer: once(() =>
      formula.family === 'curved'
        ? intersectCurved(formula, values, PARTS)
        : intersectFlat(formula, values, PARTS, () => values),
    ),
    rootVsT: (k, t) => compare(root(k), fromNumber(t)),
    rootVsHeight: (k, height) => compare(root(k), timeOf(height)),
    heightVsT: (height, t) => compare(timeOf(height), fromNumber(t)),
    yVsHeight: (k, height) => compare(add(e[1], mul(root(k), d[1])), fromNumber(height)),
    atHeight(height) {
      const t = timeOf(height);
      const x = add(e[0], mul(t, d[0]));
      const z = add(e[2], mul(t, d[2]));
      const at: Values<Surd> = withScalars(values, { t });
      const E = [x, fromNumber(height), z] as const;
      const there = { scalars: at.scalars, vectors: { ...at.vectors, E } };
      const f = formula.family === 'curved' ? evaluate(formula.C, exact, there) : fromNumber(0);
      return {
        t: toNumber(t),
        point: [toNumber(x), height, toNumber(z)],
        side: exact.sign(f) as Sign,
      };
    },
    signs() {
      const [A, B] = coefficients();
      return { A: exact.sign(A) as Sign, B: exact.sign(B) as Sign };
    },
  };
}
