import { display } from '../../text/format.ts';
import { tripleField } from '../types.ts';
import { work } from '../work.ts';
import type { Exercise } from './define.ts';
import {
  allClean,
  chosen,
  drawInput,
  hasUnitLength,
  kindsOf,
  numberOf,
  withTwoCleanRoots,
} from './draw.ts';

export const point: Exercise = {
  id: 'point',
  topic: 'the hit point',
  paper: true,
  kinds: kindsOf('curved'),
  draw(random, kind, level) {
    const input = drawInput(random, kind, level);
    const found = withTwoCleanRoots(input);
    if (!found || !allClean(found, ['P1', 'P2'])) return null;
    const [t1, t2] = [numberOf(found, 't1'), numberOf(found, 't2')];
    if (t1 === 0 || !(t2 > 0) || hasUnitLength(input.ray.direction)) return null;
    const which = t1 > 0 ? 'far-root' : 'behind';
    return { ...input, watch: [which, 'from-origin', 'backwards', 'unit-d'] };
  },
  ask: () => 'At which point P does the ray first meet the surface?',
  given: ['t1', 't2'],
  fields: () => [tripleField('P')],
  answers: (course, draft, own) => chosen(work(course, draft, own), ['P']),
  argue: (_, found) => {
    const [t1, t2] = [numberOf(found, 't1'), numberOf(found, 't2')];
    return {
      rule: '',
      put: '',
      decision: [
        t1 >= 0
          ? `0 ≤ ${display(t1)} < ${display(t2)}: the ray meets t₁ first.`
          : `${display(t1)} < 0 ≤ ${display(t2)}: t₁ is behind E, so the ray meets t₂ first.`,
      ],
    };
  },
  clue: 'Choose the root that is seen first, and go that many lengths of d from E.',
  lines: ['P'],
};
