import { pick } from '../../math/rng.ts';
import { courseOf } from '../course.ts';
import { choiceField, numberField } from '../types.ts';
import { roughCase, work } from '../work.ts';
import { CASES, type Exercise, spreadOver } from './define.ts';
import { allClean, chosen, drawInput, drawUntil, kindsOf, numberOf } from './draw.ts';
import { caseWords } from './words.ts';

export const discriminant: Exercise = {
  id: 'discriminant',
  topic: 'the discriminant and its case',
  paper: true,
  kinds: kindsOf('curved'),
  spread: spreadOver('case', ['none', 'tangent', 'two']),
  draw(random, kind, level, asked) {
    const wanted = asked ?? pick(random, ['none', 'tangent', 'two']);
    const input = drawUntil(
      () => drawInput(random, kind, level),
      (drawn) => {
        const found = roughCase(courseOf(drawn.shape), drawn);
        if (found.case !== wanted || numberOf(found, 'A') === 0) return false;
        return allClean(found, ['A', 'B', 'C', 'D']);
      },
    );
    const strict = wanted === 'tangent' ? ['strict'] : [];
    return input && { ...input, watch: ['b2-ac', 'b2-plus-4ac', ...strict] };
  },
  ask: () => 'Find the discriminant D, and say in how many points the line of the ray meets it.',
  given: ['A', 'B', 'C'],
  fields: () => [numberField('D'), choiceField('case', 'the line has', CASES)],
  answers: (course, draft, own) => chosen(work(course, draft, own), ['D', 'case']),
  argue: (_, found) => ({ rule: '', put: '', decision: [caseWords(found)] }),
  stack: 'from the ray',
  clue: 'The sign of D decides: two roots, one double root, or none.',
  lines: ['D'],
};
