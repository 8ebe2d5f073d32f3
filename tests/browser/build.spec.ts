import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { firstLoad } from '../first-load.ts';
import { expect, test } from './support/test.ts';

const FILES = 'dist/site/assets';
/** Bytes of packed scripts before the first frame. */
const BUDGET = 80_000;

/** What is written between quotes of either kind after a word of the module system. */
const IMPORTS = /(?:from|import)\s*\(?\s*["'`]\.\/([^"'`]+)["'`]/g;

test('no chunk imports the entry of a worker: WebKit would evaluate it twice', () => {
  const files = readdirSync(FILES).filter((name) => name.endsWith('.js'));
  const text = (name: string): string => readFileSync(`${FILES}/${name}`, 'utf8');
  const entries = files.flatMap((name) =>
    // A script that is named by its address is started as a worker.
    [...text(name).matchAll(/new URL\(["'`]([^"'`]+\.js)["'`],import\.meta\.url\)/g)].map(
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

test('what is loaded before the first frame keeps its budget', () => {
  const files = firstLoad('dist/site');
  const sum = [...files.values()].reduce((all, size) => all + size, 0);
  expect(files.size).toBeGreaterThan(0);
  expect(sum, JSON.stringify([...files])).toBeLessThanOrEqual(BUDGET);
});

test('three.js is in a chunk of its own, which the first frame does not wait for', () => {
  const has = (name: string): boolean =>
    readFileSync(`${FILES}/${name}`, 'utf8').includes('WebGLRenderer: ');
  const files = readdirSync(FILES).filter((name) => name.endsWith('.js') && has(name));
  expect(files).toEqual([expect.stringMatching(/^three-/)]);
  expect([...firstLoad('dist/site').keys()]).not.toContain(`assets/${files[0]}`);
});

/** Ends of lines and the indentation of a licence do not count. */
const plain = (text: string): string => text.replace(/\s+/g, ' ').trim();
const json = (file: string) => JSON.parse(readFileSync(file, 'utf8'));

const SIGNS: Readonly<Record<string, string>> = { '&lt;': '<', '&amp;': '&' };

function keptInPage(): string {
  const page = readFileSync('dist/offline/index.html', 'utf8');
  const [, kept = ''] = /<template id="third-party">([\s\S]*?)<\/template>/.exec(page) ?? [];
  return kept.replace(/&\w+;/g, (sign) => SIGNS[sign] ?? sign);
}

const NOTICES = {
  'the site': () => readFileSync('dist/site/THIRD-PARTY.txt', 'utf8'),
  'the offline file': keptInPage,
};

for (const [distribution, read] of Object.entries(NOTICES)) {
  test(`${distribution} names what is bundled, with its licence`, () => {
    const text = plain(read());
    const packages = Object.keys(json('package.json').dependencies);
    expect(packages.length).toBeGreaterThan(0);
    // The last three are what lit and d3-scale are made of.
    for (const name of [...packages, 'lit-html', 'd3-interpolate', 'd3-array']) {
      const { version } = json(`node_modules/${name}/package.json`);
      expect(text, name).toContain(`${name} ${version} (`);
      expect(text, name).toContain(plain(readFileSync(`node_modules/${name}/LICENSE`, 'utf8')));
    }
    expect(text).toContain(plain(readFileSync('src/ui/fonts/OFL.txt', 'utf8')));
  });
}

const USES_MATH = `<!doctype html><title>…</title><script type="module">
  import { prepare } from './lib/math/index.js';
  import { accelerate } from './lib/math/accelerate.js';
  const ball = prepare({ kind: 'sphere', center: [0, 0, 0], radius: 1 });
  const { t } = ball.first({ origin: [1e8, 0, 0.5], direction: [-1, 0, 0] });
  document.title = t + ' ' + accelerate();
</script>`;

test('the math module as a package runs in a page by a plain module script', async ({ page }) => {
  const folder = 'test-results/math-package';
  execFileSync(process.execPath, ['scripts/math-package/build.mjs', folder]);
  await page.route('**/math-package/**', (route) => {
    const [, path = ''] = /math-package\/(.*)$/.exec(new URL(route.request().url()).pathname) ?? [];
    return path === ''
      ? route.fulfill({ contentType: 'text/html', body: USES_MATH })
      : route.fulfill({ path: `${folder}/${path}` });
  });
  await page.goto('math-package/');
  await expect(page).toHaveTitle('99999999.1339746 true');
});
