import { capsOf } from '../../math/drawing.ts';
import { pick, type Random } from '../../math/rng.ts';
import { definitionOf } from '../../math/shapes.ts';
import { display } from '../../text/format.ts';
import type { Course } from '../course.ts';
import { type Answers, choiceField, mayBeAbsent, numberField } from '../types.ts';
import { work } from '../work.ts';
import { type Draft, type Exercise, spreadOver } from './define.ts';
import { allClean, drawInput, drawUntil, kindsOf, numberOf, withTwoCleanRoots } from './draw.ts';

const CUT = [
  { id: 'none', title: 'neither root' },
  { id: 't1', title: 't₁' },
  { id: 't2', title: 't₂' },
  { id: 'both', title: 'both roots' },
] as const;
type Cut = (typeof CUT)[number]['id'];
const IDS = ['none', 't1', 't2', 'both'] as const satisfies readonly Cut[];

/** Which roots are cut off, first and second. */
const isCut: Readonly<Record<Cut, readonly [boolean, boolean]>> = {
  none: [false, false],
  t1: [true, false],
  t2: [false, true],
  both: [true, true],
};

const idOf = ([first, second]: readonly [boolean, boolean]): Cut =>
  first ? (second ? 'both' : 't1') : second ? 't2' : 'none';

interface Root {
  readonly t: number;
  readonly y: number;
}

function rootsOf(found: Answers): readonly [Root, Root] {
  const at = (i: 1 | 2): Root => {
    const P = found[`P${i}`];
    return { t: numberOf(found, `t${i}`), y: typeof P === 'object' ? P[1] : Number.NaN };
  };
  return [at(1), at(2)];
}

/** Largest |t|, and height of a root, so that a shape of a usual size is left. */
const MOST = 12;

const HALVES = [0.5, 1, 1.5, 2, 3] as const;

/** Heights that leave just these roots, some of them at a root itself; null if there are none. */
function heightsFor(
  random: Random,
  wanted: Cut,
  [{ y: a }, { y: b }]: readonly [Root, Root],
): readonly [number, number] | null {
  const [under, over] = [Math.min(a, b), Math.max(a, b)];
  const half = (y: number): number => Math.round(2 * y) / 2;
  const step = (): number => pick(random, [...HALVES]);
  const [firstCut, secondCut] = isCut[wanted];
  const lowCut = a < b ? firstCut : secondCut;
  const highCut = a < b ? secondCut : firstCut;
  const low = half(under) + (lowCut ? step() : random() < 0.2 ? 0 : -step());
  const high = half(over) + (highCut ? -step() : random() < 0.2 ? 0 : step());
  const bothAbove: readonly [number, number] = [half(under) - 4 - step(), half(under) - step()];
  const [from, to] = wanted === 'both' && random() < 0.4 ? bothAbove : [low, high];
  if (!(from < to)) return null;
  const is = ({ y }: Root): boolean => y < from || y > to;
  return idOf([is({ t: 0, y: a }), is({ t: 0, y: b })]) === wanted ? [from, to] : null;
}

const betweenOf = ({ between }: Draft): readonly [number, number] =>
  between ?? [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY];

function answers(course: Course, draft: Draft, own: Answers = {}): Answers {
  const found = work(course, draft, own);
  const roots = rootsOf(found);
  if (roots.some(({ t, y }) => Number.isNaN(t) || Number.isNaN(y))) return {};
  const [low, high] = betweenOf(draft);
  const isOut = (x: number): boolean => course.ends !== 'forgotten' && (x < low || x > high);
  const out = ({ t, y }: Root): boolean => isOut(course.ends === 't' ? t : y);
  const cut = idOf([out(roots[0]), out(roots[1])]);
  const said = CUT.find(({ id }) => id === own.cut)?.id ?? cut;
  const { behind, first } = course.rules;
  const seen = roots
    .filter((_, i) => !isCut[said][i])
    .map(({ t }) => t)
    .filter((t) => t >= 0 || behind === 'accepted');
  if (seen.length === 0) return { cut };
  return { cut, t: first === 'nearest' ? Math.min(...seen) : Math.max(...seen) };
}

export const cut: Exercise = {
  id: 'cut',
  topic: 'which root is cut off',
  paper: true,
  kinds: kindsOf('curved'),
  spread: spreadOver('cut', IDS),
  draw(random, kind, level, asked) {
    const input = drawUntil(
      () => drawInput(random, kind, level),
      (drawn) => {
        const found = withTwoCleanRoots(drawn);
        if (!found || drawn.ray.direction[1] === 0 || !allClean(found, ['P1', 'P2'])) return false;
        return rootsOf(found).every(({ t, y }) => Math.abs(t) <= MOST && Math.abs(y) <= MOST);
      },
    );
    const found = input && withTwoCleanRoots(input);
    if (!input || !found) return null;
    const wanted = CUT.find(({ id }) => id === asked)?.id ?? pick(random, IDS);
    const between = heightsFor(random, wanted, rootsOf(found));
    // Beyond both roots there may be nothing of a sphere or a paraboloid.
    if (!between || (wanted === 'both' && capsOf(input.shape, between).length === 0)) return null;
    const forgotten = wanted === 'none' ? [] : ['ends-forgotten'];
    return { ...input, between, watch: ['ends-by-t', ...forgotten] };
  },
  ask: (draft) => {
    const [low, high] = betweenOf(draft);
    return (
      `Only the part of the ${definitionOf(draft.shape).title} from y = ${display(low)} to y = ` +
      `${display(high)} is there, rims included, and its ends are open. Which root is cut off? ` +
      `And what is the t of the first visible hit? (Leave t empty if there is none.)`
    );
  },
  given: ['t1', 't2'],
  extend: (course) => ({ ...course, ends: 'height' }),
  fields: () => [choiceField('cut', 'cut off is', CUT), mayBeAbsent(numberField('t', 't'))],
  answers,
  argue: (draft, found) => {
    const [low, high] = betweenOf(draft);
    const names = ['t₁', 't₂'];
    const roots = rootsOf(found);
    const where = (y: number): string =>
      y < low
        ? `< ${display(low)}: cut off`
        : y > high
          ? `> ${display(high)}: cut off`
          : `is between ${display(low)} and ${display(high)}: it stays`;
    const each = roots.map(({ y }, i) => `${names[i]}: y = ${display(y)} ${where(y)}.`);
    const left = roots.filter(({ y }) => y >= low && y <= high).map(({ t }) => t);
    const ahead = left.filter((t) => t >= 0);
    const none = left.length === 0 ? 'No root is left' : 'What is left lies behind E, where t < 0';
    const first =
      ahead.length > 0
        ? `Of what is left and not behind E, t = ${display(Math.min(...ahead))} comes first.`
        : `${none}: there is no visible hit.`;
    const [Ey, dy] = [draft.ray.origin[1], draft.ray.direction[1]];
    const at = roots.map(({ t: root }) => `t = ${display(root)}`).join(' and ');
    return {
      rule: 'A root counts if its point’s height does: low ≤ y ≤ high, where y is that of E + t d.',
      put: `Put ${at} into y = ${display(Ey)} + t · (${display(dy)}). Which y is from ${display(
        low,
      )} to ${display(high)}?`,
      decision: [...each, first],
    };
  },
  clue: 'A, B and C know nothing of the ends: look at the height of each point.',
  lines: [],
};
