import type { Vec3 } from '../math/index.ts';
import { parseNumber, parseTriple } from '../text/parse.ts';
import { adviceFor } from './advice.ts';
import { atLengthOf, rightDigits, unitsOf } from './precision.ts';
import { ABSENT, type Answer, type Answers, type Field } from './types.ts';

/** What a student typed, by the field's id. */
export type Texts = Readonly<Record<string, string>>;

/** A value that was read, and for each of its numbers the unit of its last digit (0: exact). */
export interface ReadAnswer {
  readonly value: Answer;
  readonly units: readonly number[];
}

type ReadResult =
  | { readonly ok: true; readonly given: ReadAnswer }
  | { readonly ok: false; readonly reason: string };

export type Mark =
  | ({ readonly verdict: 'correct' | 'wrong' } & ReadAnswer)
  /** All its digits are right, but there are only `digits` of them. */
  | ({ readonly verdict: 'rounded'; readonly digits: number } & ReadAnswer)
  /** Not answered, or not readable as a number; it does not count as wrong. */
  | { readonly verdict: 'invalid'; readonly reason: string };

/**
 * Relative tolerance: half a unit of the fourth significant digit for a leading 1, the worst case.
 * A value that is rounded rightly to four digits is within it, as FOUR_DIGITS_WORDS promises.
 */
export const FOUR_DIGITS = 5e-4;
export const FOUR_DIGITS_WORDS = 'four right digits are enough; 1/3 and sqrt(2) are fine';
/** Digits that are enough, and the least that count as a rounded value rather than chance. */
const ENOUGH_DIGITS = 4;
const ROUNDED = 2;
/** Least digits by which a value is recognised as that of a mistake. */
const EVIDENCE = 3;

/** The value of a text. An infinite value, as from a division by zero, is read, but never right. */
export function readAnswer(field: Field, text: string): ReadResult {
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

const read = (value: Answer, text = ''): ReadResult => ({
  ok: true,
  given: { value, units: unitsOf(text, value) },
});

/** Texts that say that a quantity does not exist. */
const SAYS_NONE = /^\s*(none|no|no root|does not exist|[-–—−∅])?\s*$/i;

/** Compares a value with the right one: right, rightly rounded to too few digits, or wrong. */
export function compared(
  field: Field,
  { value, units }: ReadAnswer,
  truth: Answer | undefined,
): 'correct' | 'wrong' | { readonly digits: number } {
  if (matches(field, value, truth)) return 'correct';
  const digits = digitsRight(field, { value, units }, truth);
  if (digits >= ENOUGH_DIGITS) return 'correct';
  return digits >= ROUNDED ? { digits } : 'wrong';
}

function digitsRight(
  field: Field,
  { value, units }: ReadAnswer,
  truth: Answer | undefined,
): number {
  if (field.kind !== 'direction') return rightDigits(value, units, truth);
  if (typeof value !== 'object' || typeof truth !== 'object') return 0;
  return rightDigits(value, units, atLengthOf(value, truth));
}

/** Whether a value is right, or rightly rounded to too few digits. */
export const roughly = (field: Field, given: ReadAnswer, truth: Answer | undefined): boolean =>
  compared(field, given, truth) !== 'wrong';

/** Whether a value has enough digits of `truth` to be evidence of a mistake that gives it. */
export function agrees(field: Field, given: ReadAnswer, truth: Answer | undefined): boolean {
  const found = compared(field, given, truth);
  return found === 'correct' || (found !== 'wrong' && found.digits >= EVIDENCE);
}

/** Marks a text. For a quantity that does not exist, a text that says so is right. */
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

/** Whether two answers to a field count as the same. Only an infinite one matches NaN. */
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
 * Absolute tolerance at 0, where a relative one is 0. Lengths in exercises are about 1, so it is
 * the same number.
 */
const atZero = (truth: number): number => (truth === 0 ? FOUR_DIGITS : 0);

const sizeOf = (v: Vec3): number => Math.max(...v.map(Math.abs));

/** Compares components with a tolerance relative to the largest one. */
function nearTriple(v: Vec3, truth: Vec3): boolean {
  const size = sizeOf(truth);
  if (!Number.isFinite(size)) return v.every((x, i) => near(x, truth[i] ?? Number.NaN));
  const allowed = size === 0 ? FOUR_DIGITS : FOUR_DIGITS * size;
  return v.every((x, i) => Math.abs(x - (truth[i] ?? 0)) <= allowed);
}

/** Whether two vectors are positive multiples of each other. */
function sameDirection(v: Vec3, truth: Vec3): boolean {
  const [own, size] = [sizeOf(v), sizeOf(truth)];
  if (own === 0 || size === 0) return own === size;
  if (!Number.isFinite(own) || !Number.isFinite(size)) return false;
  const k = length(truth) / length(v);
  return nearTriple([v[0] * k, v[1] * k, v[2] * k], truth);
}

const length = (v: Vec3): number => Math.hypot(...v);

/** The values of all texts that can be read. */
export function readAll(fields: readonly Field[], texts: Texts): Answers {
  const answers: Record<string, Answer> = {};
  for (const field of fields) {
    const one = readAnswer(field, texts[field.id] ?? '');
    if (one.ok && one.given.value !== ABSENT) answers[field.id] = one.given.value;
  }
  return answers;
}

/** Whether two sets of answers match in every field. */
export const alike = (fields: readonly Field[], a: Answers, b: Answers): boolean =>
  fields.every((field) => {
    const [x, y] = [a[field.id], b[field.id]];
    return x === undefined || y === undefined
      ? x === y
      : matches(field, x, y) || matches(field, y, x);
  });
