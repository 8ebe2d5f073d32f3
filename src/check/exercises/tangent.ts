import { evaluate, evaluateTriple, float64, valuesOf, withScalars } from '../../math/formula.ts';
import { pick } from '../../math/rng.ts';
import { display } from '../../text/format.ts';
import { type Course, courseOf } from '../course.ts';
import { type Answers, type Input, numberField } from '../types.ts';
import { roughCase } from '../work.ts';
import { byParam, quadraticWords } from './by-param.ts';
import type { Draft, Exercise } from './define.ts';
import { drawInput, kindsOf, numberOf } from './draw.ts';
import { numberParams } from './params.ts';

const WATCH = ['r-for-r2', 'c-for-c2', 'a2-for-a', 'plus-y', 'b2-ac', 'plus-r2'];

export const tangent: Exercise = {
  id: 'tangent',
  topic: 'make the ray tangent',
  paper: true,
  kinds: kindsOf('curved'),
  draw(random, kind, level) {
    const { shape, ray } = drawInput(random, kind, level);
    const course = courseOf(shape);
    const found = roughCase(course, { shape, ray });
    if (found.case !== 'tangent' || numberOf(found, 'C') === 0) return null;
    const [first, ...others] = numberParams(shape).filter(({ value }) => value > 0);
    const param = first && pick(random, [first, ...others]);
    if (!param) return null;
    const draft: Draft = { shape, ray, param, watch: [] };
    const [root, another] = tangentValues(course, draft);
    if (root === undefined || another !== undefined) return null;
    // The drawn value may be a double root of D, where D does not change its sign.
    if (Math.abs(root - param.value) > NO_LINE) return null;
    return { ...draft, watch: WATCH };
  },
  ask: ({ param }) =>
    `Which positive ${param?.symbol} makes the ray’s line tangent to the surface? (The value is ` +
    `to be found; all else stays.)`,
  asksForParam: true,
  given: [],
  fields: ({ param }) => [numberField('value', param?.symbol)],
  answers(course, draft): Answers {
    const [value, another] = isOther(course, draft)
      ? tangentValues(course, draft)
      : rightValues(draft);
    return value === undefined || another !== undefined ? {} : { value };
  },
  argue: (draft) => {
    const by = byParam(draft);
    if (!draft.param || !by) return { rule: '', put: '', decision: [] };
    const { symbol, value } = draft.param;
    const { start, linear, square } = by.D;
    const form = `D = ${quadraticWords(by.D, symbol)}`;
    // Without a linear term p² is given, and p is a square root.
    const zero = -start / square;
    const so =
      linear === 0
        ? `${symbol}² = ${display(zero)}, so ${symbol} = √${display(zero)} = ${display(value)}`
        : `${symbol} = ${display(value)}`;
    return {
      rule: '',
      put: `With everything but ${symbol} put in, ${form}. For which ${symbol} > 0 is that 0?`,
      decision: [`${form} is 0 for ${so}.`],
    };
  },
  clue: 'Tangent means D = 0. Write D with the parameter as the unknown.',
  lines: ['A', 'B', 'C', 'D'],
};

/** Whether A, B, C or D is edited, on which the value depends. */
function isOther(course: Course, { shape }: Draft): boolean {
  const right = courseOf(shape);
  if (course.family === 'flat' || right.family === 'flat') return true;
  return (['A', 'B', 'C', 'D'] as const).some((id) => course[id] !== right[id]);
}

const known = new WeakMap<Draft, number[]>();

/** Cached, since the search takes long and most mistakes are on other lines. */
function rightValues(draft: Draft): number[] {
  const found = known.get(draft) ?? tangentValues(courseOf(draft.shape), draft);
  known.set(draft, found);
  return found;
}

const LARGEST = 27;
/** Intervals in which a root is looked for; odd, so that none ends at a likely root. */
const STEPS = 367;
const HALVINGS = 52;

/** The positive values of the parameter, up to `LARGEST`, where D changes sign and A is not 0. */
function tangentValues(course: Course, { shape, ray, param }: Draft): number[] {
  if (!param) return [];
  const at = coefficientsBy(course, { shape, ray }, param.symbol);
  const D = (value: number): number => at(value).D;
  const found: number[] = [];
  let before = D(LARGEST / STEPS / 2);
  for (let i = 1; i <= STEPS; i++) {
    const [low, high] = [(LARGEST * (i - 0.5)) / STEPS, (LARGEST * (i + 0.5)) / STEPS];
    const after = D(high);
    if (before * after < 0) found.push(bisect(D, low, high));
    before = after;
  }
  return found.filter((value) => Math.abs(at(value).A) > NO_LINE);
}

/** |A| below this counts as 0, where the ray is no tangent: f is linear. Other |A| are about 1. */
const NO_LINE = 1e-6;

/** A and D as functions of one parameter. */
function coefficientsBy(
  course: Course,
  { shape, ray }: Input,
  symbol: string,
): (value: number) => { readonly A: number; readonly D: number } {
  if (course.family === 'flat') return () => ({ A: Number.NaN, D: Number.NaN });
  const rest = valuesOf(shape, ray, float64);
  return (value) => {
    const values = withScalars(rest, { [symbol]: value });
    const [A, B, C] = evaluateTriple([course.A, course.B, course.C], float64, values);
    return { A, D: evaluate(course.D, float64, withScalars(values, { A, B, C })) };
  };
}

function bisect(f: (x: number) => number, from: number, to: number): number {
  let [low, high] = [from, to];
  const rising = f(low) < 0;
  for (let i = 0; i < HALVINGS; i++) {
    const middle = (low + high) / 2;
    const value = f(middle);
    if (value === 0) return middle;
    if (value < 0 === rising) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}
