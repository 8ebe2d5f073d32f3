import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { intersect, type Ray, type Shape } from '../../../src/math/index.ts';
import { ROOT } from './documents.ts';

const read = (path: string): string => readFileSync(new URL(path, ROOT), 'utf8');
const text = read('docs/others.md');
const { dependencies } = JSON.parse(read('tools/package.json')) as {
  readonly dependencies: Readonly<Record<string, string>>;
};

/** What makes the pages of `npm run api`. */
const PAGES = ['typedoc', 'typescript'];

interface Row {
  readonly library: string;
  readonly family: string;
  readonly wrong: string;
}

const rows: readonly Row[] = [
  ...text.matchAll(/^\| ([^|]+) \| ([\w-]+) \| \d+ \| ([^|]+) \| \d+ \| \d+ \|/gm),
].map(([, library = '', family = '', wrong = '']) => ({ library, family, wrong }));

test('docs/others.md has a date, and the versions that its own lockfile installs', () => {
  expect(text).toMatch(/by `npm run others` on \d{4}-\d\d-\d\d/);
  const lock = JSON.parse(read('tools/package-lock.json'));
  for (const [name, version] of Object.entries(dependencies)) {
    expect(lock.packages[`node_modules/${name}`].version).toBe(version);
    if (!PAGES.includes(name)) expect(text).toContain(`| ${version} |`);
  }
  const own = JSON.parse(read('package.json'));
  for (const name of ['@babylonjs/core', '@cesium/engine', '@thi.ng/geom-isec', 'typedoc']) {
    expect({ ...own.dependencies, ...own.devDependencies }).not.toHaveProperty(name);
  }
});

test('what Graze finds of the same rays is never wrong', () => {
  const own = rows.filter(({ library }) => library.startsWith('Graze'));
  expect(own.length).toBe(new Set(rows.map(({ family }) => family)).size);
  expect(own.filter(({ wrong }) => wrong !== '0')).toEqual([]);
});

test('each ray that is shown is answered by exact arithmetic as it says', () => {
  const shown = [...text.matchAll(/^\* .*: `(\{.*\})`$/gm)].map(([, json = '']) =>
    JSON.parse(json),
  );
  expect(shown.length).toBeGreaterThan(0);
  for (const { shape, ray, exact, hit } of shown as readonly {
    readonly shape: Shape;
    readonly ray: Ray;
    readonly exact: number | null;
    readonly hit: boolean;
  }[]) {
    const { class: verdict, hits } = intersect(shape, ray, 'exact');
    expect(hits.find(({ t }) => t >= 0)?.t ?? null).toBe(exact);
    expect(hit).toBe(exact === null);
    expect(['two', 'one', 'none']).toContain(verdict);
  }
});
