import { quote } from '../../math/shapes.ts';
import type { Case } from './cases.ts';
import { type CsvLine, linesOf, numberIn } from './cells.ts';
import type { Output } from './judge.ts';
import { readValue } from './protocol.ts';

/*
 * Reads results of programs in other languages. JSON: an array, an object by id, or one result per
 * line; NaN and Infinity bare (Python) or as strings. Tables: separated by commas, semicolons, tabs
 * or blanks; cells quoted or not; with or without a head.
 *
 *   { "graze": "check-results", "results": [
 *     { "id", "t": [ … ], "normal"?: [ [x, y, z], … ] },
 *     { "id", "error": "words" }, … ] }
 *
 *   id, t1, t2[, N1x, N1y, N1z, N2x, N2y, N2z]     empty cells for no root
 *   id, error, words
 *
 * What cannot be read is reported with its place in the file; it does not count as a result.
 */

export const LONGEST_RESULTS = 2_000_000;

type Results =
  | {
      readonly ok: true;
      /** In the order of the cases; undefined for a case without a result. */
      readonly outputs: readonly (Output | undefined)[];
      /** Messages on results that could not be used. */
      readonly problems: readonly string[];
    }
  | { readonly ok: false; readonly reason: string };

interface Row {
  readonly id: string;
  readonly output: Output;
}

/** Thrown with what is wrong with the file. */
class Unreadable extends Error {}

/** Reads a file of results. It never throws. */
export function readResults(text: string, cases: readonly Case[]): Results {
  if (text.length > LONGEST_RESULTS) {
    const reason =
      `the file has ${text.length} characters, and results may have up to ` + `${LONGEST_RESULTS}`;
    return { ok: false, reason };
  }
  try {
    return resultsOf(rowsOf(plain(text), new Set(cases.map(({ id }) => id))), cases);
  } catch (error) {
    if (!(error instanceof Unreadable)) throw error;
    return { ok: false, reason: error.message };
  }
}

/** The text without byte order marks, and without the zeros of UTF-16 that was read as UTF-8. */
const plain = (text: string): string =>
  text
    .replace(/^[\uFEFF\uFFFD]+/, '')
    .replaceAll('\0', '')
    .replace(/\r\n?/g, '\n')
    .trim();

function rowsOf(text: string, known: ReadonlySet<string>): Row[] {
  if (text === '') throw new Unreadable('there is nothing in this file, or more than 2 MB');
  return /^[[{]/.test(text) ? jsonRows(text) : tableRows(text, known);
}

function resultsOf(rows: readonly Row[], cases: readonly Case[]): Results {
  const known = new Set(cases.map(({ id }) => id));
  const byId = new Map<string, Output>();
  const foreign: string[] = [];
  let repeated = 0;
  for (const { id, output } of rows) {
    if (!known.has(id)) foreign.push(id);
    else if (byId.has(id)) repeated++;
    byId.set(id, output);
  }
  const outputs = cases.map(({ id }) => byId.get(id));
  const missing = outputs.filter((output) => !output).length;
  if (missing === cases.length) {
    const [first] = foreign;
    const instead = first === undefined ? '' : `, but ${quote(first)}`;
    throw new Unreadable(
      `no id in it is one of these cases, such as ${quote(cases[0]?.id)}${instead}`,
    );
  }
  const problems = [
    missing > 0
      ? `${missing} of ${cases.length} cases have no result: they count as not right`
      : '',
    repeated > 0 ? `${repeated} cases come more than once: the last result counts` : '',
    ...foreign.slice(0, 3).map((id) => `there is no case ${quote(id)}`),
  ];
  return { ok: true, outputs, problems: problems.filter((words) => words !== '') };
}

const threw = (message: unknown): Output => ({
  type: 'threw',
  message: String(message).slice(0, 200),
  line: null,
});

type Fields = Readonly<Record<string, unknown>>;
const isFields = (x: unknown): x is Fields =>
  typeof x === 'object' && x !== null && !Array.isArray(x);

/**
 * Quotes bare NaN and Infinity, which Python writes although JSON has none; read as numbers later.
 */
const quotedNumbers = (text: string): string =>
  text.replace(/("(?:[^"\\]|\\.)*")|([-+]?)\b(NaN|Infinity|inf)\b/gi, (all, string, sign, word) =>
    string === undefined ? `"${sign}${word}"` : all,
  );

/** The JSON value of a text; undefined if it is no JSON. */
function parsed(text: string): unknown {
  try {
    return JSON.parse(quotedNumbers(text));
  } catch {
    return undefined;
  }
}

function problemOf(text: string): string {
  try {
    JSON.parse(quotedNumbers(text));
    return '';
  } catch (error) {
    return error instanceof Error ? error.message.slice(0, 120) : '';
  }
}

function jsonRows(text: string): Row[] {
  const data = parsed(text);
  if (data === undefined) return jsonLines(text);
  if (Array.isArray(data)) return data.map((one, i) => rowOf(one, `entry ${i + 1}`));
  if (!isFields(data)) throw new Unreadable('there is no array of results');
  const { results } = data;
  if (Array.isArray(results)) return results.map((one, i) => rowOf(one, `entry ${i + 1}`));
  if ('id' in data) return [rowOf(data, 'the result')];
  const entries = Object.entries(isFields(results) ? results : data);
  const byId = entries.filter(([id]) => id.includes('/'));
  if (byId.length === 0) throw new Unreadable('there is no array of results, and no id of a case');
  return byId.map(([id, one]) => rowOf(isFields(one) ? { ...one, id } : { id, t: one }, quote(id)));
}

/** Reads JSON Lines: one result on each line. */
function jsonLines(text: string): Row[] {
  const lines = text.split('\n').filter((line) => line.trim() !== '');
  return lines.map((line, i) => {
    const one = parsed(line.trim().replace(/,$/, ''));
    if (one !== undefined) return rowOf(one, `line ${i + 1}`);
    const single = /^[[{]\s*\{?\s*'/.test(text);
    const hint = single ? 'texts stand in double quotes there (in Python: json.dump)' : '';
    throw new Unreadable(`this file is no JSON: ${hint || problemOf(text)}`);
  });
}

/** A result of the form { id, t: [ … ] }, { id, t1, t2 }, { id, error } or [id, t1, t2]. */
function rowOf(one: unknown, where: string): Row {
  if (Array.isArray(one)) {
    const [id, ...t] = one;
    return rowOf({ id, t: t.length === 1 ? t[0] : t }, where);
  }
  if (!isFields(one)) throw new Unreadable(`${where} is ${quote(one)}, not { id, t: [ … ] }`);
  const { id, error, normal } = one;
  if (typeof id !== 'string') throw new Unreadable(`${where} has no id`);
  if (error !== undefined && error !== null && error !== '') return { id, output: threw(error) };
  const split = 't1' in one || 't2' in one;
  const t = split ? [one.t1, one.t2].filter((x) => !isNothing(x)) : listOf(one.t);
  if (!split && one.t === undefined) throw new Unreadable(`${where}, ${quote(id)}, has no t`);
  const value = { t: numbers(t), normal: isNothing(normal) ? undefined : numbers(normal) };
  const output = readValue(value);
  if (output.type === 'shape') throw new Unreadable(`${where}, ${quote(id)}: ${output.message}`);
  return { id, output };
}

const isNothing = (x: unknown): boolean =>
  x === undefined || x === null || (typeof x === 'string' && numberIn(x) === null);

/** The list of roots: a bare number is one root; null and words like "none" are no root. */
const listOf = (t: unknown): unknown => {
  if (isNothing(t)) return [];
  return Array.isArray(t) ? t.filter((x) => x === null || !isNothing(x)) : [t];
};

/** Texts that are numbers become numbers; other values are kept. */
function numbers(x: unknown): unknown {
  if (Array.isArray(x)) return x.map(numbers);
  return typeof x === 'string' ? (numberIn(x) ?? x) : x;
}

const SEPARATORS = ['\t', ';', ',', ' '];
const COLUMNS = ['id', 't1', 't2', 'n1x', 'n1y', 'n1z', 'n2x', 'n2y', 'n2z'];

function tableRows(text: string, known: ReadonlySet<string>): Row[] {
  const [lines] = SEPARATORS.map((separator) => ({ separator, all: linesOf(text, separator) }))
    .map(({ separator, all }) => {
      const ids = all.filter(({ cells }) => cells.some((one) => known.has(one)));
      return { separator, all, ids: ids.length };
    })
    // Where no line has a root, the head tells how cells are separated.
    .sort((a, b) => b.ids - a.ids || cellsOfHead(b.all) - cellsOfHead(a.all));
  if (!lines || lines.ids === 0) {
    const [first] = known;
    throw new Unreadable(
      `this is neither JSON nor lines that begin with the id of a case, such as ${quote(first)}`,
    );
  }
  if (lines.separator === ',') refuseDecimalCommas(lines.all);
  const head = headOf(lines.all[0]);
  return (head ? lines.all.slice(1) : lines.all).map((line) => tableRow(line, head ?? COLUMNS));
}

const cellsOfHead = ([head]: readonly CsvLine[]): number => head?.cells.length ?? 0;

/**
 * Refuses a table without a decimal point in any number: decimal commas have been taken for
 * separators, since true results are never all integers.
 */
function refuseDecimalCommas(lines: readonly CsvLine[]): void {
  const numbers = lines.flatMap(({ cells }) => cells.slice(1).filter((one) => /\d/.test(one)));
  const whole = numbers.filter((one) => /^[-+]?\d+$/.test(one));
  if (whole.length < 6 || whole.length < numbers.length) return;
  throw new Unreadable(
    'no number in it has a point: if commas stand for it, put semicolons or tabs between the cells',
  );
}

/** The column names in lower case, if the first line has them; else null. */
function headOf(line: CsvLine | undefined): readonly string[] | null {
  const names = line?.cells.map((one) => one.toLowerCase()) ?? [];
  if (!names.includes('id')) return null;
  const usual = ['t1', 't', 'error'].some((name) => names.includes(name));
  if (!usual) throw new Unreadable('the head of this table names no column t1');
  return names.map((name) => (name === 't' ? 't1' : name));
}

function tableRow({ number, cells }: CsvLine, columns: readonly string[]): Row {
  const where = `line ${number}`;
  const cell = (name: string): string => cells[columns.indexOf(name)] ?? '';
  const id = cell('id');
  const error = cell('error');
  if (error !== '' && numberIn(error) !== null) return { id, output: threw(error) };
  if (cell('t1').toLowerCase() === 'error') {
    const after = cells.slice(columns.indexOf('t1') + 1).filter((one) => one !== '');
    return { id, output: threw(after.join(', ') || 'an error') };
  }
  const extra = cells.slice(columns.length).filter((one) => one !== '').length;
  if (extra > 0) {
    throw new Unreadable(
      `${where} has ${cells.length} cells, ${columns.length} at most have a meaning`,
    );
  }
  const numberAt = (name: string): number | null => {
    const value = numberIn(cell(name));
    if (value === undefined) throw new Unreadable(`${where}: ${quote(cell(name))} is no number`);
    return value;
  };
  const t = ['t1', 't2'].map(numberAt).filter((x) => x !== null);
  const normal = ['n1', 'n2'].flatMap((n) => {
    const parts = ['x', 'y', 'z'].map((axis) => numberAt(`${n}${axis}`)).filter((x) => x !== null);
    if (parts.length === 0) return [];
    if (parts.length === 3) return [parts];
    const hint = 'do decimal commas stand between commas?';
    throw new Unreadable(`${where} has ${parts.length} of the three numbers of a normal: ${hint}`);
  });
  return { id, output: readValue({ t, normal: normal.length > 0 ? normal : undefined }) };
}
