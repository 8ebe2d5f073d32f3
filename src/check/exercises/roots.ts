import { numberField } from '../types.ts';
import { work } from '../work.ts';
import type { Exercise } from './define.ts';
import { chosen, drawInput, hasUnitLength, kindsOf, numberOf, withTwoCleanRoots } from './draw.ts';
import { withSign } from './words.ts';

export const roots: Exercise = {
  id: 'roots',
  topic: 'both roots',
  paper: true,
  kinds: kindsOf('curved'),
  draw(random, kind, level) {
    const input = drawInput(random, kind, level);
    const found = withTwoCleanRoots(input);
    if (!found || hasUnitLength(input.ray.direction)) return null;
    // With B² + 4AC < 0 there would be no roots to compare with.
    const B = numberOf(found, 'B');
    const otherD = B * B + 4 * numberOf(found, 'A') * numberOf(found, 'C');
    const plus = otherD > 0 ? ['b2-plus-4ac'] : [];
    return {
      ...input,
      watch: ['b2-ac', ...plus, 'over-a', 'lost-minus', 'distance', 'swapped-roots'],
    };
  },
  ask: () => 'Find both roots, the smaller one first.',
  given: ['A', 'B', 'C'],
  fields: () => [numberField('t1', 't₁'), numberField('t2', 't₂')],
  answers: (course, draft, own) => chosen(work(course, draft, own), ['t1', 't2']),
  argue: (_, found) => ({
    rule: '',
    put: '',
    decision:
      numberOf(found, 'A') < 0
        ? [`A = ${withSign(numberOf(found, 'A'))}: the plus sign gives the smaller root, t₁.`]
        : [`A = ${withSign(numberOf(found, 'A'))}: the minus sign gives the smaller root, t₁.`],
  }),
  stack: 'from the ray',
  clue: 'Work out D first. Then both signs of ± give a root each; where A < 0 the order turns.',
  lines: ['D', 't'],
};
