import type { Vec3 } from '../math/index.ts';
import { parseNumber, parseTriple } from '../text/parse.ts';
import { adviceFor } from './advice.ts';
import { atLengthOf, rightDigits, unitsOf } from './precision.ts';
import { ABSENT, type Answer, type Answers, type Field } from './types.ts';

/** What a student typed, by field. */
export type Texts = Readonly<Record<string, string>>;

/** A value, and the unit of the last digit of each of its numbers; 0 for an expression. */
export interface Given {
  readonly value: Answer;
  readonly units: readonly number[];
}

type Read =
  | { readonly ok: true; readonly given: Given }
  | { readonly ok: false; readonly reason: string };

export type Mark =
  | ({ readonly verdict: 'correct' | 'wrong' } & Given)
  /** So many digits of it are right, and there are no more of them. */
  | ({ readonly verdict: 'rounded'; readonly digits: number } & Given)
  /** Not answered, or no number: nobody is to blame. */
  | { readonly verdict: 'invalid'; readonly reason: string };

/**
 * Half a unit of the fourth significant digit, in the worst case of a leading 1: whoever rounds
 * rightly to four digits is within it. The box says so: FOUR_DIGITS_WORDS.
 */
export const FOUR_DIGITS = 5e-4;
export const FOUR_DIGITS_WORDS = 'four right digits are enough; 1/3 and sqrt(2) are fine';
/** So many digits are right; fewer than the two of `ROUNDED`, and they could be chance. */
const ENOUGH_DIGITS = 4;
const ROUNDED = 2;
/** A mistake is recognised by no fewer digits than these. */
const EVIDENCE = 3;

/**
 * Text to a value; an infinite value is an answer (a division by zero gives one), and not a right
 * one.
 */
export function readAnswer(field: Field, text: string): Read {
  if (field.mayBeAbsent && SAYS_NONE.test(text)) return read(ABSENT);
  if (text.trim() === '') return { ok: false, reason: 'not answered' };
  if (field.kind === 'choice') {
    return field.options.some(({ id }) => id === text)
      ? read(text)
      : { ok: false, reason: `there is no choice '${text.slice(0, 40)}'` };
  }
  const parse = field.kind === 'number' ? parseNumber : parseTriple;
  const parsed = parse(text, { allowInfinity: true });
  if (parsed.ok) return read(parsed.value, text);
  const advice = adviceFor(text, field.kind === 'number');
  return { ok: false, reason: advice ? `${parsed.reason}: ${advice}` : parsed.reason };
}

const read = (value: Answer, text = ''): Read => ({
  ok: true,
  given: { value, units: unitsOf(text, value) },
});

/** A line may also say that its quantity does not exist. */
const SAYS_NONE = /^\s*(none|no|no root|does not exist|[-–—−∅])?\s*$/i;

/** How a value that was read stands to a right one: right, right as far as it goes, or wrong. */
export function compared(
  field: Field,
  { value, units }: Given,
  truth: Answer | undefined,
): 'correct' | 'wrong' | { readonly digits: number } {
  if (matches(field, value, truth)) return 'correct';
  const digits = digitsRight(field, { value, units }, truth);
  if (digits >= ENOUGH_DIGITS) return 'correct';
  return digits >= ROUNDED ? { digits } : 'wrong';
}

function digitsRight(field: Field, { value, units }: Given, truth: Answer | undefined): number {
  if (field.kind !== 'direction') return rightDigits(value, units, truth);
  if (typeof value !== 'object' || typeof truth !== 'object') return 0;
  return rightDigits(value, units, atLengthOf(value, truth));
}

/** Right, or rounded so that it is right as far as it goes. */
export const roughly = (field: Field, given: Given, truth: Answer | undefined): boolean =>
  compared(field, given, truth) !== 'wrong';

/** Close enough to be evidence of a mistake that gives `truth`. */
export function agrees(field: Field, given: Given, truth: Answer | undefined): boolean {
  const found = compared(field, given, truth);
  return found === 'correct' || (found !== 'wrong' && found.digits >= EVIDENCE);
}

/** What was typed, against what is right. A quantity that does not exist is met by saying so. */
export function grade(field: Field, text: string, truth: Answer | undefined): Mark {
  const answer = readAnswer(field, text);
  if (!answer.ok) return { verdict: 'invalid', reason: answer.reason };
  const { given } = answer;
  const found = compared(field, given, truth);
  if (typeof found === 'string') return { verdict: found, ...given };
  return { verdict: 'rounded', ...found, ...given };
}

/** "right to 3 digits, give one more" */
export const roundedWords = (digits: number): string =>
  `right to ${digits} digits, give ${digits === ENOUGH_DIGITS - 1 ? 'one' : 'two'} more`;

/**
 * Whether two answers to a field count as the same. A value of NaN is met by an infinite one only.
 */
export function matches(field: Field, given: Answer, truth: Answer | undefined): boolean {
  if (truth === undefined) return given === ABSENT;
  if (typeof given === 'number' && typeof truth === 'number') return near(given, truth);
  if (typeof given === 'object' && typeof truth === 'object') {
    return field.kind === 'direction' ? sameDirection(given, truth) : nearTriple(given, truth);
  }
  return given === truth;
}

function near(x: number, truth: number): boolean {
  if (!Number.isFinite(truth)) return Number.isNaN(truth) ? !Number.isFinite(x) : x === truth;
  return Math.abs(x - truth) <= FOUR_DIGITS * Math.abs(truth) + atZero(truth);
}

/**
 * The relative tolerance leaves nothing at 0 itself; exercises have lengths of about 1, so four
 * digits end at 10⁻⁴ there.
 */
const atZero = (truth: number): number => (truth === 0 ? FOUR_DIGITS : 0);

const sizeOf = (v: Vec3): number => Math.max(...v.map(Math.abs));

/**
 * By the largest component: a component that should be 0 need not be met more closely than the
 * others.
 */
function nearTriple(v: Vec3, truth: Vec3): boolean {
  const size = sizeOf(truth);
  if (!Number.isFinite(size)) return v.every((x, i) => near(x, truth[i] ?? Number.NaN));
  const allowed = size === 0 ? FOUR_DIGITS : FOUR_DIGITS * size;
  return v.every((x, i) => Math.abs(x - (truth[i] ?? 0)) <= allowed);
}

/** Positive multiples of each other. */
function sameDirection(v: Vec3, truth: Vec3): boolean {
  const [own, size] = [sizeOf(v), sizeOf(truth)];
  if (own === 0 || size === 0) return own === size;
  if (!Number.isFinite(own) || !Number.isFinite(size)) return false;
  const k = length(truth) / length(v);
  return nearTriple([v[0] * k, v[1] * k, v[2] * k], truth);
}

const length = (v: Vec3): number => Math.hypot(...v);

/** The readable answers; what cannot be read is left out. */
export function readAll(fields: readonly Field[], texts: Texts): Answers {
  const answers: Record<string, Answer> = {};
  for (const field of fields) {
    const one = readAnswer(field, texts[field.id] ?? '');
    if (one.ok && one.given.value !== ABSENT) answers[field.id] = one.given.value;
  }
  return answers;
}

/** Whether two sets of answers would be marked alike in every field. */
export const alike = (fields: readonly Field[], a: Answers, b: Answers): boolean =>
  fields.every((field) => {
    const [x, y] = [a[field.id], b[field.id]];
    return x === undefined || y === undefined
      ? x === y
      : matches(field, x, y) || matches(field, y, x);
  });
