import { compare, exactOf, fromNumber, isZero, type Surd } from '../math/exact.ts';
import {
  exact as exactly,
  lift,
  squaredNorm,
  type Triple,
  type Values,
  withVector,
} from '../math/formula.ts';
import type { Shape } from '../math/index.ts';
import { definitionOf, type Param } from '../math/shapes.ts';
import { shortest } from '../text/format.ts';
import { parseTyped } from '../text/parse.ts';
import { type AppState, RAY_PARAMS } from './state.ts';
import { rayPlaces, shapePlaces, type TypedNumberSlot, type TypedTexts } from './typed-texts.ts';

/** Ray and shape as entered: the doubles of the state, and the texts of those that were typed. */
export interface EnteredInput extends Pick<AppState, 'E' | 'd' | 'unit'> {
  readonly shape: Shape;
  readonly texts: TypedTexts;
}

/** A number of the ray or the shape, with the exact value that its text stands for. */
export interface TypedValue extends TypedNumberSlot {
  readonly text: string;
  /** The typed number; the stored one where the text has no exact value. */
  readonly exact: Surd;
  readonly isStored: boolean;
  /** Whether the text has no exact value: pi, sin(1). */
  readonly rounded: boolean;
  /** A double of 16 or 17 digits that nobody typed: it came out of a drag or a computation. */
  readonly computed: boolean;
}

export const typedNumbers = (given: EnteredInput): TypedValue[] =>
  [...rayPlaces(given), ...shapePlaces(given.shape)].map((place) => typedValue(place, given));

/** Whether exact values differ from what the kernel gets, and none came out of a computation. */
export const isTyped = (all: readonly TypedValue[], { unit }: EnteredInput): boolean =>
  (unit || !all.every(({ isStored }) => isStored)) && !all.some(({ computed }) => computed);

/**
 * The exact values, with d at unit length if `unit` is set. Null if they are the stored doubles, or
 * if they do not all lie in one field Q(√D), which exact arithmetic needs.
 */
export function typedValues(given: EnteredInput): Values<Surd> | null {
  const all = typedNumbers(given);
  if (!isTyped(all, given)) return null;
  const values = valuesOf(given, all, ({ exact }) => exact);
  if (!isAllowed(given, values)) return null;
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

/**
 * Most digits of a number that counts as typed: all decimals of 15 digits are different doubles. A
 * longer one comes from a computation.
 */
const TYPED_DIGITS = 15;

function typedValue(place: TypedNumberSlot, { texts }: EnteredInput): TypedValue {
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

/** A multiple of 2^-10 below 10^9: its shortest decimal is exactly the double. */
const isShort = (x: number): boolean => Number.isInteger(x * 1024) && Math.abs(x) < 1e9;

export const isRoot = ({ exact }: TypedValue): boolean => exact.v.m !== 0n;

export const storedOf = ({ value }: TypedValue): Surd => fromNumber(value);

export function valuesOf(
  { shape, E, d }: EnteredInput,
  all: readonly TypedValue[],
  exact: (one: TypedValue) => Surd,
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

/**
 * Whether the exact values are in their parameters' domains. The stored doubles are, but the exact
 * value of 0.1 + 0.2 - 0.3 is 0, which is no direction.
 */
export function isAllowed({ shape }: EnteredInput, { scalars, vectors }: Values<Surd>): boolean {
  return [RAY_PARAMS.d, ...definitionOf(shape).params].every((param: Param) => {
    if (param.type === 'vector') return !param.nonZero || !vectors[param.symbol]?.every(isZero);
    if (param.type === 'axis' || param.least === undefined) return true;
    const x = scalars[param.symbol];
    return x === undefined || compare(x, fromNumber(param.least)) >= 0;
  });
}
