import { describe, expect, test } from 'vitest';
import { casesFor } from '../../../src/check/program/cases.ts';
import { casesCsv, casesJson } from '../../../src/check/program/exchange.ts';
import { reportOf } from '../../../src/check/program/report.ts';
import { LONGEST_RESULTS, readResults } from '../../../src/check/program/results.ts';
import { textbookFor } from '../../../src/check/program/template.ts';
import { seeded } from '../../../src/math/rng.ts';
import { exactly, run } from './students.ts';

const SEED = 41;
const cases = casesFor(['cone', 'square'], SEED);
const ids = cases.map(({ id }) => id);

describe('cases for other languages', () => {
  test('as JSON', () => {
    const data = JSON.parse(casesJson(cases, SEED)) as { cases: { id: string; ray: unknown }[] };
    expect(data.cases.map(({ id }) => id)).toEqual(ids);
    expect(data.cases.map(({ ray }) => JSON.stringify(ray))).toContain(
      '{"origin":[3,1,1],"direction":["NaN",0,1]}',
    );
  });

  test('as CSV', () => {
    const lines = casesCsv(cases).trim().split('\n');
    expect(lines).toHaveLength(cases.length + 1);
    expect(lines[0]).toBe('id,kind,Ex,Ey,Ez,dx,dy,dz,Vx,Vy,Vz,c,Px,Py,Pz,L,axis');
    expect(new Set(lines.map((line) => line.split(',').length))).toEqual(new Set([17]));
  });
});

/*
 * The same results in every dialect. They are a program's, so that not all are right and some are
 * no numbers.
 */

interface Result {
  readonly id: string;
  readonly t: readonly number[];
  readonly normal: readonly (readonly number[])[] | null;
  readonly error: string | null;
}
/** Of a program that divides by A = 0, so that NaN and infinities are among them. */
const source = textbookFor(['cone', 'square'], 'intersect').replace(
  /if \(A === 0\) \{/,
  'if (false) {',
);
const results = run(source, cases).map((output, i): Result => {
  const id = ids[i] ?? '';
  if (output.type !== 'value')
    return { id, t: [], normal: null, error: 'refused, "as" it; should' };
  return { id, t: output.t, normal: output.normal, error: null };
});
const plain = results.map(({ id, t, normal, error }) =>
  error === null ? { id, t, normal } : { id, error },
);

/** What does not fit into JSON, as each language writes it. */
const json = (x: unknown, nan: (x: number) => string): string => {
  if (typeof x === 'number') return Number.isFinite(x) ? String(x) : nan(x);
  if (Array.isArray(x)) return `[${x.map((one) => json(one, nan)).join(', ')}]`;
  if (typeof x !== 'object' || x === null) return JSON.stringify(x);
  const own = Object.entries(x).map(([key, one]) => `${JSON.stringify(key)}: ${json(one, nan)}`);
  return `{${own.join(', ')}}`;
};
const bare = String;
const asText = (x: number): string => JSON.stringify(String(x));

const cellsOf = ({ id, t, normal, error }: Result, none: string, number: (x: number) => string) => {
  if (error !== null) return [id, 'error', error];
  const normals = [0, 1].flatMap((i) => [0, 1, 2].map((k) => normal?.[i]?.[k]));
  const all = [t[0], t[1], ...normals];
  return [id, ...all.map((x) => (x === undefined ? none : number(x)))];
};
const quoted = (cell: string): string => `"${cell.replaceAll('"', '""')}"`;
const ifNeeded = (separator: string) => (cell: string) =>
  cell.includes(separator) || cell.includes('"') ? quoted(cell) : cell;
const comma = (x: number): string => String(x).replace('.', ',');
const c = (x: number): string =>
  Number.isNaN(x) ? '-nan(ind)' : Number.isFinite(x) ? x.toExponential(17) : x < 0 ? '-inf' : 'inf';
const HEAD = ['id', 't1', 't2', 'N1x', 'N1y', 'N1z', 'N2x', 'N2y', 'N2z'];

const plainNumber = (x: number): string => String(x);

function table(
  separator: string,
  { none = '', number = plainNumber, cell = ifNeeded(separator), head = true, end = '\n' } = {},
): string {
  const rows = results.map((one) => cellsOf(one, none, number));
  return [...(head ? [HEAD] : []), ...rows].map((row) => row.map(cell).join(separator)).join(end);
}

const utf16 = (text: string): string => `\uFFFD\uFFFD${[...text].join('\0')}\0`;

const DIALECTS: Readonly<Record<string, string>> = {
  'an array': json(plain, asText),
  'results in an object': json({ graze: 'check-results', results: plain }, asText),
  'json.dump of Python': json(plain, bare),
  'an indented array': JSON.stringify(JSON.parse(json(plain, asText)), null, 2),
  'one JSON a line': plain.map((one) => json(one, bare)).join('\n'),
  'one JSON a line, commas between': plain.map((one) => json(one, bare)).join(',\r\n'),
  'an object by id': json(Object.fromEntries(plain.map((one) => [one.id, one])), bare),
  't1 and t2': json(
    results.map(({ id, t, normal, error }) =>
      error === null ? { id, t1: t[0] ?? null, t2: t[1] ?? 'none', normal } : { id, error },
    ),
    bare,
  ),
  'none for no root': json(
    plain.map((one) => ('t' in one && one.t.length === 0 ? { ...one, t: 'none' } : one)),
    bare,
  ),
  'a byte order mark': `\uFEFF${json(plain, bare)}`,
  'UTF-16 of a shell': utf16(json(plain, bare)),
  CSV: table(','),
  'CSV without a head': table(',', { head: false }),
  'CSV, CRLF': `\uFEFF${table(',', { end: '\r\n' })}\r\n`,
  'CSV, all quoted': table(',', { cell: quoted }),
  'CSV with none': table(',', { none: 'None' }),
  'CSV of C': table(',', { number: c }),
  'decimal commas, semicolons': table(';', { number: comma }),
  'decimal commas, quoted': table(',', { number: comma, cell: quoted }),
  'decimal commas, tabs': table('\t', { number: comma }),
  TSV: table('\t'),
  'TSV in UTF-16': utf16(table('\t', { end: '\r\n' })),
  'white space': table(' ', { none: 'none' }),
  'columns in another order': (() => {
    const order = [...HEAD.keys()].reverse();
    const rows = results.map((one) => (one.error === null ? cellsOf(one, '', String) : [one.id]));
    const head = [...order.map((i) => HEAD[i]), 'error'];
    const cells = (row: readonly string[], error: string | null) => [
      ...order.map((i) => row[i] ?? ''),
      error === null ? '' : quoted(error),
    ];
    return [head, ...rows.map((row, i) => cells(row, results[i]?.error ?? null))]
      .map((row) => row.join(','))
      .join('\n');
  })(),
};

describe('results of other languages', () => {
  const expected = reportOf(
    cases,
    results.map(({ t, normal, error }) =>
      error === null
        ? { type: 'value', t, normal: normal && normal.length > 0 ? normal : null }
        : { type: 'threw', message: error, line: null },
    ),
  );
  const scores = ({ groups, families }: typeof expected) => [
    groups.map(({ passed }) => passed),
    families.map(({ passed, digits, says }) => [passed, digits, says.replace(/^threw.*/, 'threw')]),
  ];

  test('hold no numbers and errors, too', () => {
    expect(results.some(({ t }) => t.some(Number.isNaN))).toBe(true);
    expect(results.some(({ t }) => t.some((x) => Math.abs(x) === Number.POSITIVE_INFINITY))).toBe(
      true,
    );
    expect(expected.groups.filter(({ passed }) => passed > 0).length).toBeGreaterThan(1);
  });

  test.each(Object.keys(DIALECTS))('%s: the same report', (dialect) => {
    const read = readResults(DIALECTS[dialect] ?? '', cases);
    if (!read.ok) throw new Error(read.reason);
    expect(read.problems).toEqual([]);
    expect(scores(reportOf(cases, read.outputs))).toEqual(scores(expected));
  });

  test('missing results count as not right, and are named with foreign ones', () => {
    const read = readResults(`${ids[0]},1.5\nmars/1,2.5\n${ids[0]},2.5`, cases);
    if (!read.ok) throw new Error(read.reason);
    expect(read.problems.join()).toContain("no case 'mars/1'");
    expect(read.problems.join()).toContain(`${cases.length - 1} of ${cases.length}`);
    expect(read.problems.join()).toContain('more than once');
    const right = exactly(cases).map((output, i) => (i < 10 ? output : undefined));
    const { groups, left } = reportOf(cases, right);
    expect(left).toBe(cases.length - 10);
    expect(groups.map(({ passed }) => passed)).toEqual([10, 0, 0, 0]);
    expect(groups.reduce((sum, { total }) => sum + total, 0)).toBe(cases.length);
  });
});

describe('a file that cannot be read is said to be that', () => {
  const id = ids[0];
  test.each([
    ['', 'nothing in this file'],
    ['{', 'no JSON'],
    ['[]', 'no id in it'],
    ['{"a":1}', 'no array of results'],
    ['null', 'neither JSON nor lines'],
    ['x,1,2', 'neither JSON nor lines'],
    ['<!doctype html>', 'neither JSON nor lines'],
    ['[{"id":"no/such/1","t":[1]}]', "but 'no/such/1'"],
    [`[{'id': '${id}', 't': [1.5]}]`, 'double quotes'],
    [`[{"id":"${id}"}]`, 'has no t'],
    [`[{"id":"${id}","t":["abc"]}]`, "'abc'"],
    [`[{"id":"${id}","t":[null]}]`, 'null'],
    ['[{"t":[1]}]', 'has no id'],
    ['[7]', 'entry 1 is 7'],
    [`${id},abc`, "line 1: 'abc' is no number"],
    [`id,x\n${id},1`, 'names no column t1'],
    [`${id},6,5,14,2`, 'decimal commas'],
    [
      ids
        .slice(0, 6)
        .map((one) => `${one},6,5`)
        .join('\n'),
      'no number in it has a point',
    ],
    [`${id},1.5,2,3,4,5,6,7,8,9`, '10 cells'],
    ['x'.repeat(LONGEST_RESULTS + 1), `up to ${LONGEST_RESULTS}`],
  ])('%.40j', (text, words) => {
    const read = readResults(text, cases);
    expect(read).toMatchObject({ ok: false, reason: expect.stringContaining(words) });
  });

  test('whatever stands in it', () => {
    const random = seeded(12);
    const good = Object.values(DIALECTS);
    const pieces = [
      '{',
      '}',
      '[',
      ']',
      '"',
      "'",
      ',',
      ';',
      '\n',
      '\t',
      ':',
      'id',
      'null',
      '1e999',
      '\0',
      '𝕏',
      '\\',
      id,
    ];
    for (let i = 0; i < 2000; i++) {
      const base =
        random() < 0.5 ? '' : (good[Math.floor(random() * good.length)] ?? '').slice(0, 3000);
      let text = base;
      for (let k = 0; k < 1 + 20 * random(); k++) {
        const at = Math.floor(random() * (text.length + 1));
        const piece = pieces[Math.floor(random() * pieces.length)] ?? '';
        text = text.slice(0, at) + piece + text.slice(at + Math.floor(3 * random()));
      }
      const read = readResults(text, cases);
      if (read.ok)
        expect(
          read.outputs.every((one) => !one || one.type === 'value' || one.type === 'threw'),
        ).toBe(true);
      else expect(read.reason).toMatch(/\w/);
    }
  });
});
