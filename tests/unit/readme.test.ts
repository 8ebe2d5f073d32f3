import { existsSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { FAMILIES } from '../../src/math/families.ts';
import { intersect, METHODS, SHAPES } from '../../src/math/index.ts';
import { readSettings } from '../../src/pages/check/settings.ts';
import { SIMPLIFICATIONS } from '../../src/scene/simplifications.ts';
import { readAccuracy } from '../../src/state/accuracy/settings.ts';
import { GALLERY } from '../../src/state/gallery/index.ts';
import { readPicture } from '../../src/state/picture/settings.ts';
import type { Settings } from '../../src/state/state.ts';
import { decode } from '../../src/state/url.ts';
import { MOST_BOUNCES } from '../../src/tracer/weight.ts';

const root = new URL('../../', import.meta.url);
const read = (path: string): string => readFileSync(new URL(path, root), 'utf8');
const readme = read('README.md');
const scripts: Readonly<Record<string, string>> = JSON.parse(read('package.json')).scripts;

describe('what the README says', () => {
  test('every npm command in it exists', () => {
    const named = [...readme.matchAll(/npm run ([\w:]+)|npm (start|test)/g)].map(
      (m) => m[1] ?? m[2],
    );
    expect(named.length).toBeGreaterThan(5);
    expect(named.filter((name) => !(name && name in scripts))).toEqual([]);
  });

  test('every file and folder in it exists', () => {
    const named = [...readme.matchAll(/`((?:src|tests|docs)\/[\w./-]+)`|\]\((docs\/[\w./-]+)\)/g)]
      .map((m) => m[1] ?? m[2] ?? '')
      .concat([...readme.matchAll(/^ {4}(src\/\w+)/gm)].map((m) => m[1] ?? ''));
    expect(named.length).toBeGreaterThan(10);
    expect(named.filter((path) => !existsSync(new URL(path, root)))).toEqual([]);
  });

  test('the example of the math module gives what stands beside it', () => {
    const { hits } = intersect(
      { kind: 'cylinder', center: [0, 0, 0], radius: 5 },
      { origin: [-10, 0, 3], direction: [1, 0, 0] },
    );
    expect(readme).toContain(`// [${hits.map(({ t }) => t).join(', ')}]`);
  });

  test('its link opens without complaint, and its keys are the keys', () => {
    const link = /^ {4}(#\/explore\S+)/m.exec(readme)?.[1] ?? '';
    expect(decode(link).problems).toEqual([]);
    expect(decode(link).E).toEqual([4, 1, 0.5]);
    for (const { params } of SHAPES) {
      for (const { symbol } of params) expect(readme).toContain(`\`${symbol}\``);
    }
  });

  test('the links to the other pages open without complaint', () => {
    const readers: Readonly<Record<string, (given: Settings) => { problems: readonly string[] }>> =
      {
        accuracy: readAccuracy,
        picture: readPicture,
        check: readSettings,
      };
    const links = [...readme.matchAll(/^ {4}(#\/(accuracy|picture|check)\S+)/gm)];
    expect(links.map(([, , page]) => page)).toEqual(Object.keys(readers));
    for (const [, link = ''] of links) {
      const { page, settings, problems } = decode(link);
      expect([...problems, ...(readers[page]?.(settings[page]).problems ?? [])]).toEqual([]);
    }
  });

  test('its table of the ladder is that of docs/bench.md, with every rung', () => {
    const table = (text: string): string =>
      /<!-- bench -->([\s\S]*?)<!-- \/bench -->/.exec(text)?.[1] ?? '';
    const shown = table(readme);
    expect(shown).toBe(table(read('docs/bench.md')));
    const rungs = [...shown.matchAll(/^\| (\w+) \| [\d.]+ \|/gm)].map((m) => m[1]);
    expect(rungs).toEqual(METHODS.map(({ id }) => id));
  });

  test('docs/bench.md has every family and, for each, every rung', () => {
    const bench = read('docs/bench.md');
    // The table was measured on the families that stood when it was made; it says which.
    const measured = FAMILIES.filter(({ title }) => bench.includes(`### ${title}\n`));
    expect(measured.length).toBeGreaterThan(20);
    for (const { title } of measured) {
      const [, section = ''] = bench.split(`### ${title}\n`);
      const rungs = [...(section.split('### ')[0] ?? '').matchAll(/^\| (\w+) \| [\d.]+ \(/gm)];
      expect([title, ...rungs.map((m) => m[1])]).toEqual([title, ...METHODS.map(({ id }) => id)]);
    }
  });

  test('its numbers are right', () => {
    expect(readme).toContain(`${GALLERY.length} examples`);
    expect(METHODS.map(({ id }) => id)).toEqual(expect.arrayContaining(['textbook', 'exact']));
  });

  test('what it says that pictures leave out is what the page lists', () => {
    const [, paragraph = ''] =
      /^\* Pictures leave out or simplify.*?\): ([\s\S]*?)\.\n\*/m.exec(readme) ?? [];
    const listed = paragraph.replace(/\s+/g, ' ').split('; ');
    expect(listed).toEqual(
      SIMPLIFICATIONS.map(({ title, reason, file }) => `${title}: ${reason} (\`${file}\`)`),
    );
    expect(SIMPLIFICATIONS.map(({ reason }) => reason).join()).toContain(`${MOST_BOUNCES} bounces`);
  });

  test('the versions of Node agree', () => {
    expect(JSON.parse(read('package.json')).engines.node).toBe('>=20.19');
    expect(readme).toContain('Node 20.19 or newer');
  });
});
