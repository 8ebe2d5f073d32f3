import { seeded } from '../../math/rng.ts';
import { display } from '../../text/format.ts';
import { courseOf } from '../course.ts';
import { findMisconception } from '../misconceptions/index.ts';
import { choiceField, numberField } from '../types.ts';
import { roughWork, work } from '../work.ts';
import { CASES, type Exercise } from './define.ts';
import { chosen, drawInput, drawShape, kindsOf, numberOf, withTwoCleanRoots } from './draw.ts';
import { caseWords } from './words.ts';

/** The shapes that have a second nappe to forget. */
const kinds = () =>
  kindsOf('curved').filter((kind) =>
    findMisconception('one-nappe')?.edit(courseOf(drawShape(seeded(1), kind, 1))),
  );

export const nappes: Exercise = {
  id: 'nappes',
  topic: 'the nappes of a cone',
  paper: true,
  kinds: kinds(),
  draw(random, kind, level) {
    const input = drawInput(random, kind, level);
    const course = courseOf(input.shape);
    const found = withTwoCleanRoots(input);
    if (!found) return null;
    const forgetful = findMisconception('one-nappe')?.edit(course);
    if (!forgetful || roughWork(forgetful, input).case !== 'one') return null;
    if (!(numberOf(found, 't1') > 0)) return null;
    return { ...input, watch: ['one-nappe', 'far-root'] };
  },
  ask: () => 'In how many points does the line meet the cone, and at which t does the ray first?',
  given: ['A', 'B', 'C'],
  fields: () => [choiceField('case', 'the line has', CASES), numberField('t', 't')],
  answers: (course, draft, own) => chosen(work(course, draft, own), ['case', 't']),
  argue: (_, found) => ({
    rule:
      'Both nappes belong to the cone; of the roots that are not negative the smallest comes ' +
      'first.',
    put: '',
    decision: [
      caseWords(found),
      `0 ≤ ${display(numberOf(found, 't1'))} < ${display(numberOf(found, 't2'))}: t₁ comes first.`,
    ],
  }),
  clue: 'At height h the radius is |c·h|, also below the vertex.',
  lines: ['D', 't'],
};
