import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from 'vitest';

/* The formatter keeps code to 100 columns, but not comments, strings and templates. */

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const COLUMNS = 100;

/** Folders and files with longer templates, strings and tables. This list only gets shorter. */
const LONG_CODE = [
  ...['frontier', 'frontier-marks', 'graph-grid', 'graph-layers', 'plot'].map(
    (name) => `src/charts/${name}.ts`,
  ),
  ...['algebra', 'controls', 'param-rows', 'shape-picker'].map((name) => `src/panels/${name}.ts`),
  ...['src/math/formula/print', 'src/ui/number-box.ts'],
  ...['src/pages/explore', 'tests'],
];

interface Line {
  readonly path: string;
  readonly number: number;
  readonly text: string;
}

const isComment = ({ text }: Line): boolean => /^\s*(\/\/|\/\*|\*)/.test(text);
const isUnder =
  (places: readonly string[]) =>
  ({ path }: Line): boolean =>
    places.some((place) => path === place || path.startsWith(`${place}/`));
const placeOf = ({ path, number }: Line): string => `${path}:${number}`;

/** Code points, as an editor counts columns. */
const longLines = (path: string, source: string): Line[] =>
  source
    .split('\n')
    .map((text, i) => ({ path, number: i + 1, text }))
    .filter(({ text }) => [...text].length > COLUMNS);

const all = ['src', 'tests'].flatMap((folder) =>
  readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' })
    .map((name) => `${folder}/${name}`.replaceAll('\\', '/'))
    .filter((path) => /\.(ts|mjs|css)$/.test(path))
    .flatMap((path) => longLines(path, readFileSync(join(ROOT, path), 'utf8'))),
);
const comments = all.filter(isComment);
const code = all.filter((line) => !isComment(line));

describe(`no line has more than ${COLUMNS} columns`, () => {
  test('no comment', () => {
    expect(comments.map(placeOf)).toEqual([]);
  });

  test('no code', () => {
    const found = code.filter((line) => !isUnder(LONG_CODE)(line));
    expect(found.map(placeOf)).toEqual([]);
  });

  test.each(LONG_CODE)('%s is still an exception for its code', (folder) => {
    expect(code.some(isUnder([folder])), 'take it off the list').toBe(true);
  });
});

test('and a longer one would be found', () => {
  const [line] = longLines('src/x.ts', `const x = 1;\n  // ${'∞'.repeat(COLUMNS - 4)}`);
  expect(line && [placeOf(line), isComment(line)]).toEqual(['src/x.ts:2', true]);
  expect(longLines('src/x.ts', '∞'.repeat(COLUMNS))).toEqual([]);
});
