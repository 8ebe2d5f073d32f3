import { quote } from '../../math/shapes.ts';
import type { Output } from './judge.ts';

/** The message of the page to the sandbox. It contains no expected results. */
export interface RunMessage {
  readonly type: 'run';
  readonly id: number;
  readonly source: string;
  /** The textbook method as a program, timed for comparison. */
  readonly textbook: string;
  readonly cases: readonly { readonly shape: unknown; readonly ray: unknown }[];
  /** Indices of the cases that are timed. */
  readonly timed: readonly number[];
  /** More cases than messages are allowed: outputs come many in one. `cases` is empty then. */
  readonly packed?: PackedCases;
}

/** Cases that differ from each other in numbers only. */
export interface PackedCases {
  /** The shape of each, but for the numbers at `paths`. */
  readonly shape: unknown;
  /** Properties of the shape, with the component of a vector. */
  readonly paths: readonly (readonly [key: string, index: number | null])[];
  /** Case by case: E, d, and a number for each path. */
  readonly numbers: Float64Array;
}

/** The program's time divided by the textbook's: quartiles of several rounds. */
export interface Timing {
  readonly low: number;
  readonly median: number;
  readonly high: number;
}

/** A line that the program wrote to its console; level 'more' stands for all further ones. */
export interface ConsoleLine {
  readonly level: string;
  readonly text: string;
  /** Index of the case during which it was written; null before the first. */
  readonly index: number | null;
}

/** A message of the sandbox to the page. */
export type Reply =
  | { readonly type: 'ready' }
  | { readonly type: 'case'; readonly id: number; readonly index: number; readonly output: Output }
  /** Outputs of cases from this index on. */
  | {
      readonly type: 'cases';
      readonly id: number;
      readonly index: number;
      readonly outputs: readonly Output[];
    }
  /** The program cannot start: a syntax error, or no function intersect. */
  | {
      readonly type: 'refused';
      readonly id: number;
      readonly message: string;
      readonly line: number | null;
    }
  /** Something the program tried outside of any case. */
  | { readonly type: 'note'; readonly id: number; readonly message: string }
  | ({ readonly type: 'console'; readonly id: number } & ConsoleLine)
  /** A case that was run twice gave different results. */
  | { readonly type: 'unsteady'; readonly id: number; readonly index: number }
  | ({ readonly type: 'timing'; readonly id: number } & Timing)
  /** The time was not measured, and why. */
  | { readonly type: 'untimed'; readonly id: number; readonly message: string }
  /** Still measuring. */
  | { readonly type: 'tick'; readonly id: number }
  /** The worker was terminated: no message for too long, or the run took too long. */
  | { readonly type: 'stopped'; readonly id: number; readonly message: string }
  | { readonly type: 'done'; readonly id: number };

const MOST_ROOTS = 16;
const LONGEST_MESSAGE = 300;

type Unknown = Readonly<Record<string, unknown>>;

/** A message of the sandbox, with every field checked and copied; null if it is none. */
export function readReply(data: unknown): Reply | null {
  if (!isRecord(data)) return null;
  if (data.type === 'ready') return { type: 'ready' };
  const { id, type } = data;
  if (typeof id !== 'number') return null;
  const index = isIndex(data.index) ? data.index : null;
  switch (type) {
    case 'case': {
      const output = readOutput(data.output);
      return output && index !== null ? { type, id, index, output } : null;
    }
    case 'cases':
      return index === null ? null : readCases(id, index, data.outputs);
    case 'refused':
      return { type, id, message: text(data.message), line: lineOf(data.line) };
    case 'note':
    case 'stopped':
    case 'untimed':
      return { type, id, message: text(data.message) };
    case 'console':
      return { type, id, level: text(data.level), text: text(data.text), index };
    case 'unsteady':
      return index === null ? null : { type, id, index };
    case 'timing': {
      const { low, median, high } = data;
      const usable = isPositive(low) && isPositive(median) && isPositive(high);
      return usable ? { type, id, low, median, high } : null;
    }
    case 'tick':
    case 'done':
      return { type, id };
    default:
      return null;
  }
}

const MOST_TOGETHER = 256;

function readCases(id: number, index: number, data: unknown): Reply | null {
  if (!Array.isArray(data) || data.length > MOST_TOGETHER) return null;
  const outputs = data.flatMap((one) => readOutput(one) ?? []);
  return outputs.length === data.length ? { type: 'cases', id, index, outputs } : null;
}

const isIndex = (x: unknown): x is number => Number.isSafeInteger(x) && (x as number) >= 0;
const isPositive = (x: unknown): x is number =>
  typeof x === 'number' && x > 0 && Number.isFinite(x);

function readOutput(data: unknown): Output | null {
  if (!isRecord(data)) return null;
  switch (data.type) {
    case 'value':
      return readValue(data.value);
    case 'threw':
      return { type: 'threw', message: text(data.message), line: lineOf(data.line) };
    default:
      return null;
  }
}

/**
 * Reads a result `{ t: number[], normal?: number[][] }`, or says what is wrong with it. A plain
 * array of numbers is taken for t, null or nothing for no t.
 */
export function readValue(value: unknown): Output {
  const wrong = (message: string, t: unknown = null): Output => ({
    type: 'shape',
    message,
    meant: meantBy(t),
  });
  if (value === null || value === undefined) {
    return { type: 'value', t: [], normal: null, loose: 'nothing' };
  }
  if (Array.isArray(value)) {
    const isList = value.length <= MOST_ROOTS && value.every((x) => typeof x === 'number');
    if (isList) return { type: 'value', t: value, normal: null, loose: 'an array' };
    return wrong('returned an array: return { t: [ … ] }', value);
  }
  if (!isRecord(value)) {
    return wrong(`returned ${named(value)}: return { t: [ … ] }`, value ?? []);
  }
  const { t, normal } = value;
  if (!Array.isArray(t)) return wrong(`t is ${named(t)}, not an array of numbers`, t ?? []);
  if (t.length > MOST_ROOTS) return wrong(`t has ${t.length} entries`);
  const strange = t.find((x) => typeof x !== 'number');
  if (t.some((x) => typeof x !== 'number'))
    return wrong(`t holds ${named(strange)}, not only numbers`, t);
  if (normal === undefined || normal === null) return { type: 'value', t, normal: null };
  if (!Array.isArray(normal) || !normal.slice(0, MOST_ROOTS).every(isTriple)) {
    return wrong('normal is not an array of triples of numbers', t);
  }
  return { type: 'value', t, normal: normal.slice(0, MOST_ROOTS) };
}

/** The roots that a result of another form evidently contains; null if none. */
function meantBy(value: unknown): readonly number[] | null {
  const list = Array.isArray(value) ? value : [value];
  const isWritten = (x: unknown): boolean =>
    typeof x === 'string' && x.trim() !== '' && !Number.isNaN(Number(x));
  const numbers = list.map((x) => (isWritten(x) ? Number(x) : x));
  const plain = list.length <= MOST_ROOTS && numbers.every((x) => typeof x === 'number');
  return plain ? (numbers as number[]) : null;
}

const isTriple = (v: unknown): v is number[] =>
  Array.isArray(v) && v.length === 3 && v.every((x) => typeof x === 'number');

const isRecord = (value: unknown): value is Unknown =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const named = (value: unknown): string => (value === null ? 'null' : quote(value));
const text = (value: unknown): string => String(value).slice(0, LONGEST_MESSAGE);
const lineOf = (value: unknown): number | null =>
  Number.isSafeInteger(value) && (value as number) > 0 ? (value as number) : null;
