import { courseOf } from '../course.ts';
import { numberField } from '../types.ts';
import { roughCase, work } from '../work.ts';
import type { Exercise } from './define.ts';
import { allClean, chosen, drawInput, kindsOf } from './draw.ts';

const IDS = ['A', 'B', 'C'];

export const coefficients: Exercise = {
  id: 'coefficients',
  topic: 'the coefficients A, B, C',
  paper: true,
  kinds: kindsOf('curved'),
  draw(random, kind, level) {
    const input = drawInput(random, kind, level);
    if (!allClean(roughCase(courseOf(input.shape), input), IDS)) return null;
    return {
      ...input,
      watch: [
        ...['r-for-r2', 'c-for-c2', 'a2-for-a', 'plus-y', 'half-b'],
        ...['swap-E-d', 'C-minus-E', 'plus-r2'],
      ],
    };
  },
  ask: () => 'Put the ray into the equation of the surface: find A, B and C of A t² + B t + C = 0.',
  given: [],
  fields: () => IDS.map((id) => numberField(id)),
  answers: (course, draft, own) => chosen(work(course, draft, own), IDS),
  stack: 'from the ray',
  clue: 'Write E + t d for (x, y, z) and sort by powers of t.',
  lines: IDS,
};
