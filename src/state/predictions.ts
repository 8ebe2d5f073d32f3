import { courseOf } from '../check/course.ts';
import { ALL_MISCONCEPTIONS, MISCONCEPTIONS } from '../check/misconceptions/index.ts';
import type { Answers, Input } from '../check/types.ts';
import { work } from '../check/work.ts';
import { display } from '../text/format.ts';
import { subscript } from '../text/scripts.ts';
import type { ExploreModel } from './derive.ts';
import { endedOf } from './ended.ts';
import { CAP_NAMES } from './ends.ts';
import { hiddenReach } from './hidden-results.ts';
import type { Ask } from './prediction-ask.ts';

/** An answer: the id of an option, or t of the mark on the ray. */
export type Guess = string | number;

interface Option {
  readonly id: string;
  readonly title: string;
}

/** One thing that can be asked of a ray and a shape before the results are shown. */
interface Question {
  readonly id: Ask;
  /** Title in the list of questions. */
  readonly title: string;
  readonly asks: string;
  /** Whether the answer is a mark on the ray; the only options are then for "nowhere". */
  readonly marked: boolean;
  readonly options: readonly Option[];
  /** Answers beside these where a shape is closed by caps. */
  readonly capOptions?: readonly Option[];
  /** Whether it can be asked of a curved or a flat shape: only a curved one has D. */
  fits(curved: boolean): boolean;
  /** The answer that follows from the values of right or edited formulas. */
  answer(found: Answers): Guess | null;
  /** How far off the guess is, in numbers. */
  gap(guess: Guess, truth: Guess, found: Answers, length: number): string;
}

const ALL = 'all';
/** Points that the line has in common with the shape, by the case. */
const COUNTS: Readonly<Record<string, string>> = {
  two: '2',
  tangent: '1',
  one: '1',
  none: '0',
  contained: ALL,
};
const option = (id: string, title = id): Option => ({ id, title });
const always = (): boolean => true;
const numberIn = (found: Answers, id: string): number | null => {
  const value = found[id];
  return typeof value === 'number' && !Number.isNaN(value) ? value : null;
};
const plural = (n: number, thing: string): string => `${n} ${thing}${n === 1 ? '' : 's'}`;

const points: Question = {
  id: 'points',
  title: 'how many points',
  asks: 'How many points does the whole line have in common with the shape?',
  marked: false,
  options: [option('0'), option('1'), option('2'), option(ALL, 'it lies in it')],
  fits: always,
  answer: (found) => COUNTS[String(found.case)] ?? null,
  gap(guess, truth) {
    if (truth === ALL) return 'The whole line lies in the surface or in the plane.';
    const told = `There ${truth === '1' ? 'is' : 'are'} ${plural(Number(truth), 'point')}`;
    if (guess === ALL) return `${told}, not a whole line.`;
    const off = Number(guess) - Number(truth);
    return `${told}: you said ${Math.abs(off)} too ${off > 0 ? 'many' : 'few'}.`;
  },
};

const where: Question = {
  id: 'where',
  title: 'where',
  asks: 'Where is the first visible hit? Put your mark there: click or drag it on the ray.',
  marked: true,
  options: [option('none', 'nowhere')],
  fits: always,
  answer: (found) => (found.first === 'none' ? 'none' : numberIn(found, 't')),
  gap(guess, truth, _found, length) {
    if (truth === 'none') return `Nothing is hit at t ≥ 0; your mark is at t = ${display(+guess)}.`;
    if (guess === 'none') return `It is hit at t = ${display(Number(truth))}.`;
    const off = Number(guess) - Number(truth);
    const way = off > 0 ? 'beyond' : 'before';
    const far = Math.abs(off) * length;
    const [at, mark, apart] = [display(Number(truth)), display(+guess), display(Math.abs(off), 3)];
    return (
      `The hit is at t = ${at}; your mark, at t = ${mark}, is ${apart} ${way} it: ` +
      `${display(far, 3)} units of length.`
    );
  },
};

const first: Question = {
  id: 'first',
  title: 'which is first',
  asks: 'Which root is the first visible hit?',
  marked: false,
  options: [option('t1', 't₁'), option('t2', 't₂'), option('none', 'none')],
  capOptions: [option('low', CAP_NAMES.low), option('high', CAP_NAMES.high)],
  fits: always,
  answer: (found) => (typeof found.first === 'string' ? found.first : null),
  gap(guess, truth, found) {
    const name = (id: Guess): string =>
      id === 'low' || id === 'high'
        ? `the ${CAP_NAMES[id]}`
        : `t${subscript(+String(id).charAt(1))}`;
    const roots = ['t1', 't2'].flatMap((id) => {
      const t = numberIn(found, id);
      return t === null ? [] : [`${name(id)} = ${display(t)}`];
    });
    const told = roots.length > 0 ? `${roots.join(', ')}: ` : 'There is no root: ';
    if (typeof found.left === 'string') return `${told}${found.left}.`;
    const right = truth === 'none' ? 'no hit is visible' : `${name(truth)} is the first with t ≥ 0`;
    const own = guess !== 'none' && numberIn(found, String(guess)) === null;
    return `${told}${right}${own ? `; there is no ${name(guess)}` : ''}.`;
  },
};

const SIGNS = ['-', '0', '+'];

const sign: Question = {
  id: 'sign',
  title: 'the sign of D',
  asks: 'Which sign has D?',
  marked: false,
  options: [option('-', 'D < 0'), option('0', 'D = 0'), option('+', 'D > 0')],
  fits: (curved) => curved,
  answer(found) {
    const D = numberIn(found, 'D');
    return D === null ? null : (SIGNS[Math.sign(D) + 1] ?? null);
  },
  gap: (_guess, _truth, found) => `D = ${display(numberIn(found, 'D') ?? Number.NaN)}.`,
};

/** The answers that can be given about this shape. */
export const optionsOf = (
  { options, capOptions = [] }: Question,
  { ended }: ExploreModel,
): Option[] => [...options, ...(ended?.caps ? capOptions : [])];

export const QUESTIONS: readonly Question[] = [points, where, first, sign];

/** The question to ask: the one in the link if it fits the shape, else the number of points. */
export function questionOf(ask: Ask | null, curved: boolean): Question {
  return QUESTIONS.find(({ id, fits }) => id === ask && fits(curved)) ?? points;
}

/** Largest error in t of a mark that counts as right: relative, or as a share of the drawn ray. */
const [NEAR, BY_HAND] = [0.02, 0.01];

function same(guess: Guess, truth: Guess | null, byHand: number): boolean {
  if (typeof guess !== 'number' || typeof truth !== 'number') return guess === truth;
  return Math.abs(guess - truth) <= Math.max(NEAR * Math.abs(truth), byHand);
}

/** Error in t that a hand makes in placing a mark on the drawn ray. */
function handOf({ shape, ray }: Input): number {
  const { from, to } = hiddenReach(shape, ray);
  return BY_HAND * (to - from);
}

interface Judgement {
  readonly right: boolean;
  /** Null where a number overflowed. */
  readonly truth: Guess | null;
  /** The gap in numbers. */
  readonly gap: string;
  /** A known mistake that gives the same answer, and what to look at again. */
  readonly mistake: string | null;
}

/** The judgement on a guess, by exact arithmetic whatever the chosen method is. */
export function judgementOf(question: Question, guess: Guess, model: ExploreModel): Judgement {
  const input: Input = { shape: model.shape, ray: model.ray };
  const course = courseOf(input.shape);
  const found = leftOf(work(course, input), model);
  const truth = question.answer(found);
  if (truth === null)
    return { right: false, truth, gap: 'A number overflowed on the way.', mistake: null };
  const right = same(guess, truth, handOf(input));
  const length = Math.hypot(...input.ray.direction);
  return {
    right,
    truth,
    gap: question.gap(guess, truth, found, length),
    // Formulas with a mistake are about the whole surface, without ends.
    mistake:
      right || model.ended
        ? null
        : typeof guess === 'number'
          ? mistakeAtMark(guess, input)
          : mistakeBehind(question, guess, input),
  };
}

/** The answers with the first hit of a shape with ends, by exact arithmetic. */
function leftOf(found: Answers, { ended, ray, shape, exactly, state }: ExploreModel): Answers {
  if (!ended) return found;
  const truly = endedOf(shape, ray, exactly.found, exactly.found, state.between, state.caps);
  if (!truly) return found;
  const cap = truly.capHits.find(({ role }) => role === 'first');
  const root = truly.firstRoot === null ? null : exactly.found.hits[truly.firstRoot];
  const first = cap ? cap.end : truly.firstRoot === null ? 'none' : `t${truly.firstRoot + 1}`;
  return { ...found, first, t: cap?.hit.t ?? root?.t ?? 'none', left: truly.text };
}

/** The lines of mistakes that are considered for a question, since many could give an answer. */
const LINES: Readonly<Record<Ask, readonly string[]>> = {
  points: ['case', 'D'],
  where: ['first'],
  first: ['first'],
  sign: ['D'],
};

/** The first known mistake about the question whose formulas give this answer. */
function mistakeBehind({ id, answer }: Question, guess: Guess, input: Input): string | null {
  const course = courseOf(input.shape);
  for (const { edit, line, says, remedy } of MISCONCEPTIONS) {
    const edited = LINES[id].includes(line) ? edit(course) : null;
    const given = edited && answer(work(edited, input));
    if (given !== null && given === guess) return `So it comes out with ${says}. ${remedy}`;
  }
  return null;
}

/** The lines whose mistakes lead to another place on the ray, the choice of a root before its t. */
const AT_MARK = ['first', 't', 'N.(E-P)'];

/**
 * The known mistake that leads nearest to the mark, within what a hand may be off: another root
 * than the first visible hit, or a t that the formula with one edit gives.
 */
function mistakeAtMark(mark: number, input: Input): string | null {
  const course = courseOf(input.shape);
  const byHand = handOf(input);
  const roots = placesIn(work(course, input));
  const places = ALL_MISCONCEPTIONS.flatMap((one) => {
    const edited = AT_MARK.includes(one.line) ? one.edit(course) : null;
    if (!edited) return [];
    const found = work(edited, input);
    // The roots themselves are right: only which of them is seen first can have been mistaken.
    const given =
      one.line === 'first' ? [numberIn(found, 't')] : placesIn(found).filter(isOther(roots));
    return given.flatMap((t) => (t !== null && same(mark, t, byHand) ? [{ ...one, t }] : []));
  });
  const away = ({ t }: { readonly t: number }): number => Math.abs(t - mark);
  const [nearest] = places.sort((a, b) => away(a) - away(b));
  return nearest
    ? `At t = ${display(nearest.t)} it comes out with ${nearest.says}. ${nearest.remedy}`
    : null;
}

const placesIn = (found: Answers): number[] =>
  ['t', 't1', 't2'].flatMap((id) => numberIn(found, id) ?? []).filter(Number.isFinite);

/** Rounded on another way, the same root may differ in its last bits. */
const SAME_ROOT = 1e-9;

const isOther =
  (roots: readonly number[]) =>
  (t: number): boolean =>
    roots.every((root) => Math.abs(root - t) > SAME_ROOT * Math.max(Math.abs(root), Math.abs(t)));
