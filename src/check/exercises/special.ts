import { pick } from '../../math/rng.ts';
import { display } from '../../text/format.ts';
import { courseOf } from '../course.ts';
import { type Answers, choiceField, type Input, mayBeAbsent, numberField } from '../types.ts';
import { roughCase, roughWork, work } from '../work.ts';
import { CASES, type Exercise, spreadOver } from './define.ts';
import {
  allClean,
  chosen,
  drawInput,
  drawUntil,
  kindsOf,
  mayBeStraight,
  numberOf,
} from './draw.ts';
import { caseWords } from './words.ts';

const foundOf = (input: Input): Answers => roughCase(courseOf(input.shape), input);

function isFit(input: Input): boolean {
  const found = foundOf(input);
  if (numberOf(found, 'A') !== 0 || !allClean(found, ['B', 'C'])) return false;
  return found.case !== 'one' || allClean(roughWork(courseOf(input.shape), input), ['t1']);
}

/** A = 0 for a curved shape: a line, with one root or none. */
export const linear: Exercise = {
  id: 'linear',
  topic: 'A = 0',
  paper: true,
  kinds: kindsOf('curved').filter(mayBeStraight),
  spread: spreadOver('case', ['none', 'one', 'contained'], {
    cylinder: ['one'],
    paraboloid: ['none', 'contained'],
  }),
  draw(random, kind, level, wanted) {
    const draw = (): Input => drawInput(random, kind, level);
    if (wanted !== undefined) {
      // A depends on the shape and d alone.
      const straight = drawUntil(draw, (drawn) => foundOf(drawn).A === 0);
      const aimed = (from: Input): Input => {
        const { origin } = draw().ray;
        return { ...from, ray: { ...from.ray, origin } };
      };
      const found =
        straight &&
        drawUntil(
          () => aimed(straight),
          (drawn) => foundOf(drawn).case === wanted && isFit(drawn),
        );
      return found && { ...found, watch: ['a-zero'] };
    }
    const input = drawUntil(draw, isFit);
    // Half of the drawn rays without a root are dropped, as they are too many; a cylinder has no
    // others.
    const { case: verdict } = input ? foundOf(input) : {};
    return input && (verdict !== 'none' || random() < 0.5) ? { ...input, watch: ['a-zero'] } : null;
  },
  ask: () =>
    'In how many points does the line of the ray meet the surface? If it crosses in one, at ' +
    'which t? (Otherwise leave t₁ empty.)',
  given: ['A', 'B', 'C'],
  // The box for t₁ is always shown: whether it is needed is part of the question.
  fields: () => [choiceField('case', 'the line has', CASES), mayBeAbsent(numberField('t1', 't₁'))],
  answers: (course, draft, own) => chosen(work(course, draft, own), ['case', 't1']),
  argue: (_, found) => {
    const [B, C] = [numberOf(found, 'B'), numberOf(found, 'C')];
    const t = found.t1 === undefined ? [] : [`t₁ = −C/B = ${display(numberOf(found, 't1'))}.`];
    return {
      rule: 'One root if B ≠ 0. If B = 0, either every t is a root or none, as C = 0 or not.',
      put: `Which t make ${display(B)} · t + ${C < 0 ? `(${display(C)})` : display(C)} zero?`,
      decision: [caseWords(found), ...t],
    };
  },
  clue: 'With A = 0 no square is left: B t + C = 0.',
  lines: ['A', 'B', 'C', 't'],
};

const PLACES = [
  { id: 'meets', title: 'meets the plane in one point' },
  { id: 'beside', title: 'is parallel, beside the plane' },
  { id: 'in', title: 'lies in the plane' },
];

/** N·d = 0 for a flat one. */
export const parallel: Exercise = {
  id: 'parallel',
  topic: 'the line and the plane',
  paper: true,
  kinds: kindsOf('flat'),
  draw(random, kind, level) {
    const inPlane = random() < 0.5;
    const input = drawUntil(
      () => drawInput(random, kind, level),
      (drawn) => roughWork(courseOf(drawn.shape), drawn).place === (inPlane ? 'in' : 'beside'),
    );
    return input && { ...input, watch: [inPlane ? 'parallel-misses' : 'parallel-lies-in'] };
  },
  ask: () =>
    'How does the line of the ray lie to the plane of the figure? Find N·d and N·(E − P), too.',
  given: [],
  fields: () => [
    numberField('N.d', 'N·d'),
    numberField('N.(E-P)', 'N·(E − P)'),
    choiceField('place', 'the line', PLACES),
  ],
  answers: (course, draft, own) => chosen(work(course, draft, own), ['N.d', 'N.(E-P)', 'place']),
  argue: (_, found) => {
    const [rate, offset] = [numberOf(found, 'N.d'), numberOf(found, 'N.(E-P)')];
    const so = found.place === 'in' ? 'so the line lies in it' : 'so the line passes beside it';
    return {
      rule: '',
      put: '',
      decision: [
        rate === 0
          ? `N·d = 0: parallel. N·(E − P) = ${display(offset)}: E is ` +
            `${offset === 0 ? 'in' : 'not in'} the plane, ${so}.`
          : `N·d = ${display(rate)} is not 0: the line meets the plane in one point.`,
      ],
    };
  },
  clue: 'N·d says how fast the ray nears the plane, N·(E − P) where it starts.',
  lines: ['N.d', 'N.(E-P)'],
};

/** As `parallel`, but the line may also meet the plane. */
export const position: Exercise = {
  ...parallel,
  id: 'parallel.2',
  spread: spreadOver('place', ['meets', 'beside', 'in']),
  draw(random, kind, level, asked) {
    const wanted = asked ?? pick(random, ['meets', 'beside', 'in']);
    const input = drawUntil(
      () => drawInput(random, kind, level),
      (drawn) => roughWork(courseOf(drawn.shape), drawn).place === wanted,
    );
    const watch = { meets: [], beside: ['parallel-lies-in'], in: ['parallel-misses'] }[wanted];
    return input && { ...input, watch: watch ?? [] };
  },
};
