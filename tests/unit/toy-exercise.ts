import type { Exercise } from '../../src/check/exercises/define.ts';
import {
  chosen,
  drawInput,
  hasUnitLength,
  kindsOf,
  withTwoCleanRoots,
} from '../../src/check/exercises/draw.ts';
import { numberField } from '../../src/check/types.ts';
import { work } from '../../src/check/work.ts';

/** An exercise that is not Graze's own, as a newcomer would add it. */
export const laterRoot: Exercise = {
  id: 'later-root',
  topic: 'the later root',
  paper: true,
  kinds: kindsOf('curved'),
  draw(random, kind, level) {
    const input = drawInput(random, kind, level);
    const found = withTwoCleanRoots(input);
    return found && !hasUnitLength(input.ray.direction)
      ? { ...input, watch: ['b2-ac', 'over-a', 'lost-minus'] }
      : null;
  },
  ask: () => 'Find the root that the line of the ray comes to last.',
  given: ['A', 'B', 'C'],
  fields: () => [numberField('t2', 't₂')],
  answers: (course, draft, own) => chosen(work(course, draft, own), ['t2']),
  clue: 'Both signs of ± give a root each.',
  lines: ['D', 't'],
};
