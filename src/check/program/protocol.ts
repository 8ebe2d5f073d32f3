import { quote } from '../../math/invalid-input.ts';
import type { Output } from './judge.ts';

/** What the page sends into the sandbox. Nothing of what is expected is among it. */
export interface Run {
  readonly type: 'run';
  readonly id: number;
  readonly source: string;
  /** The textbook method as a program, to be timed beside it. */
  readonly textbook: string;
  readonly cases: readonly { readonly shape: unknown; readonly ray: unknown }[];
  /** Which of the cases are timed. */
  readonly timed: readonly number[];
}

/** What comes back. */
export type Reply =
  | { readonly type: 'ready' }
  | { readonly type: 'case'; readonly id: number; readonly index: number; readonly output: Output }
  /** The program does not begin: a syntax error, or no function intersect. */
  | {
      readonly type: 'refused';
      readonly id: number;
      readonly message: string;
      readonly line: number | null;
    }
  /** Something that was tried outside of any case. */
  | { readonly type: 'note'; readonly id: number; readonly message: string }
  | { readonly type: 'timing'; readonly id: number; readonly multiple: number }
  /** No sign of life for a second: the worker was ended. */
  | { readonly type: 'stopped'; readonly id: number; readonly message: string }
  | { readonly type: 'done'; readonly id: number };

const MOST_ROOTS = 16;
const LONGEST_MESSAGE = 300;

type Unknown = Readonly<Record<string, unknown>>;

/** A message from the sandbox, taken apart and put together anew; null for anything that is none. */
export function readReply(data: unknown): Reply | null {
  if (!isRecord(data)) return null;
  if (data.type === 'ready') return { type: 'ready' };
  const { id, type } = data;
  if (typeof id !== 'number') return null;
  switch (type) {
    case 'case': {
      const output = readOutput(data.output);
      return output && Number.isSafeInteger(data.index)
        ? { type, id, index: data.index as number, output }
        : null;
    }
    case 'refused':
      return { type, id, message: text(data.message), line: lineOf(data.line) };
    case 'note':
    case 'stopped':
      return { type, id, message: text(data.message) };
    case 'timing': {
      const multiple = data.multiple;
      return typeof multiple === 'number' && multiple > 0 ? { type, id, multiple } : null;
    }
    case 'done':
      return { type, id };
    default:
      return null;
  }
}

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

/** `{ t: number[], normal?: number[][] }`, or what is wrong with it. */
export function readValue(value: unknown): Output {
  const wrong = (message: string): Output => ({ type: 'shape', message });
  if (Array.isArray(value)) return wrong('returned an array: return { t: [ … ] }');
  if (!isRecord(value)) return wrong(`returned ${named(value)}: return { t: [ … ] }`);
  const { t, normal } = value;
  if (!Array.isArray(t)) return wrong(`t is ${named(t)}, not an array of numbers`);
  if (t.length > MOST_ROOTS) return wrong(`t has ${t.length} entries`);
  const strange = t.find((x) => typeof x !== 'number');
  if (t.some((x) => typeof x !== 'number'))
    return wrong(`t holds ${named(strange)}, not only numbers`);
  if (normal === undefined || normal === null) return { type: 'value', t, normal: null };
  if (!Array.isArray(normal) || !normal.slice(0, MOST_ROOTS).every(isTriple)) {
    return wrong('normal is not an array of triples of numbers');
  }
  return { type: 'value', t, normal: normal.slice(0, MOST_ROOTS) };
}

const isTriple = (v: unknown): v is number[] =>
  Array.isArray(v) && v.length === 3 && v.every((x) => typeof x === 'number');

const isRecord = (value: unknown): value is Unknown =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const named = (value: unknown): string => (value === undefined ? 'nothing' : quote(value));
const text = (value: unknown): string => String(value).slice(0, LONGEST_MESSAGE);
const lineOf = (value: unknown): number | null =>
  Number.isSafeInteger(value) && (value as number) > 0 ? (value as number) : null;

/** A module's `export` has no place in the script that the sandbox makes of it; every line stays where it is. */
export const asScript = (source: string): string =>
  source
    .replace(
      /^([ \t]*)export[ \t]+(?:default[ \t]+)?(?=async\b|function\b|const\b|let\b|var\b|class\b)/gm,
      '$1',
    )
    .replace(/^[ \t]*export[ \t]*\{[^}\n]*\}[ \t]*;?/gm, '');
