import { exact as exactly } from '../math/arithmetic/exact.ts';
import { intersectTyped } from '../math/as-typed.ts';
import { decimalDigits } from '../math/exact/decimal.ts';
import { exactOf } from '../math/exact/of-typed.ts';
import { compare, fromNumber, type Surd } from '../math/exact/surd.ts';
import {
  lift,
  squaredNorm,
  type Triple,
  type Values,
  withVector,
} from '../math/formula/evaluate.ts';
import type { Intersection, Verdict } from '../math/intersection.ts';
import type { Ray } from '../math/ray.ts';
import type { Shape } from '../math/shapes/index.ts';
import { definitionOf } from '../math/shapes/lookup.ts';
import { shortest } from '../text/format.ts';
import { hintOn, parseTyped } from '../text/parse.ts';
import { superscript } from '../text/scripts.ts';
import type { AppState } from './state.ts';
import { type Place, rayPlaces, shapePlaces, type TypedTexts } from './typed-texts.ts';
import type { Piece } from './verdict-parts.ts';
import { textOf, type VerdictWords, verdictWords } from './words.ts';

/** What is to be said where the numbers that were typed and the doubles that store them are not the same. */
export interface AsTyped {
  /** Null where both give the same case. */
  readonly differs: Difference | null;
  /** What else is to be known of the typed numbers, sentence by sentence. */
  readonly notes: readonly string[];
}

export interface Difference {
  readonly class: Verdict;
  readonly typed: VerdictWords;
  readonly stored: VerdictWords;
  /** Which numbers make the difference, and what they are stored as: "0.3 is 0.29999999999999998890". */
  readonly because: string;
}

/** The scene as it was given: the doubles of the state, and the texts of those that were typed. */
export interface Given extends Pick<AppState, 'E' | 'd' | 'unit'> {
  readonly shape: Shape;
  readonly texts: TypedTexts;
}

/** A number of the ray or the shape, as it was meant. */
interface Meant extends Place {
  readonly text: string;
  /** The typed number; the stored one where the text has no exact value. */
  readonly exact: Surd;
  readonly isStored: boolean;
  /** Has no exact value: pi, sin(1). */
  readonly rounded: boolean;
  /** A double of 16 or 17 digits that nobody typed: it came out of a drag or a computation. */
  readonly computed: boolean;
}

/** `found`: what exact arithmetic says of the stored numbers. */
export function asTyped(given: Given, ray: Ray, found: Intersection): AsTyped {
  const all = allMeant(given);
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

const allMeant = (given: Given): Meant[] =>
  [...rayPlaces(given), ...shapePlaces(given.shape)].map((place) => meant(place, given));

/** Whether the numbers were typed, and are not just what is stored. */
const isTyped = (all: readonly Meant[], { unit }: Given): boolean =>
  (unit || !all.every(({ isStored }) => isStored)) && !all.some(({ computed }) => computed);

/** The numbers as typed, d at unit length if it is; null where they are just what is stored, or no one root holds them. */
export function typedValues(given: Given): Values<Surd> | null {
  const all = allMeant(given);
  if (!isTyped(all, given)) return null;
  const values = valuesOf(given, all, ({ exact }) => exact);
  const { d } = values.vectors;
  if (!given.unit || !d) return values;
  try {
    const length = exactly.sqrt(squaredNorm(d, exactly));
    const unit = [exactly.div(d[0], length), exactly.div(d[1], length), exactly.div(d[2], length)];
    return withVector(values, 'd', unit as unknown as Triple<Surd>);
  } catch (error) {
    if (error instanceof RangeError) return null;
    throw error;
  }
}

/** What a double may have been typed as: its shortest text, if that is a decimal that doubles tell from all others. */
const TYPED_DIGITS = 15;

function meant(place: Place, { texts }: Given): Meant {
  const { key, value } = place;
  const written = texts[key];
  const stored = fromNumber(value);
  if (written === undefined && isShort(value)) {
    const text = shortest(value);
    return { ...place, text, exact: stored, isStored: true, rounded: false, computed: false };
  }
  const text = written ?? shortest(value);
  const tree = parseTyped(text);
  const exact = tree && exactOf(tree);
  const isStored = exact !== null && compare(exact, stored) === 0;
  const digits = text
    .replace(/e.*/, '')
    .replace(/\D/g, '')
    .replace(/^0+|0+$/g, '').length;
  return {
    ...place,
    text,
    exact: exact ?? stored,
    isStored: isStored || exact === null,
    rounded: exact === null,
    computed: written === undefined && !isStored && digits > TYPED_DIGITS,
  };
}

/** Few digits behind the point in binary: its decimal has few too, and is the double itself. */
const isShort = (x: number): boolean => Number.isInteger(x * 1024) && Math.abs(x) < 1e9;

const isRoot = ({ exact }: Meant): boolean => exact.v.m !== 0n;

function compared(
  all: readonly Meant[],
  given: Given,
  ray: Ray,
  found: Intersection,
): Difference | 'undecided' | null {
  const { shape } = given;
  const of = (exact: (one: Meant) => Surd): Case => caseOf(given, valuesOf(given, all, exact));
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

const storedOf = ({ value }: Meant): Surd => fromNumber(value);

function caseOf({ shape, E, d, unit }: Given, values: Values<Surd>): Case {
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

function valuesOf(
  { shape, E, d }: Given,
  all: readonly Meant[],
  exact: (one: Meant) => Surd,
): Values<Surd> {
  const own = definitionOf(shape).values(shape);
  const vectors = { ...own.vectors, E, d };
  const values = lift({ scalars: own.scalars, vectors }, exactly);
  const scalars = { ...values.scalars };
  const triples: Record<string, Triple<Surd>> = { ...values.vectors };
  for (const one of all) {
    const { symbol, index } = one;
    if (index === null) scalars[symbol] = exact(one);
    else triples[symbol] = put(triples[symbol], index, exact(one));
  }
  return { scalars, vectors: triples };
}

function put<T>(v: Triple<T> | undefined, index: 0 | 1 | 2, x: T): Triple<T> {
  if (!v) throw new RangeError('a parameter whose letter no formula has');
  return [index === 0 ? x : v[0], index === 1 ? x : v[1], index === 2 ? x : v[2]];
}

/** Sizes aside: how far outside a point is may well differ in the last digits. */
function sameCase(a: VerdictWords, b: VerdictWords): boolean {
  const said = ({ relations, pieces }: VerdictWords): string =>
    JSON.stringify([relations, pieces.map((p) => (typeof p === 'string' ? p : p.quantity))]);
  return said(a) === said(b);
}

/** Digits that are shown of a stored number: three more than any two doubles need to be told apart. */
const STORED_DIGITS = 20;
const MOST_NUMBERS = 3;

function storedWords(numbers: readonly Meant[]): string {
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

function roundingNote(numbers: readonly Meant[]): string[] {
  if (numbers.length === 0) return [];
  return [`Rounded to doubles: ${storedWords(numbers)}.`];
}
