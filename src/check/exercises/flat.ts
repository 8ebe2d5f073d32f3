import { courseOf } from '../course.ts';
import { findMisconception } from '../misconceptions/index.ts';
import { choiceField, type Input, numberField } from '../types.ts';
import { roughWork, work } from '../work.ts';
import { type Exercise, spreadOver } from './define.ts';
import {
  allClean,
  chosen,
  drawInput,
  drawUntil,
  hasUnitLength,
  kindsOf,
  numberOf,
} from './draw.ts';

export const INSIDE = [
  { id: 'inside', title: 'inside (rim and edge count)' },
  { id: 'outside', title: 'outside' },
];

const hasBound = ({ shape }: Input): boolean => {
  const course = courseOf(shape);
  return course.family === 'flat' && course.conditions.length > 0;
};

const LINES = ['flat-no-P', 'flat-inverted', 'flat-lost-minus', 'flat-distance'];
const BOUNDS = ['rim-squared', 'corner-as-middle'];

/** Whether the numbers are clean and, unless `plain`, a mistaken bound changes the answer. */
function isFit(input: Input, plain: boolean): boolean {
  const course = courseOf(input.shape);
  const found = roughWork(course, input);
  const t = numberOf(found, 't1');
  if (!(Math.abs(t) > 0 && Math.abs(t) <= 12) || hasUnitLength(input.ray.direction)) return false;
  if (!allClean(found, ['t1', 'P1'])) return false;
  if (!hasBound(input)) return true;
  if (plain) return found.inside === 'outside';
  return BOUNDS.some((id) => {
    const edited = findMisconception(id)?.edit(course);
    return edited && roughWork(edited, input).inside !== found.inside;
  });
}

export const flat: Exercise = {
  id: 'flat',
  topic: 'N·d, t and the figure',
  paper: true,
  kinds: kindsOf('flat'),
  spread: spreadOver('inside', ['inside', 'outside'], { plane: ['inside', 'outside'] }),
  draw(random, kind, level) {
    // One in four has the usual answer, so that the unusual one cannot be guessed.
    const plain = random() < 0.25;
    const input = drawUntil(
      () => drawInput(random, kind, level),
      (drawn) => isFit(drawn, plain),
    );
    const bounds = plain ? [] : BOUNDS;
    return input && { ...input, watch: [...LINES, ...bounds] };
  },
  ask: (draft) =>
    hasBound(draft)
      ? 'Find N·d, the t at which the line of the ray meets the plane, and whether that point is ' +
        'inside.'
      : 'Find N·d, and the t at which the line of the ray meets the plane.',
  given: [],
  fields: (draft) => [
    numberField('N.d', 'N·d'),
    numberField('t1', 't'),
    ...(hasBound(draft) ? [choiceField('inside', 'the point is', INSIDE)] : []),
  ],
  answers: (course, draft, own) => chosen(work(course, draft, own), ['N.d', 't1', 'inside']),
  argue: (draft, found) => ({
    rule: '',
    put: '',
    decision: hasBound(draft)
      ? [
          found.inside === 'inside'
            ? 'What bounds the figure holds: the point is inside.'
            : 'Not all that bounds the figure holds: the point is outside.',
        ]
      : [],
  }),
  clue: 'Put R(t) = E + t d into the equation of the plane and solve for t.',
  lines: ['N.d', 'N.(E-P)', 't', 'P', 'inside'],
};
