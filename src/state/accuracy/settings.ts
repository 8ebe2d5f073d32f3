import { MEASURES, type Measure, ZOOMS } from '../../lab/atlas/window.ts';
import type { Order } from '../../lab/timed.ts';
import type { Target } from '../../math/batch.ts';
import { findFamily } from '../../math/families.ts';
import { InvalidInput } from '../../math/index.ts';
import { findMethod, quote } from '../../math/shapes.ts';
import { parseNumber } from '../../text/parse.ts';
import { readStartRule } from '../picture/start-rule.ts';
import type { Settings } from '../state.ts';

/** What the plots and the map of the Accuracy page show; a link carries it. */
export interface AccuracySettings {
  /** The family whose rays are measured. */
  readonly family: string;
  /** Value of its dial; null if the family draws it for each ray. */
  readonly dial: number | null;
  readonly worth: Worth;
  /** Which of the two scales of time the grid lines follow. */
  readonly cost: Cost;
  /** Which kernels are compared with each other. */
  readonly target: Target;
  /** The order in which the rays are passed to the kernels. */
  readonly order: Order;
  /** The family whose difficulty is swept. */
  readonly hard: string;
  readonly seed: number;
  /** The axes of the map, as ids with a comma between; '' while there is none. */
  readonly atlas: string;
  /** How far the map is zoomed in, in decades. */
  readonly zoom: number;
  /** What the map's window is measured in. */
  readonly by: Measure;
  /** The numbers in the window's middle, with a comma between; '' for those of the ray. */
  readonly at: string;
  /** The maps' methods, one or two, or OWN; '' for the chosen method. */
  readonly maps: string;
  /** The maps' start rules, one or two; '' for maps of the ray itself. */
  readonly start: string;
}

/** In `maps`: the student's own program. */
export const OWN = 'own';

export const WORTHS = [
  { id: 'digits', title: 'digits, 9 rays of 10' },
  { id: 'worst', title: 'digits, worst ray' },
  { id: 'wrong', title: 'wrong verdicts' },
] as const;
export type Worth = (typeof WORTHS)[number]['id'];

export const COSTS = [
  { id: 'ns', title: 'ns' },
  { id: 'times', title: '× textbook' },
] as const;
export type Cost = (typeof COSTS)[number]['id'];

export const TARGETS = [
  { id: 'simd', title: 'SIMD' },
  { id: 'typescript', title: 'TypeScript' },
] as const satisfies readonly { readonly id: Target; readonly title: string }[];

export const ORDERS = [
  { id: 'random', title: 'random' },
  { id: 'sorted', title: 'hits first' },
] as const satisfies readonly { readonly id: Order; readonly title: string }[];

export const INITIAL_ACCURACY: AccuracySettings = {
  family: 'far-origin',
  dial: null,
  worth: 'digits',
  cost: 'ns',
  target: 'simd',
  order: 'random',
  hard: 'far-origin',
  seed: 7,
  atlas: '',
  zoom: 0,
  by: 'lengths',
  at: '',
  maps: '',
  start: '',
};

interface Read<T> {
  readonly value: T;
  readonly problem: string | null;
}

/** How the text of a key in the link is read; null for an invalid one. */
interface Reader<T> {
  /** What a text should be, for messages. */
  readonly what: string;
  read(text: string): T | null;
}

const oneOf = <T extends string>(all: readonly { readonly id: T }[]): Reader<T> => ({
  what: all.map(({ id }) => id).join(' or '),
  read: (text) => all.find(({ id }) => id === text)?.id ?? null,
});

const [LEAST_ZOOM, MOST_ZOOM] = ZOOMS.lengths;

const READERS: { readonly [K in keyof AccuracySettings]: Reader<AccuracySettings[K]> } = {
  family: { what: 'a family of rays', read: (text) => findFamily(text)?.id ?? null },
  dial: { what: 'a number', read: (text) => finite(text) },
  worth: oneOf(WORTHS),
  cost: oneOf(COSTS),
  target: oneOf(TARGETS),
  order: oneOf(ORDERS),
  hard: {
    what: 'a family of rays with a dial',
    read: (text) => (findFamily(text)?.dial ? text : null),
  },
  seed: {
    what: 'a whole number of up to nine digits',
    read: (text) => (/^\d{1,9}$/.test(text) ? Number(text) : null),
  },
  atlas: {
    what: 'two different numbers of ray and shape, as E.z,r',
    read: (text) => (AXES_TEXT.test(text) ? text : null),
  },
  zoom: {
    what: `a number from ${LEAST_ZOOM} to ${MOST_ZOOM}`,
    read(text) {
      const zoom = finite(text);
      return zoom !== null && zoom >= LEAST_ZOOM && zoom <= MOST_ZOOM ? zoom : null;
    },
  },
  by: oneOf(MEASURES),
  at: {
    what: 'two numbers with a comma between',
    read: (text) => (numbersIn(text).length === 2 ? text : null),
  },
  maps: {
    what: `a method or ${OWN}, or two of them with a comma between`,
    read: (text) => listOf(text, (id) => id === OWN || findMethod(id) !== undefined),
  },
  start: {
    what: 'a start rule, or two of them with a comma between',
    read: (text) => listOf(text, isStart),
  },
};

/** Two different ids of numbers; which there are depends on the shape. */
const AXES_TEXT = /^(?!([^,]+),\1$)[A-Za-z]+(\.[xyz])?,[A-Za-z]+(\.[xyz])?$/;

/** The numbers of a list with commas; empty if one is none. */
export function numbersIn(text: string): readonly number[] {
  const all = text.split(',').map((one) => parseNumber(one));
  return all.flatMap((one) => (one.ok && all.every(({ ok }) => ok) ? [one.value] : []));
}

/** The text, if it is a list of one or two of these. */
function listOf(text: string, isOne: (one: string) => boolean): string | null {
  const all = text.split(',');
  return all.length <= 2 && all.every(isOne) ? text : null;
}

function isStart(text: string): boolean {
  try {
    readStartRule(text);
    return true;
  } catch (error) {
    if (error instanceof InvalidInput) return false;
    throw error;
  }
}

const finite = (text: string): number | null => {
  const x = text.trim() === '' ? Number.NaN : Number(text);
  return Number.isFinite(x) ? x : null;
};

export const ACCURACY_KEYS = Object.keys(READERS) as readonly (keyof AccuracySettings)[];

function read<K extends keyof AccuracySettings>(
  key: K,
  text: string | undefined,
): Read<AccuracySettings[K]> {
  if (text === undefined) return { value: INITIAL_ACCURACY[key], problem: null };
  const { what, read: parse } = READERS[key];
  const value = parse(text);
  if (value !== null) return { value, problem: null };
  const problem = `opened without ${key}: ${quote(text)} is not ${what}`;
  return { value: INITIAL_ACCURACY[key], problem };
}

/**
 * The settings in a link's texts, with defaults for invalid ones, and what was wrong with those.
 */
export function readAccuracy(given: Settings): {
  readonly values: AccuracySettings;
  readonly problems: readonly string[];
} {
  const all = ACCURACY_KEYS.map((key) => [key, read(key, given[key])] as const);
  const values = Object.fromEntries(
    all.map(([key, { value }]) => [key, value]),
  ) as unknown as AccuracySettings;
  const problems = all.flatMap(([, { problem }]) => (problem === null ? [] : [problem]));
  return { values: { ...values, dial: withinDial(values) }, problems };
}

/** The dial's value within its range; null if the family has no dial. */
function withinDial({ family, dial }: AccuracySettings): number | null {
  const range = findFamily(family)?.dial?.range;
  return range && dial !== null ? Math.min(Math.max(dial, range[0]), range[1]) : null;
}

/** The texts of these settings in a link; null for a default, which a link leaves out. */
export function writeAccuracy(values: Partial<AccuracySettings>): Record<string, string | null> {
  return Object.fromEntries(
    Object.entries(values).map(([key, value]) => {
      const usual = INITIAL_ACCURACY[key as keyof AccuracySettings];
      return [key, value === null || value === usual ? null : String(value)];
    }),
  );
}
