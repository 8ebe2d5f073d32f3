import type { Expr } from '../../math/formula/expr.ts';
import { type Names, printCode } from '../../math/formula/print/code-notation.ts';
import { TYPESCRIPT } from '../../math/formula/print/languages.ts';
import type { Shape } from '../../math/shapes/index.ts';
import { definitionOf } from '../../math/shapes/lookup.ts';
import type { Course, CurvedCourse, FlatCourse } from '../course.ts';

/** The centre C and the coefficient C cannot both be C in a program; nor can the point P and its value. */
const NAMES: Names = {
  scalar: (id) => id,
  vector: (id) => (/^[A-Z]$/.test(id) && id !== 'E' && id !== 'N' ? `${id}0` : id),
};

const code = (expr: Expr, branch: 1 | -1 = 1): string =>
  printCode(expr, TYPESCRIPT, NAMES, { branch });
const triple = (exprs: readonly Expr[]): string => `[${exprs.map((e) => code(e)).join(', ')}]`;

/**
 * A program that computes just what these (right or edited) formulas say, in the order of their trees: the textbook
 * method of the sandbox, the examples, and in the tests one program for each misconception.
 */
export function programOf(course: Course, shape: Shape, name = 'intersect'): string {
  const body = course.family === 'curved' ? curved(course) : flat(course);
  const lines = [...symbolsOf(shape), ...body].map((line) => `  ${line}`);
  return [`function ${name}(shape, ray) {`, ...lines, '}', ''].join('\n');
}

/** const E = ray.origin, …; the square's normal follows from its axis. */
function symbolsOf(shape: Shape): string[] {
  const params = definitionOf(shape).params.map((param) =>
    param.type === 'axis'
      ? `const N = ['x', 'y', 'z'].map((axis) => (axis === shape.${param.key} ? 1 : 0));`
      : `const ${param.type === 'vector' ? NAMES.vector(param.symbol) : param.symbol} = shape.${param.key};`,
  );
  return ['const E = ray.origin;', 'const d = ray.direction;', ...params];
}

function curved(course: CurvedCourse): string[] {
  const { rules } = course;
  const one = (t: Expr): string => `return { t: [${code(t)}], normal: normalsAt([${code(t)}]) };`;
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
    'const normalsAt = (ts) =>',
    '  ts.map((t) => {',
    `    const [x, y, z] = ${triple(course.P)};`,
    `    return ${triple(course.N)};`,
    '  });',
    ...(zero
      ? [`if (${zero}) {`, '  if (B === 0) return { t: [] };', `  ${one(course.linear)}`, '}']
      : []),
    ...(double ? [`if (${double}) ${one(course.double)}`] : []),
    `if (${miss}) return { t: [] };`,
    `const t = [${code(course.roots, -1)}, ${code(course.roots, 1)}]${nappe}.sort((a, b) => ${order});`,
    'return { t, normal: normalsAt(t) };',
  ];
}

function flat({ rate, t, P, conditions }: FlatCourse): string[] {
  const inside = conditions.map(({ left, right }) => `${code(left)} <= ${code(right)}`);
  return [
    `if (${code(rate)} === 0) return { t: [] };`,
    `const t = ${code(t)};`,
    ...(inside.length === 0
      ? []
      : [
          `const [x, y, z] = ${triple(P)};`,
          `const ${NAMES.vector('X')} = [x, y, z];`,
          `if (!(${inside.join(' && ')})) return { t: [] };`,
        ]),
    'return { t: [t], normal: [N] };',
  ];
}
