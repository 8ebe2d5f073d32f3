import { readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';

const FOLDER = 'src/math/methods/certified';
const CONSTANT = /^(?:export )?const ([A-Z]\w*)\b[^=]* = ([^;]*);/gm;

/** Where each constant of these files is set: by name, each place with its value. */
function constantsOf(files: Readonly<Record<string, string>>): Map<string, string[]> {
  const found = new Map<string, string[]>();
  for (const [file, text] of Object.entries(files)) {
    for (const [, name = '', value = ''] of text.matchAll(CONSTANT))
      found.set(name, [...(found.get(name) ?? []), `${file}: ${value}`]);
  }
  return found;
}

const twice = (files: Readonly<Record<string, string>>): string[][] =>
  [...constantsOf(files).values()].filter(({ length }) => length > 1);

test('a constant of certified is set once: its name has one value in the folder', () => {
  const names = readdirSync(FOLDER).filter((name) => name.endsWith('.ts'));
  const files = Object.fromEntries(
    names.map((name) => [name, readFileSync(`${FOLDER}/${name}`, 'utf8')]),
  );
  expect(constantsOf(files).size).toBeGreaterThan(50);
  expect(twice(files)).toEqual([]);
  expect(twice({ a: 'const X = 1;\n', b: 'export const X = 2;\n' })).toEqual([['a: 1', 'b: 2']]);
});
