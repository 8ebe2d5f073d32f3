import { pick, seeded } from '../../math/rng.ts';
import { display } from '../../text/format.ts';
import { courseOf } from '../course.ts';
import { findMisconception } from '../misconceptions/index.ts';
import { choiceField, mayBeAbsent, numberField } from '../types.ts';
import { roughCase, roughWork, work } from '../work.ts';
import { CASES, type Exercise, spreadOver } from './define.ts';
import {
  allClean,
  chosen,
  drawInput,
  drawShape,
  drawUntil,
  kindsOf,
  numberOf,
  withTwoCleanRoots,
} from './draw.ts';
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

const COUNTS = ['none', 'tangent', 'one', 'two'] as const;

/** As `nappes`, but the line may also miss the cone, touch it, or cross it once where A = 0. */
export const allNappes: Exercise = {
  ...nappes,
  id: 'nappes.2',
  spread: spreadOver('case', COUNTS),
  draw(random, kind, level, asked) {
    const wanted = asked ?? pick(random, [...COUNTS]);
    if (wanted === 'two') {
      return drawUntil(
        () => nappes.draw(random, kind, level),
        (drawn) => drawn !== null,
      );
    }
    const input = drawUntil(
      () => drawInput(random, kind, level),
      (drawn) => {
        const course = courseOf(drawn.shape);
        const letters = roughCase(course, drawn);
        if (letters.case !== wanted || !allClean(letters, ['A', 'B', 'C'])) return false;
        if (wanted === 'none') return true;
        const found = roughWork(course, drawn);
        return numberOf(found, 't1') > 0 && allClean(found, ['t1']);
      },
    );
    return input && { ...input, watch: [] };
  },
  ask: () =>
    'In how many points does the line meet the cone, and at which t does the ray first? (Leave t ' +
    'empty if it never does.)',
  fields: () => [choiceField('case', 'the line has', CASES), mayBeAbsent(numberField('t', 't'))],
  argue: (draft, found) => {
    const { rule = '', put = '', decision = [] } = nappes.argue?.(draft, found) ?? {};
    const [counted = ''] = decision;
    const t = numberOf(found, 't');
    const second = found.case === 'two' ? decision.slice(1) : [];
    const only = found.case === 'two' || Number.isNaN(t) ? [] : [`The root is t = ${display(t)}.`];
    return { rule, put, decision: [counted, ...second, ...only] };
  },
};
