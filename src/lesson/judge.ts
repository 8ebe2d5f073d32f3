import { readAnswer } from '../check/grade.ts';
import type { Misconception } from '../check/misconceptions/define.ts';
import { checkOwn, ownFields } from '../check/own-numbers.ts';
import type { Field, Input } from '../check/types.ts';
import type { Verdict } from '../math/index.ts';
import type { ExploreModel } from '../state/derive.ts';
import type { Ask } from '../state/prediction-ask.ts';
import { judgementOf, questionOf } from '../state/predictions.ts';
import { display } from '../text/format.ts';
import { parseNumber } from '../text/parse.ts';
import type { Guess } from './lesson.ts';
import { quantityOf } from './quantities.ts';

/** The classes in the words of the page. */
export const CLASS_WORDS: Readonly<Partial<Record<Verdict, string>>> = {
  two: 'two points',
  tangent: 'one double root',
  one: 'one point',
  none: 'no point',
  contained: 'all of it',
};

const wordsOf = (verdict: string): string => CLASS_WORDS[verdict as Verdict] ?? verdict;

/** The judgement on a guess. */
interface JudgedGuess {
  /** "Your guess 0.8: too small by 0.2" */
  readonly words: string;
  /** Misconceptions that give the guessed value. */
  readonly causes: readonly Misconception[];
}

/** What a guess is judged by. */
export interface Seen {
  /** Explore's model; null on other pages. */
  readonly model: ExploreModel | null;
  /** The value that the page shows; null if there is none, or none yet. */
  value(quantity: string): number | string | null;
}

/** Check's field for the quantity; null if Check does not ask for it. */
function fieldOf(guess: Guess, model: ExploreModel | null): Field | null {
  if (guess.type !== 'quantity' || !model) return null;
  return ownFields(inputOf(model)).find(({ id }) => id === guess.quantity) ?? null;
}

const inputOf = ({ shape, ray }: ExploreModel): Input => ({ shape, ray });

/** Why a text is no valid guess, quoting it; null if it is one. */
export function whyNoGuess(text: string, guess: Guess, model: ExploreModel | null): string | null {
  if (guess.type !== 'quantity' && guess.type !== 'free') return null;
  const field = fieldOf(guess, model);
  const read = field ? readAnswer(field, text) : parseNumber(text);
  return read.ok ? null : read.reason;
}

/** Judges a guess: by Check's rules if it has such a field, else by the digits shown. */
export function judgeGuess(guess: Guess, given: string, seen: Seen): JudgedGuess {
  if (guess.type === 'open') return { words: 'The answer', causes: [] };
  if (guess.type === 'prediction')
    return { words: ofPrediction(guess.ask, given, seen), causes: [] };
  const field = fieldOf(guess, seen.model);
  if (field && seen.model) return judgedByCheck(field, given, seen.model);
  const truth = guess.type === 'free' ? guess.truth : seen.value(guess.quantity);
  if (guess.type === 'class') return { words: ofClass(given, truth), causes: [] };
  return { words: ofNumber(given, truth), causes: [] };
}

function judgedByCheck(field: Field, given: string, model: ExploreModel): JudgedGuess {
  const { lines, causes } = checkOwn(inputOf(model), { [field.id]: given });
  const [line] = lines;
  const said = `Your guess ${given}`;
  if (line?.verdict === 'correct' || line?.verdict === 'absent') {
    return { words: `${said}: right`, causes: [] };
  }
  if (line?.verdict === 'wrong' && line.note === '') {
    const truth = quantityOf(model, field.id);
    return { words: truth === null ? `${said}: not so` : ofNumber(given, truth), causes };
  }
  return { words: line?.note ? `${said}: ${line.note}` : said, causes };
}

/** The words of Explore's own judgement. */
function ofPrediction(ask: Ask, given: string, { model }: Seen): string {
  if (!model) return `Your guess: ${given}`;
  const question = questionOf(ask, model.found.details.family === 'curved');
  const said =
    [...question.options, ...(question.capOptions ?? [])].find(({ id }) => id === given)?.title ??
    given;
  const { right, gap, mistake } = judgementOf(question, given, model);
  const words = `Your guess, ${said}: ${right ? 'right' : 'not so'}. ${gap}`;
  return mistake ? `${words} ${mistake}` : words;
}

const ofClass = (given: string, truth: number | string | null): string => {
  const said = `Your guess, ${wordsOf(given)}`;
  if (typeof truth !== 'string') return said;
  return given === truth ? `${said}: right` : `${said}: it is ${wordsOf(truth)}`;
};

/** Words on the error of a guess and its direction. */
function ofNumber(given: string, truth: number | string | null): string {
  const parsed = parseNumber(given);
  if (!parsed.ok || typeof truth !== 'number') return `Your guess: ${given}`;
  const off = parsed.value - truth;
  // The page shows six digits, so a guess with these is right.
  if (off === 0 || display(parsed.value) === display(truth)) {
    return `Your guess ${display(parsed.value)}: right`;
  }
  const way = off < 0 ? 'too small' : 'too large';
  return `Your guess ${display(parsed.value)}: ${way} by ${display(Math.abs(off), 3)}`;
}
