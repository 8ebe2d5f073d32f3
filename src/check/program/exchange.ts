import { findShape, type Param } from '../../math/shapes.ts';
import { type Cell, csv } from '../../text/csv.ts';
import type { Case } from './cases.ts';
import { LONGEST_RESULTS } from './results.ts';

/*
 * Writes the cases to a file for programs in C++, Python, Java and so on. Their file of results is
 * read by results.ts; expected results are not in the file.
 *
 *   JSON: { "graze": "check-cases", "version": 1, "seed": 41,
 *           "cases": [ { "id", "shape", "ray" }, … ] }
 *   CSV:  id, kind, Ex … dz, and a column for each number of the shapes; empty if a shape lacks it
 *
 * JSON has no NaN and no infinities: they are the strings "NaN", "Infinity", "-Infinity". Numbers
 * have all digits that their doubles need.
 */

export const FORMAT_WORDS: readonly string[] = [
  'JSON: cases is an array of { id, shape, ray }, as an intersect of JavaScript gets them; NaN ' +
    'and infinities are strings. Send back an array, or lines, of { id, t: [ … ], normal: [[x, ' +
    'y, z], … ] } (normal may be left out) or { id, error: "words" } where the program ' +
    'refuses, or one object with the ids as keys.',
  'CSV: one case a line: id, kind, Ex, Ey, Ez, dx, dy, dz, and one column for each number of the ' +
    'shapes, empty where a shape has none. Send back lines of id, t1, t2 (empty or none where ' +
    'there is none), if you like N1x, N1y, N1z, N2x, N2y, N2z after them, or id, error. Tabs ' +
    'or semicolons may stand for the commas, and then decimal commas for points; cells may ' +
    'be quoted.',
  `All t of the whole line, ascending, a tangent once. NaN and infinities as your language ` +
    `writes them. A case without a result counts as not right. A file may have up to ` +
    `${LONGEST_RESULTS} characters.`,
];

export function casesJson(cases: readonly Case[], seed: number): string {
  const lines = cases.map(({ id, shape, ray }) => JSON.stringify({ id, shape, ray }, replaced));
  return (
    `{ "graze": "check-cases", "version": 1, "seed": ${seed}, ` +
    `"cases": [\n${lines.join(',\n')}\n] }\n`
  );
}

const replaced = (_: string, value: unknown): unknown =>
  typeof value === 'number' && !Number.isFinite(value) ? String(value) : value;

/** Column names of a parameter's numbers: Cx, Cy, Cz, or r; an axis has one column. */
const columnsOf = ({ symbol, type }: Param): string[] =>
  type === 'vector' ? ['x', 'y', 'z'].map((axis) => `${symbol}${axis}`) : [symbol];

function cellsOf(one: Case): ReadonlyMap<string, Cell> {
  const cells = new Map<string, Cell>();
  for (const param of findShape(one.shape.kind)?.params ?? []) {
    const value = (one.shape as unknown as Readonly<Record<string, unknown>>)[param.key];
    const parts = (Array.isArray(value) ? value : [value]) as readonly (number | string)[];
    columnsOf(param).forEach((column, i) => {
      cells.set(column, parts[i]);
    });
  }
  return cells;
}

export function casesCsv(cases: readonly Case[]): string {
  const rows = cases.map((one) => ({ one, cells: cellsOf(one) }));
  const columns = [...new Set(rows.flatMap(({ cells }) => [...cells.keys()]))];
  return csv([
    ['id', 'kind', 'Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz', ...columns],
    ...rows.map(({ one: { id, shape, ray }, cells }) => [
      ...[id, shape.kind, ...ray.origin, ...ray.direction],
      ...columns.map((column) => cells.get(column)),
    ]),
  ]);
}
