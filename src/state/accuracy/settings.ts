import type { Order } from '../../lab/timed.ts';
import type { Target } from '../../math/batch.ts';
import { findFamily } from '../../math/families.ts';
import { quote } from '../../math/shapes.ts';
import type { Settings } from '../state.ts';

/** What the two plots of the Accuracy page show; a link carries it. */
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
}

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
};

interface Read<T> {
  readonly value: T;
  readonly problem: string | null;
}

/** Reads the text of each key of the link; null for an invalid one. */
const READERS: {
  readonly [K in keyof AccuracySettings]: (text: string) => AccuracySettings[K] | null;
} = {
  family: (text) => findFamily(text)?.id ?? null,
  dial: (text) => finite(text),
  worth: (text) => WORTHS.find(({ id }) => id === text)?.id ?? null,
  cost: (text) => COSTS.find(({ id }) => id === text)?.id ?? null,
  target: (text) => TARGETS.find(({ id }) => id === text)?.id ?? null,
  order: (text) => ORDERS.find(({ id }) => id === text)?.id ?? null,
  hard: (text) => (findFamily(text)?.dial ? text : null),
  seed: (text) => (/^\d{1,9}$/.test(text) ? Number(text) : null),
};

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
  const value = READERS[key](text);
  return value === null
    ? { value: INITIAL_ACCURACY[key], problem: `opened without ${key}: ${quote(text)} is not one` }
    : { value, problem: null };
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
