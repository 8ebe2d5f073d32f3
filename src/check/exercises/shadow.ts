import { pick } from '../../math/rng.ts';
import { display } from '../../text/format.ts';
import { choiceField, type Input } from '../types.ts';
import { work } from '../work.ts';
import { type Exercise, spreadOver } from './define.ts';
import { chosen, drawInput, drawUntil, kindsOf, numberOf, withTwoCleanRoots } from './draw.ts';

const SHADOW = [
  { id: 'lit', title: 'E is lit' },
  { id: 'dark', title: 'E is in the shadow' },
];

/** Misconceptions that take the other answer for right. */
const TEMPTING = [
  { for: 'lit', id: 'behind' },
  { for: 'lit', id: 'no-light-bound' },
  { for: 'dark', id: 'far-root' },
] as const;

/** Id of the misconception that this input reveals; null if the numbers are not clean. */
function tempting(input: Input): string | null {
  const found = withTwoCleanRoots(input);
  if (!found) return null;
  const [t1, t2] = [numberOf(found, 't1'), numberOf(found, 't2')];
  if ([t1, t2].some((t) => t === 0 || t === 1)) return null;
  if (t2 < 0) return 'behind';
  if (t1 > 1) return 'no-light-bound';
  return t1 > 0 && t2 > 1 ? 'far-root' : null;
}

export const shadow: Exercise = {
  id: 'shadow',
  topic: 'a shadow ray',
  paper: true,
  kinds: kindsOf('curved'),
  spread: spreadOver('shadow', ['lit', 'dark']),
  draw(random, kind, level, wanted) {
    const [any, ...others] = TEMPTING;
    const [first = any, ...more] = TEMPTING.filter((one) => one.for === wanted);
    const { id: watched } = pick(random, wanted ? [first, ...more] : [any, ...others]);
    const input = drawUntil(
      () => drawInput(random, kind, level),
      (drawn) => tempting(drawn) === watched,
    );
    return input && { ...input, watch: [watched] };
  },
  ask: () => 'A light stands at E + d. Does the surface hide it from E?',
  given: ['t1', 't2'],
  fields: () => [choiceField('shadow', 'then', SHADOW)],
  answers: (course, draft, own) => chosen(work(course, draft, own), ['shadow']),
  argue: (_, found) => {
    const ts = ['t1', 't2'].map((id) => numberOf(found, id));
    const names = ['t₁', 't₂'];
    const where = (t: number): string =>
      t < 0 ? 'behind E' : t < 1 ? 'between E and the light' : 'beyond the light';
    const each = ts.map((t, i) => `${names[i]} = ${display(t)} is ${where(t)}`);
    const hides = ts.some((t) => t > 0 && t < 1);
    const so = hides ? 'the surface stands before the light' : 'nothing stands before the light';
    return {
      rule: 'A point hides the light if 0 < t < 1 there.',
      put: ts.map((t) => `Does ${display(t)} lie between 0 and 1?`).join(' '),
      decision: [`${each.join(', ')}: ${so}.`],
    };
  },
  clue: 'The light is at t = 1. Only what lies between E and the light can hide it.',
  lines: ['t'],
};
