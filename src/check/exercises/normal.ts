import { courseOf } from '../course.ts';
import { directionField } from '../types.ts';
import { roughWork, work } from '../work.ts';
import type { Exercise } from './define.ts';
import { allClean, chosen, drawInput, kindsOf, numberOf } from './draw.ts';

export const normal: Exercise = {
  id: 'normal',
  topic: 'the normal',
  paper: true,
  kinds: kindsOf('curved'),
  draw(random, kind, level) {
    const input = drawInput(random, kind, level);
    const found = roughWork(courseOf(input.shape), input);
    if (!(numberOf(found, 't') >= 0) || !allClean(found, ['t', 'P', 'N'])) return null;
    return {
      ...input,
      watch: ['normal-turned', 'normal-sphere', 'normal-plus', 'normal-factor', 'normal-is-P'],
    };
  },
  ask: () =>
    'Find the course’s normal N at the hit point P. Its length does not matter, its direction ' +
    'does.',
  given: ['P'],
  fields: () => [directionField('N')],
  answers: (course, draft, own) => chosen(work(course, draft, own), ['N']),
  clue: 'The normal is half the gradient of the surface’s equation at P.',
  lines: ['N'],
};
