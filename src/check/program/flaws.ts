import {
  type Expr,
  evaluate,
  float64,
  negative,
  num,
  over,
  times,
  valuesOf,
  withPoint,
  withScalars,
} from '../../math/formula.ts';
import type { Shape, Vec3 } from '../../math/index.ts';
import { type Course, type CurvedCourse, courseOf } from '../course.ts';
import { findMisconception, MISCONCEPTIONS } from '../misconceptions/index.ts';
import { rewrite } from '../rewrite.ts';
import type { Answers, Input } from '../types.ts';

export interface Root {
  readonly t: number;
  readonly normal: readonly number[];
}

/** An input with the answers of the program's formulas. */
interface About {
  readonly input: Input;
  readonly found: Answers;
}

/** A mistake of programs: in reading the input, in a formula, or in using the roots. */
export interface Flaw {
  readonly id: string;
  /** End of the sentence "it looks like …". */
  readonly says: string;
  /** The line of the derivation where it happens, as in `Misconception`. */
  readonly line: string;
  readonly remedy: string;
  input?(input: Input): Input;
  course?(course: Course): Course | null;
  answer?(roots: readonly Root[], about: About): readonly Root[];
}

const curved =
  (edit: (course: CurvedCourse) => Partial<CurvedCourse>) =>
  (course: Course): Course | null =>
    course.family === 'curved' ? { ...course, ...edit(course) } : null;

const { sign } = Math;
const dot = (a: readonly number[], b: readonly number[]): number =>
  a.reduce((sum, x, i) => sum + x * (b[i] ?? 0), 0);
const turned = (v: readonly number[]): number[] => v.map((x) => -x);
const isCurved = ({ shape }: Input): boolean => courseOf(shape).family === 'curved';
const isFlat = (input: Input): boolean => !isCurved(input);

const FORMULAS: readonly Flaw[] = [
  {
    id: 'minus-b2',
    says: '(−B²) − 4AC in place of B² − 4AC',
    line: 'D',
    remedy: 'The square of B is never negative: (−B)² is B².',
    course: curved(({ D }) => ({
      D: rewrite(D, (e) => (e.op === 'square' ? negative(e) : null)),
    })),
  },
  {
    id: 'half-times-a',
    says: '/ 2 * A in place of / (2 * A)',
    line: 't',
    remedy: 'A program divides by 2 and then multiplies by A: put 2 * A in brackets.',
    course: curved(({ roots, double }) => {
      const edit = (e: Expr): Expr =>
        e.op === 'quotient' ? times(over(e.over, num(2)), { op: 'scalar', id: 'A' }) : e;
      return { roots: edit(roots), double: edit(double) };
    }),
  },
  {
    id: 'unit-assumed',
    says: 'A taken for 1, as if |d| were 1',
    line: 'A',
    remedy: 'd may have any length, and A is no length of d alone: compute it.',
    course: curved(() => ({ A: num(1) })),
  },
];

/** Reads one number of the shape as k times itself. */
const scaled =
  (key: string, k: number) =>
  (input: Input): Input => {
    const value = (input.shape as unknown as Readonly<Record<string, unknown>>)[key];
    if (typeof value !== 'number') return input;
    return { ...input, shape: { ...input.shape, [key]: k * value } as Shape };
  };

const exchanged = (i: number, k: number) => (v: readonly number[]) =>
  v.map((x, at) => (at === i ? v[k] : at === k ? v[i] : x) as number);

/** Takes the axis of a curved shape along another coordinate. */
function axisTaken(axis: string, k: number): Flaw {
  const exchange = exchanged(1, k);
  const vector = (v: unknown): unknown => (Array.isArray(v) ? exchange(v) : v);
  return {
    id: `axis-${axis}`,
    says: `the axis taken along ${axis} in place of y`,
    line: 'A',
    remedy: 'The axis is parallel to y: x and z are what is squared and added.',
    input(input) {
      if (!isCurved(input)) return input;
      const shape = Object.fromEntries(
        Object.entries(input.shape).map(([key, value]) => [key, vector(value)] as const),
      );
      const { origin, direction } = input.ray;
      const ray = {
        origin: exchange(origin) as unknown as Vec3,
        direction: exchange(direction) as unknown as Vec3,
      };
      return { shape: shape as unknown as Shape, ray };
    },
    answer: (roots, { input }) =>
      isCurved(input) ? roots.map(({ t, normal }) => ({ t, normal: exchange(normal) })) : roots,
  };
}

const INPUTS: readonly Flaw[] = [
  {
    id: 'diameter',
    says: 'r taken for the diameter, r/2 in place of r',
    line: 'C',
    remedy: 'The shape’s radius is the radius: do not halve it.',
    input: scaled('radius', 0.5),
  },
  {
    id: 'double-radius',
    says: '2r in place of r, the diameter in place of the radius',
    line: 'C',
    remedy: 'The shape’s radius is the radius: do not double it.',
    input: scaled('radius', 2),
  },
  axisTaken('z', 2),
  axisTaken('x', 0),
];

const NORMALS: readonly Flaw[] = [
  {
    id: 'normal-radial',
    says: 'a normal without its y component, as on a cylinder',
    line: 'N',
    remedy: 'Only a cylinder’s normal has y = 0: elsewhere the surface widens with height.',
    answer: (roots, { input }) =>
      isCurved(input)
        ? roots.map(({ t, normal: [x = 0, , z = 0] }) => ({ t, normal: [x, 0, z] }))
        : roots,
  },
  {
    id: 'normal-facing',
    says: 'the normal turned to face the ray',
    line: 'N',
    remedy: 'The course’s normal is the same from both sides: do not turn it by the sign of N·d.',
    answer: (roots, { input }) =>
      roots.map(({ t, normal }) => ({
        t,
        normal: dot(normal, input.ray.direction) > 0 ? turned(normal) : normal,
      })),
  },
  {
    id: 'flat-normal-turned',
    says: 'the normal turned round, −N in place of N',
    line: 'N',
    remedy: 'The normal is the N that is given.',
    answer: (roots, { input }) =>
      isFlat(input) ? roots.map(({ t, normal }) => ({ t, normal: turned(normal) })) : roots,
  },
];

/** Lets rays hit a flat shape from one side only, where N·d has this sign. */
const oneSided = (id: string, wanted: 1 | -1, side: string): Flaw => ({
  id,
  says: `only rays with N·d ${side} 0 let through, as on a one-sided plane`,
  line: 'N.d',
  remedy: 'A plane is hit from both sides: only N·d = 0 is a case of its own.',
  answer: (roots, { input, found }) =>
    isFlat(input) && sign(Number(found['N.d'])) !== wanted ? [] : roots,
});

/** Whether R(t) is exactly on the border of a figure. */
export function isOnBorder({ input }: About, t: number): boolean {
  const course = courseOf(input.shape);
  if (course.family !== 'flat') return false;
  const values = withScalars(valuesOf(input.shape, input.ray, float64), { t });
  const [x, y, z] = course.P.map((e) => evaluate(e, float64, values)) as [number, number, number];
  const at = withPoint(values, [x, y, z]);
  return course.conditions.some(
    ({ left, right }) => evaluate(left, float64, at) === evaluate(right, float64, at),
  );
}

/** Returns roots unsorted: if A < 0, the root with the minus sign is the larger one. */
const unsorted = (id: string, order: string, swaps: (A: number) => boolean): Flaw => ({
  id,
  says: `the roots returned as ${order}, without putting them in order`,
  line: 't',
  remedy: 'Which of the two is smaller depends on the sign of A: sort them.',
  answer: (roots, { found }) =>
    found.case === 'two' && swaps(Number(found.A)) ? [...roots].reverse() : roots,
});

const inFront = (
  id: string,
  says: string,
  kept: (t: number) => boolean,
  most = Number.POSITIVE_INFINITY,
): Flaw => ({
  id,
  says,
  line: 'first',
  remedy: 'Every root of the whole line is asked for, also those behind E and at E.',
  answer: (roots) => roots.filter(({ t }) => kept(t)).slice(0, most),
});

/** The misconception's t, but with normals at the true points. */
function distanceReturned(id: string, applies: (input: Input) => boolean): Flaw {
  const { says = '', line = '', remedy = '' } = findMisconception(id) ?? {};
  return {
    id,
    says: `${says}, or d made a unit vector first`,
    ...{ line, remedy },
    answer: (roots, { input }) =>
      applies(input)
        ? roots.map(({ t, normal }) => ({ t: t * Math.hypot(...input.ray.direction), normal }))
        : roots,
  };
}

const ROOTS: readonly Flaw[] = [
  distanceReturned('distance', isCurved),
  distanceReturned('flat-distance', isFlat),
  {
    id: 'tangent-twice',
    says: 'a tangent’s one root returned twice',
    line: 'case',
    remedy: 'Where D = 0 both signs give the same root: return it once.',
    answer: (roots, { found }) =>
      found.case === 'tangent' ? roots.flatMap((root) => [root, root]) : roots,
  },
  unsorted('unsorted', '(−B − √D)/2A, (−B + √D)/2A', (A) => A < 0),
  unsorted('unsorted-plus', '(−B + √D)/2A, (−B − √D)/2A', (A) => A > 0),
  oneSided('one-sided', -1, '<'),
  oneSided('one-sided-back', 1, '>'),
  {
    id: 'strict-border',
    says: '< in place of ≤ where the figure ends',
    line: 'inside',
    remedy: 'Rim and edges belong to the figure.',
    answer: (roots, about) => roots.filter(({ t }) => !isOnBorder(about, t)),
  },
  inFront('front-only', 'roots with t < 0 left out', (t) => t >= 0),
  inFront('front-strict', 'only roots with t > 0, or above an epsilon, returned', (t) => t > 1e-4),
  inFront('nearest-only', 'only the smaller root returned', () => true, 1),
  inFront('visible-only', 'only the first root with t ≥ 0 returned', (t) => t >= 0, 1),
  inFront(
    'visible-strict',
    'only the first root with t > 0, or above an epsilon, returned',
    (t) => t > 1e-4,
    1,
  ),
];

/**
 * The misconceptions of the questions and further mistakes of programs, in the order in which they
 * take effect: input, formulas, roots.
 */
export const FLAWS: readonly Flaw[] = [
  ...INPUTS,
  ...MISCONCEPTIONS.map(
    ({ id, says, line, remedy, edit }): Flaw => ({ id, says, line, remedy, course: edit }),
  ),
  ...FORMULAS,
  ...ROOTS,
  ...NORMALS,
];
