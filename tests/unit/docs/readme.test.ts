import { existsSync } from 'node:fs';
import { posix } from 'node:path';
import { describe, expect, test } from 'vitest';
import { FAMILIES } from '../../../src/math/families.ts';
import { METHODS } from '../../../src/math/index.ts';
import { readSettings } from '../../../src/pages/check/settings.ts';
import { readSettings as readLessonSettings } from '../../../src/pages/lesson/lesson-step.ts';
import { readAccuracy } from '../../../src/state/accuracy/settings.ts';
import { readPicture } from '../../../src/state/picture/settings.ts';
import { PAGES, type PageId, type Settings } from '../../../src/state/state.ts';
import { decode } from '../../../src/state/url.ts';
import { operationLines, operationsOfFirst } from '../../bench/operations.ts';
import { DOCUMENTS, flowing, npmScripts, ROOT, read, SCRIPTS } from './documents.ts';

const readme = read('README.md');

const isThere = (path: string): boolean => existsSync(new URL(path, ROOT));

/** Where its links to files lead, as paths from the root. */
const linksIn = (path: string): readonly string[] =>
  [...read(path).matchAll(/\]\((?!https?:|#)([^)#]+)(?:#[^)]*)?\)/g)].map(([, link = '']) =>
    posix.join(posix.dirname(path), link),
  );

describe.each(DOCUMENTS)('%s', (path) => {
  const text = read(path);

  test('every npm command in it exists', () => {
    expect(npmScripts(text).filter((name) => !(name in SCRIPTS))).toEqual([]);
  });

  test('every file and folder that it names exists', () => {
    const named = [
      ...text.matchAll(/(?<![\w/.])(?:src|tests|docs|scripts|\.github)\/[\w./-]*\w/g),
    ].map(([name]) => name);
    expect(named.filter((name) => !isThere(name))).toEqual([]);
  });

  test('every link to a file leads to one', () => {
    const links = linksIn(path);
    expect(links.filter((link) => !isThere(link))).toEqual([]);
  });
});

describe('the README', () => {
  test('is a front page of at most 120 lines', () => {
    expect(readme.trimEnd().split('\n').length).toBeLessThanOrEqual(120);
  });

  test('leads to every document, in a step or two', () => {
    const reached = new Set(['README.md']);
    for (const path of reached) {
      for (const link of linksIn(path)) if (DOCUMENTS.includes(link)) reached.add(link);
    }
    expect(DOCUMENTS.filter((path) => !reached.has(path))).toEqual([]);
  });

  test('has a line on every command but those that npm runs by itself', () => {
    const hooks = ['preversion', 'version'];
    const missing = Object.keys(SCRIPTS).filter(
      (name) => !hooks.includes(name) && !npmScripts(readme).includes(name),
    );
    expect(missing).toEqual([]);
  });

  const links = [...readme.matchAll(/^ {4}(#\/\S+)/gm)].map(([, link = '']) => link);

  test('has links to every page', () => {
    expect(new Set(links.map((link) => decode(link).page))).toEqual(
      new Set(PAGES.map(({ id }) => id)),
    );
  });

  test.each(links)('%s opens without complaint', (link) => {
    const readers: Readonly<
      Record<PageId, (given: Settings) => { readonly problems: readonly string[] }>
    > = {
      explore: () => ({ problems: [] }),
      accuracy: readAccuracy,
      picture: readPicture,
      lesson: readLessonSettings,
      check: readSettings,
    };
    const { page, settings, problems } = decode(link);
    expect([...problems, ...readers[page](settings[page]).problems]).toEqual([]);
  });

  test('its first link is read as it is written', () => {
    expect(decode(links[0] ?? '').E).toEqual([4, 1, 0.5]);
  });

  test('names the version of Node that the package asks for', () => {
    const [, version] = /^>=(.*)$/.exec(JSON.parse(read('package.json')).engines.node) ?? [];
    expect(version).toBeDefined();
    expect(flowing(readme)).toContain(`Node ${version} or newer`);
  });
});

describe('the table of the ladder', () => {
  const table = (text: string): string =>
    /<!-- bench -->([\s\S]*?)<!-- \/bench -->/.exec(text)?.[1] ?? '';

  const shown = table(readme);
  /** Those that there were when it was measured; it is made anew by hand. */
  const measuredMethods = [...shown.matchAll(/^\| ([\w-]+) \| [\d.–]+ \|/gm)].map(
    ([, id = '']) => id,
  );

  test('is in the README as in docs/bench.md, its methods in the order of the ladder', () => {
    expect(shown).toBe(table(read('docs/bench.md')));
    expect(measuredMethods.length).toBeGreaterThan(1);
    expect(METHODS.map(({ id }) => id).filter((id) => measuredMethods.includes(id))).toEqual(
      measuredMethods,
    );
  });

  test('in docs/bench.md has reasons, whose operations are those of the kernels', () => {
    const [, why = ''] =
      /<!-- reasons -->([\s\S]*?)<!-- \/reasons -->/.exec(read('docs/bench.md')) ?? [];
    // A method that is newer than the table has no line there.
    const measured = METHODS.filter(({ id }) => why.includes(`\n| ${id} |`));
    expect(measured.length).toBeGreaterThan(1);
    expect(why).toContain(operationLines(measured).join('\n'));
    const { all, near } = operationsOfFirst();
    expect(why).toContain(`takes ${near} of the ${all} operations of the first stage`);
  });

  test('in docs/bench.md is followed by every family and, for each, the same methods', () => {
    const bench = read('docs/bench.md');
    // The table was measured on the families that stood when it was made; it says which.
    const measured = FAMILIES().filter(({ title }) => bench.includes(`### ${title}\n`));
    expect(measured.length).toBeGreaterThan(20);
    for (const { title } of measured) {
      const [, part = ''] = bench.split(`### ${title}\n`);
      const rows = (part.split('### ')[0] ?? '').matchAll(/^\| ([\w-]+) \| (?:–|[\d.]+ \()/gm);
      expect([title, ...[...rows].map((m) => m[1])]).toEqual([title, ...measuredMethods]);
    }
  });
});
