import { shortest } from './format.ts';

/** What a cell may hold; nothing is an empty cell. */
export type Cell = string | number | boolean | null | undefined;

/** What spreadsheets take for a formula; a number is none. */
const FORMULA = /^[=+\-@\t\r]/;
const NUMBER = /^[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?$/i;

/**
 * A cell of CSV, quoted as RFC 4180 says. A text that a spreadsheet would take for a formula gets
 * an apostrophe before it, since names and answers come from anybody.
 */
function written(cell: Cell): string {
  if (cell === null || cell === undefined) return '';
  if (typeof cell === 'number') return shortest(cell);
  const text = String(cell);
  const plain = FORMULA.test(text) && !NUMBER.test(text) ? `'${text}` : text;
  return /[",\n\r]/.test(plain) ? `"${plain.replaceAll('"', '""')}"` : plain;
}

/** Rows as CSV. Lines end with LF alone: programs of students read them line by line. */
export const csv = (rows: readonly (readonly Cell[])[]): string =>
  rows.map((row) => `${row.map(written).join(',')}\n`).join('');
