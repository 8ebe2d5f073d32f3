import { definitionOf } from '../../math/shapes.ts';
import { courseOf } from '../course.ts';
import { type Answers, choiceField, numberField } from '../types.ts';
import { roughCase, work } from '../work.ts';
import { type Exercise, spreadOver } from './define.ts';
import { allClean, chosen, drawInput, kindsOf, numberOf } from './draw.ts';
import { withSign } from './words.ts';

const SIDES = [
  { id: 'inside', title: 'inside' },
  { id: 'on', title: 'on the surface' },
  { id: 'outside', title: 'outside' },
] as const;

/** C = f(E): where E is, by its sign. */
const sideOf = (C: number): string => (C < 0 ? 'inside' : C === 0 ? 'on' : 'outside');

export const side: Exercise = {
  id: 'side',
  topic: 'inside or outside, by the sign of C',
  paper: true,
  kinds: kindsOf('curved'),
  spread: spreadOver('side', ['inside', 'on', 'outside']),
  draw(random, kind, level, wanted) {
    const input = drawInput(random, kind, level);
    const found = roughCase(courseOf(input.shape), input);
    if (!allClean(found, ['C'])) return null;
    const C = numberOf(found, 'C');
    if (wanted !== undefined && sideOf(C) !== wanted) return null;
    // On the surface is rare among the draws, and outside usual.
    if (wanted === undefined && C > 0 && random() < 0.7) return null;
    return { ...input, watch: ['r-for-r2', 'c-for-c2', 'a2-for-a', 'plus-r2'] };
  },
  ask: ({ shape }) =>
    `Find C, the value of f at t = 0, and say from its sign where E is: inside the ` +
    `${definitionOf(shape).title}, on it or outside.`,
  given: [],
  fields: () => [numberField('C'), choiceField('side', 'E is', SIDES)],
  answers(course, draft, own): Answers {
    const found = chosen(work(course, draft, own), ['C']);
    const C = numberOf(found, 'C');
    return Number.isNaN(C) ? {} : { ...found, side: sideOf(C) };
  },
  argue: (_, found) => {
    const C = numberOf(found, 'C');
    const words = { inside: 'inside', on: 'on the surface', outside: 'outside' }[sideOf(C)];
    return {
      rule: 'f < 0 inside, f = 0 on the surface, f > 0 outside; and f(0) = C.',
      put: '',
      decision: [`C = ${withSign(C)}: E is ${words}.`],
    };
  },
  stack: 'from the ray',
  clue: 'At t = 0 the ray is at E, and A t² + B t + C is C there.',
  lines: ['C'],
};
