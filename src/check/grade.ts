import type { Vec3 } from '../math/vec3.ts';
import { parseNumber, parseTriple } from '../text/parse.ts';
import type { Answer, Answers, Field } from './types.ts';

/** What a student typed, by field. */
export type Texts = Readonly<Record<string, string>>;

export type Read =
  | { readonly ok: true; readonly value: Answer }
  | { readonly ok: false; readonly reason: string };

export type Mark =
  | { readonly verdict: 'correct' | 'wrong'; readonly value: Answer }
  /** Not answered, or no number: nobody is to blame. */
  | { readonly verdict: 'invalid'; readonly reason: string };

/**
 * Half a unit of the fourth significant digit, in the worst case of a leading 1: whoever rounds rightly to four digits
 * is within it. The box says so: FOUR_DIGITS_WORDS.
 */
export const FOUR_DIGITS = 5e-4;
export const FOUR_DIGITS_WORDS = 'four right digits are enough; 1/3 and sqrt(2) are fine';

/** Text to a value; an infinite value is an answer (a division by zero gives one), and not a right one. */
export function readAnswer(field: Field, text: string): Read {
  if (text.trim() === '') return { ok: false, reason: 'not answered' };
  switch (field.kind) {
    case 'number':
      return parseNumber(text, { allowInfinity: true });
    case 'triple':
    case 'direction':
      return parseTriple(text, { allowInfinity: true });
    case 'choice':
      return field.options.some(({ id }) => id === text)
        ? { ok: true, value: text }
        : { ok: false, reason: `there is no choice '${text.slice(0, 40)}'` };
  }
}

/** What was typed, against what is right. A quantity that does not exist has no right value. */
export function grade(field: Field, text: string, truth: Answer | undefined): Mark {
  const read = readAnswer(field, text);
  if (!read.ok) return { verdict: 'invalid', reason: read.reason };
  return { verdict: matches(field, read.value, truth) ? 'correct' : 'wrong', value: read.value };
}

/** Whether two answers to a field count as the same. A value of NaN is met by an infinite one only. */
export function matches(field: Field, given: Answer, truth: Answer | undefined): boolean {
  if (truth === undefined) return false;
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

/** The relative tolerance leaves nothing at 0 itself; exercises have lengths of about 1, so four digits end at 10⁻⁴ there. */
const atZero = (truth: number): number => (truth === 0 ? FOUR_DIGITS : 0);

const sizeOf = (v: Vec3): number => Math.max(...v.map(Math.abs));

/** By the largest component: a component that should be 0 need not be met more closely than the others. */
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
  const read: Record<string, Answer> = {};
  for (const field of fields) {
    const one = readAnswer(field, texts[field.id] ?? '');
    if (one.ok) read[field.id] = one.value;
  }
  return read;
}

/** Whether two sets of answers would be marked alike in every field. */
export const alike = (fields: readonly Field[], a: Answers, b: Answers): boolean =>
  fields.every((field) => {
    const [x, y] = [a[field.id], b[field.id]];
    return x === undefined || y === undefined
      ? x === y
      : matches(field, x, y) || matches(field, y, x);
  });
