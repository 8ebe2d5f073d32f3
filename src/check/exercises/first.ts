import { pick } from '../../math/rng.ts';
import { display } from '../../text/format.ts';
import { choiceField, type Input } from '../types.ts';
import { work } from '../work.ts';
import { type Exercise, spreadOver } from './define.ts';
import { chosen, drawInput, drawUntil, kindsOf, numberOf, withTwoCleanRoots } from './draw.ts';

const WHICH = [
  { id: 't1', title: 't₁' },
  { id: 't2', title: 't₂' },
  { id: 'none', title: 'neither' },
];

const WHY = [
  { id: 'farther', title: 'the other one is farther along the ray' },
  { id: 'behind', title: 'what is left out is behind E' },
];

/** Where the roots lie for each answer. */
const WHERE = [
  { first: 't1', roots: 'in front' },
  { first: 't2', roots: 'around' },
  { first: 'none', roots: 'behind' },
] as const;

/** Where two clean roots lie; null for other inputs. */
function whereRootsAre(input: Input): (typeof WHERE)[number]['roots'] | null {
  const found = withTwoCleanRoots(input);
  if (!found) return null;
  const [t1, t2] = [numberOf(found, 't1'), numberOf(found, 't2')];
  if (t1 === 0 || t2 === 0) return null;
  return t1 > 0 ? 'in front' : t2 > 0 ? 'around' : 'behind';
}

export const first: Exercise = {
  id: 'first',
  topic: 'the first visible hit',
  paper: true,
  kinds: kindsOf('curved'),
  spread: spreadOver('first', ['t1', 't2', 'none']),
  draw(random, kind, level, asked) {
    const wanted =
      WHERE.find(({ first: one }) => one === asked)?.roots ??
      pick(random, ['in front', 'in front', 'around', 'around', 'behind']);
    const input = drawUntil(
      () => drawInput(random, kind, level),
      (drawn) => whereRootsAre(drawn) === wanted,
    );
    return input && { ...input, watch: [wanted === 'in front' ? 'far-root' : 'behind'] };
  },
  ask: () => 'Which of the two roots is the first visible hit, and why not the other?',
  given: ['t1', 't2'],
  fields: () => [
    choiceField('first', 'first visible hit', WHICH),
    choiceField('why', 'because', WHY),
  ],
  answers: (course, draft, own) => chosen(work(course, draft, own), ['first', 'why']),
  argue: (_, found) => {
    const [t1, t2] = [numberOf(found, 't1'), numberOf(found, 't2')];
    const both = `${display(t1)} < ${display(t2)}`;
    const decision =
      t1 >= 0
        ? `0 ≤ ${both}: both are in front of E, t₁ is nearer, t₂ is farther along the ray.`
        : t2 >= 0
          ? `${display(t1)} < 0 ≤ ${display(t2)}: t₁ is behind E, only t₂ is in front of it.`
          : `${both} < 0: both are behind E, so neither is visible.`;
    return {
      rule: 'Of the roots that are not negative, the smallest is seen first.',
      put: `Is ${display(t1)} ≥ 0? Is ${display(t2)} ≥ 0? Which is the smaller of those?`,
      decision: [decision],
    };
  },
  clue: 'A ray starts at E, where t = 0, and runs towards larger t.',
  lines: ['t'],
};
