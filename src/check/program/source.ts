import { type Expr, type Names, printCode, TYPESCRIPT } from '../../math/formula.ts';
import type { Shape } from '../../math/index.ts';
import { seeded } from '../../math/rng.ts';
import { AXES, definitionOf, type ShapeKind } from '../../math/shapes.ts';
import { type Course, type CurvedCourse, courseOf, type FlatCourse } from '../course.ts';
import { drawShape } from '../exercises/draw.ts';

/** Names in programs: a shape's point gets a 0 (C0, P0), since C is a coefficient and P a hit. */
const NAMES: Names = {
  scalar: (id) => id,
  vector: (id) => (/^[A-Z]$/.test(id) && id !== 'E' && id !== 'N' ? `${id}0` : id),
};

const code = (expr: Expr, branch: 1 | -1 = 1): string =>
  printCode(expr, TYPESCRIPT, NAMES, { branch });
const triple = (exprs: readonly Expr[]): string => `[${exprs.map((e) => code(e)).join(', ')}]`;

/** An edit of the formulas; null if it does not apply. */
type CourseEdit = (course: Course) => Course | null;

const UNEDITED: CourseEdit = (course) => course;

/**
 * A program that evaluates the right or edited formulas of this shape as their trees are written:
 * used as the sandbox's textbook method, as the example, and by tests of each misconception.
 */
export function programOf(
  kind: ShapeKind,
  edit: CourseEdit = UNEDITED,
  name = 'intersect',
  before: readonly string[] = [],
): string | null {
  const shape = drawShape(seeded(1), kind, 1);
  const course = edit(courseOf(shape));
  if (!course) return null;
  const body = course.family === 'curved' ? curved(course) : flat(course, insideTest(shape, edit));
  const lines = [...before, ...symbolsOf(shape), ...body].map((line) => `  ${line}`);
  return [`function ${name}(shape, ray) {`, ...lines, '}', ''].join('\n');
}

/** The figure's conditions as one expression, which selects by the axis if the shape has one. */
function insideTest(shape: Shape, edit: CourseEdit): string | null {
  const axis = definitionOf(shape).params.find(({ type }) => type === 'axis');
  const testOf = (one: Shape): string | null => {
    const course = edit(courseOf(one));
    if (course?.family !== 'flat' || course.conditions.length === 0) return null;
    return course.conditions
      .map(({ left, right }) => `${code(left)} <= ${code(right)}`)
      .join(' && ');
  };
  if (!axis) return testOf(shape);
  const tests = AXES.map(
    (value) => `${value}: ${testOf({ ...shape, [axis.key]: value } as Shape)}`,
  );
  return `{ ${tests.join(', ')} }[shape.${axis.key}]`;
}

/**
 * Declarations of the symbols: const E = ray.origin, …; a normal N from the axis if there is one.
 */
function symbolsOf(shape: Shape): string[] {
  const params = definitionOf(shape).params.map((param) =>
    param.type === 'axis'
      ? `const N = ['x', 'y', 'z'].map((axis) => (axis === shape.${param.key} ? 1 : 0));`
      : `const ${param.type === 'vector' ? NAMES.vector(param.symbol) : param.symbol} = ` +
        `shape.${param.key};`,
  );
  return ['const E = ray.origin;', 'const d = ray.direction;', ...params];
}

function curved(course: CurvedCourse): string[] {
  const { rules } = course;
  const one = (t: Expr): string => `return answer([${code(t)}]);`;
  const zero = { handled: 'A === 0', epsilon: 'Math.abs(A) < 1e-6', ignored: '' }[rules.linear];
  const double = { counts: 'D === 0', epsilon: 'Math.abs(D) < 1e-6', lost: '' }[rules.tangent];
  const miss = rules.tangent === 'lost' ? 'D <= 0' : 'D < 0';
  const nappe = rules.nappes === 'upper' ? `.filter((t) => ${code(course.P[1])} >= V0[1])` : '';
  const order = rules.order === 'ascending' ? 'a - b' : 'b - a';
  return [
    `const A = ${code(course.A)};`,
    `const B = ${code(course.B)};`,
    `const C = ${code(course.C)};`,
    `const D = ${code(course.D)};`,
    'const answer = (roots) => {',
    `  const t = roots${nappe};`,
    '  const normal = t.map((t) => {',
    `    const [x, y, z] = ${triple(course.P)};`,
    `    return ${triple(course.N)};`,
    '  });',
    '  return { t, normal };',
    '};',
    ...(zero
      ? [`if (${zero}) {`, '  if (B === 0) return { t: [] };', `  ${one(course.linear)}`, '}']
      : []),
    ...(double ? [`if (${double}) ${one(course.double)}`] : []),
    `if (${miss}) return { t: [] };`,
    `return answer([${code(course.roots, -1)}, ${code(course.roots, 1)}].sort((a, b) => ` +
      `${order}));`,
  ];
}

function flat({ rate, t, P }: FlatCourse, inside: string | null): string[] {
  return [
    `if (${code(rate)} === 0) return { t: [] };`,
    `const t = ${code(t)};`,
    ...(inside === null
      ? []
      : [
          `const [x, y, z] = ${triple(P)};`,
          `const ${NAMES.vector('X')} = [x, y, z];`,
          `const inside = ${inside};`,
          'if (!inside) return { t: [] };',
        ]),
    'return { t: [t], normal: [N] };',
  ];
}
