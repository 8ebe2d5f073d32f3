import { expect, test } from 'vitest';
import { casesFor } from '../../src/check/program/cases.ts';
import { reportOf } from '../../src/check/program/report.ts';
import { readResults } from '../../src/check/program/results.ts';
import { exactly } from '../unit/check/students.ts';

/*
 * Decimal commas between semicolons were no numbers "for a root", lines with tabs were 93 of 93
 * right and 309 not run, Python's NaN refused the whole file, and quoted cells had no id that was
 * known.
 */

const cases = casesFor(['cylinder', 'circle'], 41);
const rows = exactly(cases).map((output, i) => ({
  id: cases[i]?.id ?? '',
  t: output.type === 'value' ? [...output.t] : null,
}));
const line = (separator: string, cell: (text: string) => string): string =>
  rows
    .map(({ id, t }) =>
      (t ? [id, ...t.map(String)] : [id, 'error', 'no']).map(cell).join(separator),
    )
    .join('\n');

test.each([
  ['decimal commas, semicolons', line(';', (cell) => cell.replace('.', ','))],
  ['tabs', line('\t', (cell) => cell)],
  ['quoted cells', line(',', (cell) => `"${cell}"`)],
])('%s: all are right', (_, text) => {
  const read = readResults(text, cases);
  if (!read.ok) throw new Error(read.reason);
  for (const { passed, total } of reportOf(cases, read.outputs).groups) expect(passed).toBe(total);
});

test("Python's NaN is read, and is what it is", () => {
  const read = readResults(`[{"id": "${rows[0]?.id}", "t": [NaN, -Infinity]}]`, cases);
  expect(read).toMatchObject({ ok: true });
  if (read.ok) expect(read.outputs[0]).toMatchObject({ t: [Number.NaN, Number.NEGATIVE_INFINITY] });
});

test('a hundred results of many are not all right', () => {
  const read = readResults(
    line(',', (cell) => cell)
      .split('\n')
      .slice(0, 20)
      .join('\n'),
    cases,
  );
  if (!read.ok) throw new Error(read.reason);
  const { groups, left } = reportOf(cases, read.outputs);
  expect(groups.reduce((sum, { total }) => sum + total, 0)).toBe(cases.length);
  expect(left).toBe(cases.length - 20);
});
