import {
  type Expr,
  evaluate,
  evaluateTriple,
  float64,
  type Relation,
  scalar,
  type Values,
  valuesOf,
  whichHold,
  withPoint,
  withScalars,
} from '../math/formula.ts';
import type { Vec3 } from '../math/index.ts';
import type { Course, CurvedCourse, FlatCourse } from './course.ts';
import { courseOf } from './course.ts';
import type { Misconception } from './misconceptions/define.ts';
import type { Answers, Input } from './types.ts';
import { asExactly, work } from './work.ts';

/** One line of a derivation, right or edited, with the numbers that go into it. */
export interface DerivationLine {
  readonly id: string;
  /** The left side; null if the tree itself is the name (N·d). */
  readonly letter: Expr | null;
  /** One tree, or three for a point or normal. */
  readonly exprs: readonly Expr[];
  /** The condition of a figure, instead of a value. */
  readonly relation: Relation | null;
  /** Whether the condition holds. */
  readonly holds: boolean | null;
  /** Both roots of the line t; the components of a triple; the two sides of a condition. */
  readonly values: readonly number[];
  readonly numbers: Values<number>;
  /** Whether −B, √D and 2A are evaluated before they are put in. */
  readonly worked: boolean;
}

/** From the coefficients to the first visible hit's point and normal, as far as they exist. */
export function linesOf(course: Course, input: Input): readonly DerivationLine[] {
  const found = work(course, input);
  const values = valuesOf(input.shape, input.ray, float64);
  return course.family === 'curved'
    ? curvedLines(course, found, values)
    : flatLines(course, found, values, input);
}

const number = (found: Answers, id: string): number | undefined => {
  const x = found[id];
  return typeof x === 'number' ? x : undefined;
};

const triple = (found: Answers, id: string): Vec3 | undefined => {
  const x = found[id];
  return typeof x === 'object' ? x : undefined;
};

function line(
  id: string,
  letter: Expr | null,
  exprs: readonly Expr[],
  values: readonly number[],
  numbers: Values<number>,
): DerivationLine {
  return { id, letter, exprs, relation: null, holds: null, values, numbers, worked: id === 't' };
}

function curvedLines(
  course: CurvedCourse,
  found: Answers,
  values: Values<number>,
): DerivationLine[] {
  const letters = ['A', 'B', 'C', 'D'] as const;
  const scalars = Object.fromEntries(letters.map((id) => [id, number(found, id) ?? Number.NaN]));
  const numbers = withScalars(values, scalars);
  const coefficients = letters.map((id) =>
    line(id, scalar(id), [course[id]], [scalars[id] ?? Number.NaN], numbers),
  );
  const roots = ['t1', 't2'].flatMap((id) => number(found, id) ?? []);
  if (roots.length === 0) return coefficients;
  const tree = { one: course.linear, tangent: course.double }[String(found.case)] ?? course.roots;
  const t = line('t', scalar('t'), [tree], roots, numbers);
  return [...coefficients, t, ...hitLines(course.P, course.N, found, numbers)];
}

function hitLines(
  P: readonly Expr[],
  N: readonly Expr[] | null,
  found: Answers,
  numbers: Values<number>,
): DerivationLine[] {
  const [t, point, normal] = [number(found, 't'), triple(found, 'P'), triple(found, 'N')];
  if (t === undefined || !point) return [];
  const withT = withScalars(numbers, { t });
  const lines = [line('P', scalar('P'), P, point, withT)];
  return N && normal
    ? [...lines, line('N', scalar('N'), N, normal, withPoint(withT, point))]
    : lines;
}

function flatLines(
  course: FlatCourse,
  found: Answers,
  values: Values<number>,
  { shape, ray }: Input,
): DerivationLine[] {
  const value = (id: string): number => number(found, id) ?? Number.NaN;
  const lines = [
    line('N.(E-P)', null, [course.offset], [value('N.(E-P)')], values),
    line('N.d', null, [course.rate], [value('N.d')], values),
  ];
  const t = number(found, 't1');
  const point = triple(found, 'P1');
  if (t === undefined || !point) return lines;
  const withT = withScalars(values, { t });
  const holds = asExactly((ar) => {
    const given = valuesOf(shape, ray, ar);
    const withExactT = withScalars(given, { t: evaluate(course.t, ar, given) });
    const X = evaluateTriple(course.P, ar, withExactT);
    return whichHold(course.conditions, withPoint(given, X), ar);
  });
  const conditions = course.conditions.map((relation, i): DerivationLine => {
    const withX = withPoint(withT, point);
    const sides = [relation.left, relation.right].map((side) => evaluate(side, float64, withX));
    return { ...line('inside', null, [], sides, withX), relation, holds: holds[i] ?? null };
  });
  return [
    ...lines,
    line('t', scalar('t'), [course.t], [t], values),
    line('P', scalar('P'), course.P, point, withT),
    ...conditions,
  ];
}

/** The lines that these mistakes change, edited or in their values; at most three. */
export function editedLines(
  mistakes: readonly Misconception[],
  input: Input,
): readonly DerivationLine[] {
  const course = courseOf(input.shape);
  const edited = mistakes.reduce((made: Course, { edit }) => edit(made) ?? made, course);
  if (edited === course) return [];
  const right = linesOf(course, input);
  const wrong = linesOf(edited, input);
  const changed = wrong.filter((one) => {
    const twin = right.find(({ id, relation }) => id === one.id && !relation === !one.relation);
    return !twin || twin.values.join() !== one.values.join() || differs(twin, one);
  });
  return changed.some((one) => right.some((twin) => twin.id === one.id && differs(twin, one)))
    ? changed.slice(0, 3)
    : [];
}

const differs = (a: DerivationLine, b: DerivationLine): boolean =>
  a.exprs.some((expr, i) => expr !== b.exprs[i]) ||
  a.relation?.left !== b.relation?.left ||
  a.relation?.right !== b.relation?.right;
