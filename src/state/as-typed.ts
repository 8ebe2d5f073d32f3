import { decimalDigits, fromNumber, type Surd } from '../math/exact.ts';
import type { Values } from '../math/formula.ts';
import type { Intersection, Ray, Verdict } from '../math/index.ts';
import { intersectTyped } from '../math/shapes.ts';
import { hintOn } from '../text/parse.ts';
import { superscript } from '../text/scripts.ts';
import {
  type EnteredInput,
  isAllowed,
  isRoot,
  isTyped,
  storedOf,
  type TypedValue,
  typedNumbers,
  valuesOf,
} from './typed-values.ts';
import type { Piece } from './verdict-parts.ts';
import { textOf, type VerdictWords, verdictWords } from './verdict-words.ts';

/** How the typed numbers differ from the doubles that store them. */
export interface AsTyped {
  /** Null where both give the same case. */
  readonly differs: Difference | null;
  /** Sentences on the typed numbers: hints, and what was rounded. */
  readonly notes: readonly string[];
}

interface Difference {
  readonly class: Verdict;
  readonly typed: VerdictWords;
  readonly stored: VerdictWords;
  /**
   * Which numbers make the difference, and what they are stored as: "0.3 is
   * 0.29999999999999998890".
   */
  readonly because: string;
}

/** `found`: what exact arithmetic says of the stored numbers. */
export function asTyped(given: EnteredInput, ray: Ray, found: Intersection): AsTyped {
  const all = typedNumbers(given);
  const hints = all.flatMap(({ key, symbol, text }) => {
    const hint = given.texts[key] === undefined ? null : hintOn(text);
    return hint === null ? [] : [`${symbol}: ${hint}.`];
  });
  const rounded = all.filter((one) => one.rounded);
  const differs = isTyped(all, given) ? compared(all, given, ray, found) : null;
  const roots = differs === 'undecided' ? all.filter(isRoot) : [];
  return {
    differs: differs === 'undecided' ? null : differs,
    notes: [...hints, ...roundingNote([...rounded, ...roots])],
  };
}

function compared(
  all: readonly TypedValue[],
  given: EnteredInput,
  ray: Ray,
  found: Intersection,
): Difference | 'undecided' | null {
  const { shape } = given;
  if (
    !isAllowed(
      given,
      valuesOf(given, all, ({ exact }) => exact),
    )
  )
    return 'undecided';
  const of = (exact: (one: TypedValue) => Surd): Case => caseOf(given, valuesOf(given, all, exact));
  const asTyped = of(({ exact }) => exact);
  if (asTyped.found.class === 'undecided') return 'undecided';
  const stored = verdictWords(found, shape, ray);
  if (sameCase(asTyped.words, stored)) return null;
  const decides = all.filter(
    (one) =>
      !one.isStored &&
      !sameCase(of((other) => (other === one ? storedOf(one) : other.exact)).words, asTyped.words),
  );
  const alone = sameCase(of(storedOf).words, asTyped.words);
  const numbers = decides.length > 0 ? decides : all.filter(({ isStored }) => !isStored);
  return {
    class: asTyped.found.class,
    typed: asTyped.words,
    stored,
    because: alone ? 'd is rounded when it is made a unit vector' : storedWords(numbers),
  };
}

interface Case {
  readonly found: Intersection;
  readonly words: VerdictWords;
}

function caseOf({ shape, E, d, unit }: EnteredInput, values: Values<Surd>): Case {
  const ray: Ray = { origin: E, direction: d };
  const found = intersectTyped(shape, ray, values);
  const words = verdictWords(found, shape, ray, values);
  return { found, words: unit ? inUnits(words, Math.hypot(...d)) : words };
}

/** With a unit d, t counts lengths and not multiples of the d that was typed. */
function inUnits(words: VerdictWords, length: number): VerdictWords {
  const pieces = words.pieces.map((piece): Piece => {
    if (typeof piece === 'string' || !piece.quantity.startsWith('t.')) return piece;
    return { ...piece, value: piece.value * length };
  });
  return { ...words, pieces, text: textOf(pieces) };
}

/** Whether both have the same words, without regard to the values of numbers in them. */
function sameCase(a: VerdictWords, b: VerdictWords): boolean {
  const said = ({ relations, pieces }: VerdictWords): string =>
    JSON.stringify([relations, pieces.map((p) => (typeof p === 'string' ? p : p.quantity))]);
  return said(a) === said(b);
}

/**
 * Digits that are shown of a stored number: three more than any two doubles need to be told apart.
 */
const STORED_DIGITS = 20;
const MOST_NUMBERS = 3;

function storedWords(numbers: readonly TypedValue[]): string {
  const each = [...new Set(numbers.map(({ text, value }) => `${text} is ${expansion(value)}`))];
  const more = each.length - MOST_NUMBERS;
  const listed = each.slice(0, MOST_NUMBERS).join(', ');
  return more > 0 ? `${listed}, and ${more} more` : listed;
}

/** The double's own decimal expansion, rounded to 20 digits. */
function expansion(x: number): string {
  const { negative, digits, exponent } = decimalDigits(fromNumber(x), STORED_DIGITS);
  const sign = negative ? '−' : '';
  if (exponent >= 0 && exponent < STORED_DIGITS - 1) {
    return `${sign}${digits.slice(0, exponent + 1)}.${digits.slice(exponent + 1)}`;
  }
  if (exponent < 0 && exponent > -5) return `${sign}0.${'0'.repeat(-exponent - 1)}${digits}`;
  return `${sign}${digits.charAt(0)}.${digits.slice(1)} · 10${superscript(exponent)}`;
}

function roundingNote(numbers: readonly TypedValue[]): string[] {
  if (numbers.length === 0) return [];
  return [`Rounded to doubles: ${storedWords(numbers)}.`];
}
