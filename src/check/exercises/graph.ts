import {
  type Expr,
  evaluate,
  float64,
  minus,
  negative,
  num,
  scalar,
  times,
} from '../../math/formula.ts';
import { display } from '../../text/format.ts';
import { courseOf } from '../course.ts';
import { choiceField, numberField } from '../types.ts';
import { roughCase } from '../work.ts';
import { CASES, type Draft, type Exercise, spreadOver } from './define.ts';
import { drawInput, kindsOf, numberOf } from './draw.ts';
import { withSign } from './words.ts';

const [A, F, G] = [scalar('A'), scalar('F'), scalar('G')];

/** One step of t from where f turns it has changed by A. */
const STEP: Expr = minus(G, F);
/** Where f turns its value is F = −D/4A. */
const READ: Expr = negative(times(num(4), A, F));

/** What can be read off the graph: where f turns, its value there, and one step of t further. */
interface Turn {
  readonly t: number;
  readonly F: number;
  readonly G: number;
  readonly A: number;
}

export function turnOf(draft: Draft): Turn {
  const found = roughCase(courseOf(draft.shape), draft);
  const [a, b, c] = [numberOf(found, 'A'), numberOf(found, 'B'), numberOf(found, 'C')];
  const t = -b / (2 * a);
  const value = (x: number): number => (a * x + b) * x + c;
  return { t, F: value(t), G: value(t + 1), A: a };
}

/** The values of f that the graph shows: two steps to each side of where f turns, and the axis. */
export function shownOf({ F: low, A: a }: Turn): readonly [least: number, most: number] {
  const ends = [low, low + 4 * a, 0, low - Math.sign(a)];
  return [Math.min(...ends), Math.max(...ends)];
}

/** Steps between its numbered lines; there is a thin one in the middle between two. */
const STEPS = [1, 2] as const;
const MOST_LINES = 14;

/** The step with which f can be read; undefined if lines would be too many. */
export const stepOf = (turn: Turn): number | undefined => {
  const [least, most] = shownOf(turn);
  return STEPS.find((step) => (most - least) / step <= MOST_LINES);
};

const isHalf = (x: number): boolean => Number.isInteger(2 * x);

/** Largest |t| and |f| of what is read. */
const MOST_T = 6;
const MOST_F = 10;

/** Whether what is read lies on lines of the grid. */
function isReadable(turn: Turn): boolean {
  const { t, F: low, G: next, A: a } = turn;
  const step = stepOf(turn);
  return (
    step !== undefined &&
    isHalf(t) &&
    [low, next].every((f) => isHalf(f / step)) &&
    Math.abs(t) <= MOST_T &&
    Math.abs(low) <= MOST_F &&
    Math.abs(a) >= 0.5
  );
}

const COUNTED = { '-1': 'none', '0': 'tangent', '1': 'two' } as const;
const caseOf = (D: number): string => COUNTED[String(Math.sign(D)) as keyof typeof COUNTED];

export const graph: Exercise = {
  id: 'graph',
  topic: 'D read off the graph',
  picture: 'graph',
  hidden: 'all',
  paper: true,
  kinds: kindsOf('curved'),
  spread: spreadOver('case', ['none', 'tangent', 'two']),
  draw(random, kind, level, wanted) {
    const input = drawInput(random, kind, level);
    const found = roughCase(courseOf(input.shape), input);
    if (numberOf(found, 'A') === 0 || (wanted !== undefined && found.case !== wanted)) return null;
    const draft: Draft = { ...input, watch: [] };
    const turn = turnOf(draft);
    if (!isReadable(turn)) return null;
    const byA = turn.A === 1 ? [] : ['read-no-a', 'read-distance'];
    return { ...draft, watch: turn.F === 0 ? [] : ['read-sign', 'read-value', ...byA] };
  },
  ask: () =>
    'This is the graph of f(t) = A t² + B t + C along a ray. Read A and D off it, and say in how ' +
    'many points the line of the ray meets the surface.',
  given: [],
  described(draft) {
    const { t, F: low, A: a } = turnOf(draft);
    const at = (x: number): string => `(${display(t + x)}, ${display(low + a * x * x)})`;
    return (
      `The graph of f is a parabola that turns at t = ${display(t)}. It goes through the points ` +
      `(t, f) = ${[-2, -1, 0, 1, 2].map(at).join(', ')}.`
    );
  },
  extend: (course) => ({ ...course, read: READ }),
  fields: () => [numberField('A'), numberField('D'), choiceField('case', 'the line has', CASES)],
  answers(course, draft, own = {}) {
    const turn = turnOf(draft);
    const scalars = { F: turn.F, G: turn.G };
    const number = (id: string, otherwise: number): number => {
      const typed = own[id];
      return typeof typed === 'number' && Number.isFinite(typed) ? typed : otherwise;
    };
    const a = number('A', evaluate(STEP, float64, { scalars, vectors: {} }));
    const values = { scalars: { ...scalars, A: a }, vectors: {} };
    const found = evaluate(course.read ?? READ, float64, values);
    // −0 where f turns on the axis.
    const D = number('D', found === 0 ? 0 : found);
    return { A: a, D, case: caseOf(D) };
  },
  argue(draft) {
    const { t, F: low, G: next, A: a } = turnOf(draft);
    const D = -4 * a * low;
    const points = { none: 'no point', tangent: 'one point: it touches', two: 'two points' };
    return {
      rule: 'Where f turns its value is F = −D/4A; one step of t further it is F + A.',
      put:
        `f turns at t = ${display(t)} with F = ${display(low)}; at t = ${display(t + 1)} it is ` +
        `${display(next)}. What are A and −4 A F?`,
      decision: [
        `At t = ${display(t)}, where f turns, F = ${display(low)}; at t = ${display(t + 1)} f = ` +
          `${display(next)}, so A = ${display(next)} − (${display(low)}) = ${display(a)}.`,
        `D = −4 A F = −4 · (${display(a)}) · (${display(low)}) = ${display(D)}.`,
        `D = ${withSign(D === 0 ? 0 : D)}: ${points[caseOf(D) as keyof typeof points]}.`,
      ],
    };
  },
  stack(course, draft) {
    const turn = turnOf(draft);
    return {
      scalars: { F: turn.F, G: turn.G },
      trees: [
        ['A', STEP],
        ['D', course.read ?? READ],
      ],
    };
  },
  clue: 'A parabola is told by where it turns and by how it has changed one step of t further.',
  lines: [],
};
