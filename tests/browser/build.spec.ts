import { readdirSync, readFileSync } from 'node:fs';
import { expect, test } from './support/test.ts';

const FILES = 'dist/site/assets';

/** What is written between quotes of either kind after a word of the module system. */
const IMPORTS = /(?:from|import)\s*\(?\s*["'`]\.\/([^"'`]+)["'`]/g;

test('no chunk imports the entry of a worker: WebKit would evaluate it twice', () => {
  const files = readdirSync(FILES).filter((name) => name.endsWith('.js'));
  const text = (name: string): string => readFileSync(`${FILES}/${name}`, 'utf8');
  const entries = files.flatMap((name) =>
    [...text(name).matchAll(/new Worker\(new URL\(["'`]([^"'`]+)["'`]/g)].map(
      ([, url]) => url ?? '',
    ),
  );
  const imported = files.flatMap((name) => [...text(name).matchAll(IMPORTS)].map(([, to]) => to));
  expect(entries.length).toBeGreaterThan(0);
  for (const entry of entries) {
    expect(files).toContain(entry);
    expect(imported).not.toContain(entry);
    expect(text(entry), 'an entry only imports').toMatch(/^(import["'`]\.\/[^"'`]+["'`];?\s*)+$/);
  }
});
