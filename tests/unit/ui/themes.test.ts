import { readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';

/*
 * Dark is light in other colours, so that what stands clear of each other in one does so in the
 * other: the browser tests look at light and at the projector only.
 */

const SRC = new URL('../../../src/', import.meta.url);
const SHEETS = readdirSync(SRC, { recursive: true, encoding: 'utf8' })
  .filter((name) => name.endsWith('.css'))
  .map((name) => [name, readFileSync(new URL(name, SRC), 'utf8')] as const);

/** A property of the dark theme that is a colour, or how much of one covers the other. */
const OF_COLOUR =
  /^(?:color-scheme: dark|--[\w-]+: #[\da-f]{6}|--(?:back|front)-(?:base|rim): 0\.\d+)$/i;

/** What rules on the dark theme say that is no colour, and any other way to ask for it. */
const unlikeLight = (sheet: string): string[] => {
  const bare = sheet.replace(/\/\*.*?\*\//gs, '');
  const rules = bare.matchAll(/^ *:root\[data-theme="dark"\] \{([^{}]*)\}$/gm);
  const said = [...rules].flatMap(([, body = '']) => body.split(';').map((line) => line.trim()));
  const asked = [...bare.matchAll(/"dark"|prefers-color-scheme|light-dark\(/g)];
  return [
    ...said.filter((line) => line !== '' && !OF_COLOUR.test(line)),
    ...asked.slice([...bare.matchAll(/^ *:root\[data-theme="dark"\] \{/gm)].length).map(String),
  ];
};

test('the dark theme changes colours alone', () => {
  expect(SHEETS.some(([, sheet]) => sheet.includes('"dark"'))).toBe(true);
  for (const [name, sheet] of SHEETS) expect(unlikeLight(sheet), name).toEqual([]);
});

test('and what does more would be found', () => {
  expect(unlikeLight(':root[data-theme="dark"] {\n  --bg: #000000;\n}')).toEqual([]);
  expect(unlikeLight(':root[data-theme="dark"] {\n  --body: 14px;\n}')).toEqual(['--body: 14px']);
  expect(unlikeLight(':root[data-theme="dark"] .tab { padding: 1px }')).toEqual(['"dark"']);
  expect(unlikeLight('@media (prefers-color-scheme: dark) {}')).toHaveLength(1);
});
