import { execFileSync } from 'node:child_process';
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { csv } from '../../../src/text/csv.ts';

/** The rows that Python's reader of RFC 4180 finds in each text. */
function readAgain(texts: readonly string[]): unknown {
  const program =
    'import csv, io, json, sys\n' +
    'print(json.dumps([list(csv.reader(io.StringIO(t, newline=""), strict=True))' +
    ' for t in json.load(sys.stdin)]))';
  return JSON.parse(
    execFileSync('python3', ['-c', program], { input: JSON.stringify(texts), encoding: 'utf8' }),
  );
}

test('another reader finds every cell, and nothing that a spreadsheet computes', () => {
  const text = fc.string({ unit: fc.constantFrom(...'=+-@\t\r\n",; a1é−') });
  const cell = fc.oneof(text, fc.double(), fc.boolean(), fc.constant(null), fc.constant(undefined));
  const table = fc.array(fc.array(cell, { minLength: 2, maxLength: 4 }), { maxLength: 4 });
  const tables = fc.sample(table, { seed: 41, numRuns: 300 });
  const found = readAgain(tables.map(csv)) as string[][][];
  tables.forEach((rows, i) => {
    const plain = rows.map((row) =>
      row.map((x) => (typeof x === 'number' && Object.is(x, -0) ? '-0' : String(x ?? ''))),
    );
    const read = found[i] ?? [];
    expect(read.map((row) => row.map((x) => x.replace(/^'(?=[=+\-@\t\r])/, '')))).toEqual(plain);
    for (const x of read.flat()) {
      if (/^[=+\-@\t\r]/.test(x)) expect(x).toMatch(/^[-+]?(?:\d|\.\d|Infinity)/);
    }
  });
});
