import { pick } from '../../math/rng.ts';
import { display } from '../../text/format.ts';
import { type Course, courseOf } from '../course.ts';
import { type Answers, choiceField } from '../types.ts';
import { roughCase, work } from '../work.ts';
import { byParam, quadraticWords } from './by-param.ts';
import { CASES, type Draft, type Exercise } from './define.ts';
import { drawInput, drawUntil, kindsOf, mayBeStraight, numberOf } from './draw.ts';
import { numberParams, withParam } from './params.ts';
import { caseWords } from './words.ts';

/** Two changes of the parameter that count as "a little": the class must be the same after both. */
const LITTLE = 1 / 64;
const MORE = 1 / 8;

export const crossing: Exercise = {
  id: 'crossing',
  topic: 'a parameter crosses a value',
  paper: true,
  kinds: kindsOf('curved'),
  draw(random, kind, level, wanted) {
    const bySlope =
      wanted === undefined ? random() < 0.5 && mayBeStraight(kind) : wanted === 'A = 0';
    const input = drawUntil(
      () => drawInput(random, kind, level),
      (drawn) => {
        const found = roughCase(courseOf(drawn.shape), drawn);
        return bySlope ? numberOf(found, 'A') === 0 : found.case === 'tangent';
      },
    );
    if (!input) return null;
    const { shape, ray } = input;
    const course = courseOf(shape);
    const [first, ...others] = numberParams(shape);
    const param = first && pick(random, [first, ...others]);
    if (!param) return null;
    const draft: Draft = { shape, ray, param, watch: [bySlope ? 'a-zero' : 'strict'] };
    const near = answersAt(course, draft, LITTLE);
    const wide = answersAt(course, draft, MORE);
    // The class must change, and in the same way for both distances.
    if (near.before !== wide.before || near.after !== wide.after) return null;
    return near.before === near.at && near.at === near.after ? null : draft;
  },
  ask: ({ param }) =>
    `Now ${param?.symbol} crosses ${display(param?.value ?? 0)}, and all else stays. In how many ` +
    `points does the line meet the surface?`,
  given: [],
  fields: ({ param }) => [
    choiceField('before', `just below ${valueWords(param)}`, CASES),
    choiceField('at', `at ${valueWords(param)}`, CASES),
    choiceField('after', `just above ${valueWords(param)}`, CASES),
  ],
  answers: (course, draft) => answersAt(course, draft, LITTLE),
  argue: (draft) => {
    const { param, shape, ray } = draft;
    const by = byParam(draft);
    if (!param || !by) return { rule: '', put: '', decision: [] };
    const { symbol, value } = param;
    const at = (off: number, name: string): string => {
      const input = { shape: withParam(shape, param, value + off), ray };
      return `${symbol} = ${display(value)}${name}: ${caseWords(work(courseOf(shape), input))}`;
    };
    const A = `A = ${quadraticWords(by.A, symbol)}`;
    const D = `D = ${quadraticWords(by.D, symbol)}`;
    return {
      rule: 'The sign of D decides where A ≠ 0; where A = 0, B t + C = 0 is left.',
      put:
        `${A} and ${D}: which signs have they just below, at and just above ` +
        `${valueWords(param)}?`,
      decision: [`${A} and ${D}.`, at(-LITTLE, ' − 1/64'), at(0, ''), at(LITTLE, ' + 1/64')],
    };
  },
  clue: 'Write D, and A, as functions of the parameter, and see where they change their sign.',
  lines: ['A', 'D'],
};

const valueWords = (param: Draft['param']): string =>
  `${param?.symbol} = ${display(param?.value ?? 0)}`;

function answersAt(course: Course, { shape, ray, param }: Draft, by: number): Answers {
  if (!param) return {};
  const caseAt = (value: number): string =>
    String(work(course, { shape: withParam(shape, param, value), ray }).case);
  return {
    before: caseAt(param.value - by),
    at: caseAt(param.value),
    after: caseAt(param.value + by),
  };
}

const CHANGES = ['root count changes at D = 0', 'A = 0', 'always two', 'never any'] as const;

/** What happens where the parameter crosses its value. */
function changeOf({ before, at, after }: Answers): string {
  if (at === 'tangent') return 'root count changes at D = 0';
  if (before === at && at === after) {
    return at === 'two' ? 'always two' : at === 'none' ? 'never any' : 'other';
  }
  return at === 'one' || at === 'none' ? 'A = 0' : 'other';
}

/** As `crossing`, but nothing need change at the value. */
export const passing: Exercise = {
  ...crossing,
  id: 'crossing.2',
  spread: {
    classes: CHANGES,
    without: { cylinder: ['A = 0'], sphere: ['A = 0'], paraboloid: ['A = 0'] },
    of: (_, truth) => changeOf(truth),
  },
  draw(random, kind, level, wanted) {
    const stays = wanted === undefined ? random() >= 0.85 : /always|never/.test(wanted);
    if (!stays) {
      return drawUntil(
        () => crossing.draw(random, kind, level, wanted),
        (drawn) => drawn !== null,
      );
    }
    const input = drawInput(random, kind, level);
    const params = numberParams(input.shape);
    const [first, ...others] = params;
    if (!first) return null;
    const draft: Draft = { ...input, param: pick(random, [first, ...others]), watch: [] };
    const course = courseOf(input.shape);
    const [near, wide] = [answersAt(course, draft, LITTLE), answersAt(course, draft, MORE)];
    const same = near.before === near.at && near.at === near.after;
    const steady = near.before === wide.before && near.after === wide.after;
    return same && steady && ['two', 'none'].includes(String(near.at)) ? draft : null;
  },
};
