import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';

/* The formatter keeps code to 100 columns, but not comments, strings and templates. */

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const COLUMNS = 100;

/** `path:line` of each line that is too long; columns are code points, as an editor counts. */
const longLines = (path: string, source: string): string[] =>
  source.split('\n').flatMap((text, i) => ([...text].length > COLUMNS ? [`${path}:${i + 1}`] : []));

test(`no line has more than ${COLUMNS} columns; what is generated aside`, () => {
  const paths = ['src', 'tests', 'scripts'].flatMap((folder) =>
    readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' })
      .map((name) => `${folder}/${name}`.replaceAll('\\', '/'))
      .filter((path) => /\.(ts|mjs|css)$/.test(path) && !path.includes('/generated/')),
  );
  expect(paths.length).toBeGreaterThan(100);
  const found = paths.flatMap((path) => longLines(path, readFileSync(join(ROOT, path), 'utf8')));
  expect(found).toEqual([]);
});

test('and a longer one would be found', () => {
  expect(longLines('src/x.ts', `const x = 1;\n  // ${'∞'.repeat(COLUMNS - 4)}`)).toEqual([
    'src/x.ts:2',
  ]);
  expect(longLines('src/x.ts', '∞'.repeat(COLUMNS))).toEqual([]);
});
