import { quote } from '../../math/invalid-input.ts';
import { findShape } from '../../math/shapes/lookup.ts';
import type { Param } from '../../math/shapes/params.ts';
import { shortest } from '../../text/format.ts';
import type { Case } from './cases.ts';
import type { Output } from './judge.ts';
import { readValue } from './protocol.ts';

/*
 * The same cases for programs in C++, Python, Java and so on. A file of cases goes out, a file of results comes back;
 * what is expected stays here.
 *
 * JSON out:  { "graze": "check-cases", "version": 1, "seed": 41, "cases": [ { "id", "shape", "ray" }, … ] }
 * JSON back: { "graze": "check-results", "results": [ { "id", "t": [ … ], "normal"?: [ [x, y, z], … ] }
 *                                                   | { "id", "error": "words" }, … ] }, or just the array
 * CSV out:   id, kind, Ex … dz, and a column for each number of the shapes; empty where a shape has none
 * CSV back:  id, t1, t2[, N1x, N1y, N1z, N2x, N2y, N2z], empty for none, or id, error, words
 *
 * JSON has no NaN and no infinities: they are the strings "NaN", "Infinity", "-Infinity". Numbers have all digits
 * that their doubles need.
 */

export const FORMAT_WORDS: readonly string[] = [
  'JSON: cases is an array of { id, shape, ray }, as an intersect of JavaScript gets them. Send back an array of { id, t: [ … ], normal: [[x, y, z], … ] } (normal may be left out) or { id, error: "words" } where the program refuses.',
  'CSV: one case a line: id, kind, Ex, Ey, Ez, dx, dy, dz, and one column for each number of the shapes, empty where a shape has none. Send back lines of id, t1, t2 (empty for none), if you like N1x, N1y, N1z, N2x, N2y, N2z after them, or id, error.',
  'NaN, Infinity and -Infinity are written so (in JSON as strings). All t of the whole line, ascending, a tangent once.',
];

export function casesJson(cases: readonly Case[], seed: number): string {
  const lines = cases.map(({ id, shape, ray }) => JSON.stringify({ id, shape, ray }, replaced));
  return `{ "graze": "check-cases", "version": 1, "seed": ${seed}, "cases": [\n${lines.join(',\n')}\n] }\n`;
}

const replaced = (_: string, value: unknown): unknown =>
  typeof value === 'number' && !Number.isFinite(value) ? String(value) : value;

/** Names of the columns of a shape's numbers: C.x, C.y, C.z, r; the axis is one, too. */
const columnsOf = ({ symbol, type }: Param): string[] =>
  type === 'vector' ? ['x', 'y', 'z'].map((axis) => `${symbol}${axis}`) : [symbol];

function cellsOf(one: Case): ReadonlyMap<string, string> {
  const cells = new Map<string, string>();
  for (const param of findShape(one.shape.kind)?.params ?? []) {
    const value = (one.shape as unknown as Readonly<Record<string, unknown>>)[param.key];
    const parts = Array.isArray(value) ? value : [value];
    columnsOf(param).forEach((column, i) => {
      cells.set(column, cell(parts[i]));
    });
  }
  return cells;
}

const cell = (value: unknown): string =>
  typeof value === 'number' ? shortest(value) : String(value);

export function casesCsv(cases: readonly Case[]): string {
  const rows = cases.map((one) => ({ one, cells: cellsOf(one) }));
  const columns = [...new Set(rows.flatMap(({ cells }) => [...cells.keys()]))];
  const head = ['id', 'kind', 'Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz', ...columns];
  const lines = rows.map(({ one: { id, shape, ray }, cells }) => [
    ...[id, shape.kind, ...ray.origin.map(cell), ...ray.direction.map(cell)],
    ...columns.map((column) => cells.get(column) ?? ''),
  ]);
  return `${[head, ...lines].map((line) => line.join(',')).join('\n')}\n`;
}

export type Results =
  | {
      readonly ok: true;
      readonly outputs: readonly (Output | undefined)[];
      /** Words on what could not be used. */
      readonly problems: readonly string[];
    }
  | { readonly ok: false; readonly reason: string };

/** Results from elsewhere, in the order of the cases. Never throws. */
export function readResults(text: string, cases: readonly Case[]): Results {
  const byId = new Map<string, Output>();
  const problems: string[] = [];
  const rows = /^\s*[[{]/.test(text) ? jsonRows(text) : csvRows(text);
  if (typeof rows === 'string') return { ok: false, reason: rows };
  const known = new Set(cases.map(({ id }) => id));
  for (const { id, output } of rows) {
    if (known.has(id)) byId.set(id, output);
    else problems.push(`there is no case ${quote(id)}`);
  }
  if (byId.size === 0) return { ok: false, reason: 'no result belongs to one of these cases' };
  const missing = cases.length - byId.size;
  if (missing > 0) problems.push(`${missing} of ${cases.length} cases have no result`);
  return { ok: true, outputs: cases.map(({ id }) => byId.get(id)), problems: problems.slice(0, 5) };
}

interface Row {
  readonly id: string;
  readonly output: Output;
}

const threw = (message: unknown): Output => ({
  type: 'threw',
  message: String(message).slice(0, 200),
  line: null,
});

function jsonRows(text: string): Row[] | string {
  let data: unknown;
  try {
    data = JSON.parse(text);
  } catch (error) {
    return `this is no JSON: ${error instanceof Error ? error.message : ''}`;
  }
  const list = Array.isArray(data) ? data : (data as { results?: unknown }).results;
  if (!Array.isArray(list)) return 'there is no array of results';
  return list.map((one: unknown): Row => {
    const { id, error, t, normal } = (one ?? {}) as Readonly<Record<string, unknown>>;
    const numbers = (x: unknown): unknown => (Array.isArray(x) ? x.map(numbers) : numberOf(x));
    const value = { t: numbers(t), normal: normal === undefined ? undefined : numbers(normal) };
    return { id: String(id), output: error === undefined ? readValue(value) : threw(error) };
  });
}

/** The strings for what JSON cannot write; anything else stays what it is. */
function numberOf(x: unknown): unknown {
  return typeof x === 'string' && /^(NaN|[+-]?Infinity)$/.test(x) ? Number(x) : x;
}

function csvRows(text: string): Row[] | string {
  const lines = text.split(/\r?\n/).filter((line) => line.trim() !== '');
  const rows = lines
    .map((line) => line.split(line.includes(';') ? ';' : ',').map((part) => part.trim()))
    .filter(([id]) => id?.toLowerCase() !== 'id');
  if (rows.length === 0) return 'there are no lines of results';
  return rows.map(([id = '', ...cells]): Row => {
    if (cells[0]?.toLowerCase() === 'error') {
      return { id, output: threw(cells.slice(1).join(', ') || 'an error') };
    }
    const numbers = cells.map((part) => (part === '' ? null : Number(part)));
    const t = numbers.slice(0, 2).filter((x) => x !== null);
    const flat = numbers.slice(2).filter((x) => x !== null);
    const normal = [flat.slice(0, 3), flat.slice(3, 6)].filter((n) => n.length > 0);
    return { id, output: readValue({ t, normal: flat.length > 0 ? normal : undefined }) };
  });
}
