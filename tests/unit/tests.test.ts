import { readdirSync, readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { expect, test } from 'vitest';

/* What a test must not do, looked for in all of them. */

const OWN = 'tests.test.ts';
const root = new URL('../../', import.meta.url);
const filesOf = (folder: string): string[] =>
  readdirSync(new URL(folder, root), { recursive: true, encoding: 'utf8' })
    .filter((name) => /\.(ts|mjs|md)$/.test(name) && basename(name) !== OWN)
    .map((name) => `${folder}/${name}`);
const withText = (paths: readonly string[], text: RegExp): string[] =>
  paths.filter((path) => text.test(readFileSync(new URL(path, root), 'utf8')));
const TESTS = filesOf('tests').filter((path) => /\.(ts|mjs)$/.test(path));

test.each([
  ['waits for a time', /waitForTimeout/],
  ['is repeated until it passes', /\bretr(?:y|ies)\b\s*[:=(](?! 0\b)/],
  ['looks for words in the whole page, where the voice may say them too', /page\.getByText\(/],
  ['looks for words that go away by themselves: expectSaid', /'\.said'\)\)\.to/],
  [
    'changes for good the page that tests have one after another',
    /\.(?:exposeFunction|exposeBinding|setOffline|setGeolocation|setExtraHTTPHeaders)\(/,
  ],
  ['judges how long something took', /expect\([^;]*(?:performance|Date)\.now\(\)/],
])('none %s', (_, text) => {
  expect(withText(TESTS, text)).toEqual([]);
});

test('what replaces modules or globals has them for itself', () => {
  const replaced = /\bvi\.(?:mock|doMock|resetModules|stubGlobal|stubEnv|useFakeTimers)\b/;
  const unit = TESTS.filter((path) => /^tests\/(?:unit|repro)\//.test(path));
  expect(withText(unit, replaced).filter((path) => !path.endsWith('.alone.test.ts'))).toEqual([]);
});

test('no comment refers to a document that is not here', () => {
  const documents = ['docs', 'src'].flatMap(filesOf).map((path) => basename(path));
  // What a command writes has a name in its code.
  const written = filesOf('scripts').flatMap((path) =>
    [...readFileSync(new URL(path, root), 'utf8').matchAll(/'([\w-]+\.md)'/g)].map(
      ([, name]) => name,
    ),
  );
  const top = ['README.md', 'CONTRIBUTING.md', 'CHANGELOG.md'];
  const known = new Set([...documents, ...written, ...top]);
  const missing = ['src', 'tests', 'docs']
    .flatMap(filesOf)
    .flatMap((path) =>
      [...readFileSync(new URL(path, root), 'utf8').matchAll(/\b[A-Za-z-]+\.md\b/g)]
        .filter(([name]) => !known.has(name))
        .map(([name]) => `${path}: ${name}`),
    );
  expect(missing).toEqual([]);
});
