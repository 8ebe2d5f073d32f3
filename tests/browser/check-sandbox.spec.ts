import { createServer } from 'node:http';
import { MISCONCEPTIONS } from '../../src/check/misconceptions/index.ts';
import { programOf } from '../../src/check/program/source.ts';
import type { ShapeKind } from '../../src/math/shapes/index.ts';
import { withoutScene } from './support/page.ts';
import { editor, openCheck, report, runProgram, told } from './support/program.ts';
import { expect, test } from './support/test.ts';

/* A student's program in the real browser: what is right, what is wrong, and what is none of its business. */

test.use({
  viewport: { width: 1280, height: 800 },
  // The policy says on the console what it stopped.
  provoked: /Content.Security.Policy|ERR_FAILED|net::ERR|example\.com|blocked/i,
});

const body = (line: string): string =>
  `function intersect(shape, ray) {\n  ${line}\n  return { t: [] };\n}\n`;

/** The page still answers, and nothing that was typed is lost. */
async function alive(page: Parameters<typeof told>[0], source: string): Promise<void> {
  await expect(editor(page)).toHaveValue(source);
  const parts = page.getByRole('navigation', { name: 'Parts of this page' });
  await parts.getByRole('button', { name: 'Own numbers' }).click();
  await expect(page.getByRole('heading', { name: 'Own numbers' })).toBeVisible();
  await parts.getByRole('button', { name: 'Questions' }).click();
  await expect(page.locator('iframe')).toHaveCount(0);
}

test.beforeEach(async ({ page }) => {
  await withoutScene(page);
});

test('a correct program passes what is ordinary and special, and its time is measured', async ({
  page,
}) => {
  await openCheck(page, 'cases=cone');
  const source = `export ${programOf('cone') ?? ''}`;
  await runProgram(page, source);
  const rows = page.locator('.families tbody tr');
  for (const row of await rows.all()) {
    const group = (await row.locator('td').first().innerText()).trim();
    if (group === 'hard') break;
    expect(await row.getAttribute('data-passed')).toBe(await row.getAttribute('data-total'));
  }
  await expect(page.locator('[data-quantity="multiple"]')).toHaveAttribute('data-value', /\d/);
  const multiple = Number(
    await page.locator('[data-quantity="multiple"]').getAttribute('data-value'),
  );
  // The same program as the one it is timed against.
  expect(multiple).toBeGreaterThan(0.1);
  expect(multiple).toBeLessThan(10);
  await expect(report(page).locator('[data-cause]')).toHaveCount(0);
  await alive(page, source);
});

/** What a program can show: the rules of visible hits are not among it, as it returns every root. */
const SHOWN = MISCONCEPTIONS.filter(
  ({ id }) =>
    ![
      'behind',
      'far-root',
      'no-light-bound',
      'parallel-misses',
      'parallel-lies-in',
      'loss-always-t',
    ].includes(id),
);
const KINDS: readonly ShapeKind[] = [
  'cylinder',
  'cone',
  'hyperboloid',
  'plane',
  'circle',
  'square',
];

for (const half of [0, 1]) {
  test(`each misconception is named, part ${half + 1} of 2`, async ({ page }) => {
    test.setTimeout(180_000);
    await openCheck(page, '');
    for (const { id, edit } of SHOWN.filter((_, i) => i % 2 === half)) {
      const kind = KINDS.find((one) => {
        const edited = programOf(one, edit);
        return edited !== null && edited !== programOf(one);
      });
      await page.locator('.kind select').selectOption(kind ?? '');
      await runProgram(page, programOf(kind ?? 'plane', edit) ?? '');
      const named = report(page).locator(`[data-cause="${id}"]`);
      await expect.soft(named, `${id} on a ${kind}`).toHaveCount(1);
    }
  });
}

for (const [what, line] of [
  ['an endless loop', 'for (;;) {}'],
  ['an endless loop with a little work', 'let k = 0; while (true) k += Math.sqrt(k);'],
  ['a bomb of arrays', 'const all = []; for (;;) all.push(new Array(1e6).fill(1));'],
  ['a bomb of bytes', 'const all = []; for (;;) all.push(new Uint8Array(1e8).fill(1));'],
] as const) {
  test(`${what} is ended, and the page lives`, async ({ page }) => {
    await openCheck(page, '');
    const source = body(line);
    await runProgram(page, source);
    expect(await told(page)).toContain('no sign of life for a second');
    expect(await told(page)).toContain('did not end within a second');
    await alive(page, source);
    await runProgram(page, body('return { t: [] };'));
    expect(await told(page)).toContain('exact cases right');
  });
}

test('a bomb of strings is an error with its line', async ({ page }) => {
  await openCheck(page, '');
  await runProgram(page, body('let s = "x"; for (;;) s += s + s;'));
  expect(await told(page)).toContain('threw in line 2: Invalid string length');
});

test('a loop before anything begins', async ({ page }) => {
  await openCheck(page, '');
  await runProgram(page, 'for (;;) {}');
  expect(await told(page)).toContain('Stopped at case 1');
});

test('errors come with the line in the student’s code', async ({ page }) => {
  await openCheck(page, '');
  const source =
    'function helper(x) {\n  return x.nothing.more;\n}\n\nexport function intersect(shape, ray) {\n  return helper({});\n}\n';
  await runProgram(page, source);
  expect(await told(page)).toMatch(/threw in line 2: Cannot read properties of undefined/);
  await runProgram(page, 'function intersect(shape, ray) {\n  return {\n}\n\nlet let = 3;\n');
  expect(await told(page)).toMatch(/Line \d: syntax error/);
  await runProgram(page, '\n\nnope();');
  expect(await told(page)).toContain('Line 3: nope is not defined');
  await runProgram(page, 'const a = 1;');
  expect(await told(page)).toContain('there is no function intersect');
  await runProgram(page, body('throw null;'));
  expect(await told(page)).toContain('threw: null');
});

test('results of a wrong form are named', async ({ page }) => {
  await openCheck(page, '');
  for (const [line, words] of [
    ['return [1, 2];', 'returned an array'],
    ['return 3;', 'returned 3'],
    ['return;', 'returned nothing'],
    ['return { t: 3 };', 't is 3'],
    ['return { t: ["a"] };', "t holds 'a'"],
    ['return { t: new Array(1e6).fill(1) };', 't has 20 entries'],
    ['return { t: [1], normal: [[1, 2]] };', 'normal is not an array of triples'],
    ['return Promise.resolve({ t: [] });', 'a promise'],
    ['return { get t() { throw new Error("mine"); } };', 'threw in line 2: mine'],
    ['return { t: [NaN, NaN] };', 'NaN for'],
  ] as const) {
    await runProgram(page, body(line));
    expect.soft(await told(page), line).toContain(words);
  }
});

test('network, storage, page and top navigation are blocked and named', async ({ page }) => {
  await openCheck(page, '');
  const url = page.url();
  const storage = await page.evaluate(() => JSON.stringify(localStorage));
  for (const [line, words] of [
    ['fetch("https://example.com");', 'fetch: there is no network'],
    ['new XMLHttpRequest();', 'XMLHttpRequest: there is no network'],
    ['new WebSocket("wss://example.com");', 'WebSocket: there is no network'],
    ['navigator.sendBeacon("https://example.com", "x");', 'navigator: there is no network'],
    [
      'importScripts("https://example.com/x.js");',
      'importScripts: there is no loading of other code',
    ],
    ['new Worker("data:text/javascript,1");', 'Worker: there is no loading of other code'],
    ['import("https://example.com/x.js");', 'Failed to fetch dynamically imported module'],
    ['indexedDB.open("x");', 'indexedDB: there is no storage'],
    ['localStorage.setItem("x", "y");', 'localStorage: there is no storage'],
    ['caches.open("x");', 'caches: there is no storage'],
    ['parent.document.title = "x";', 'parent: there is no page'],
    ['top.location.href = "https://example.com";', 'top: there is no page'],
    ['location.href = "https://example.com";', 'location: there is no page'],
    ['document.body.remove();', 'there is no page in the sandbox'],
    ['window.open("https://example.com");', 'there is no page in the sandbox'],
    [
      'self.postMessage({ type: "done", id: 1 });',
      'postMessage: there is no message to the outside',
    ],
    ['close();', 'close: there is no message to the outside'],
    ['new BroadcastChannel("x");', 'BroadcastChannel: there is no message'],
    ['eval("1");', 'unsafe-eval'],
  ] as const) {
    await runProgram(page, body(line));
    expect.soft(await told(page), line).toContain(words);
  }
  expect(page.url().split('#')[0]).toBe(url.split('#')[0]);
  await expect(page).toHaveTitle(/Graze/);
  const after = await page.evaluate(() => {
    localStorage.removeItem('graze.check.program');
    return JSON.stringify(localStorage);
  });
  const without = JSON.parse(storage) as Record<string, string>;
  delete without['graze.check.program'];
  expect(JSON.parse(after)).toEqual(without);
});

test.describe('where the names are gone round', () => {
  test.use({ provoked: /Content.Security.Policy|violates|ERR_FAILED|request to http:\/\/127/i });

  test('the policy itself holds: nothing arrives at a server', async ({ page }) => {
    let arrived = 0;
    const server = createServer((_, response) => {
      arrived++;
      response.setHeader('Access-Control-Allow-Origin', '*');
      response.setHeader('Content-Type', 'text/javascript');
      response.end('');
    });
    await new Promise<void>((resolve) => {
      server.listen(0, '127.0.0.1', resolve);
    });
    const { port } = server.address() as { port: number };
    const url = `http://127.0.0.1:${port}/x.js`;
    await openCheck(page, '');
    // The server is there, and would be heard.
    expect(await (await page.request.get(url)).text()).toBe('');
    expect(arrived).toBe(1);
    await runProgram(page, body('(async () => 1).constructor("return fetch(1)")();'));
    expect(await told(page)).toContain('unsafe-eval');
    await runProgram(page, body(`import("${url}").catch(() => 0);`));
    await runProgram(page, `${body('')}\nimport("${url}");`);
    expect(await told(page)).toContain('dynamically imported module');
    expect(arrived).toBe(1);
    server.close();
  });
});

test('a run can be cancelled', async ({ page }) => {
  await openCheck(page, 'cases=all');
  await editor(page).fill(body('const end = Date.now() + 40; while (Date.now() < end);'));
  await page.getByRole('button', { name: 'Run', exact: true }).click();
  await expect(page.getByRole('progressbar')).toBeVisible();
  await page.getByRole('button', { name: 'Cancel' }).click();
  expect(await told(page)).toContain('Cancelled.');
  await expect(page.locator('iframe')).toHaveCount(0);
  await expect(page.getByRole('button', { name: 'Run', exact: true })).toBeVisible();
});

test('what was typed survives a reload', async ({ page }) => {
  await openCheck(page, '');
  await editor(page).fill('// mine\n');
  await page.reload();
  await expect(editor(page)).toHaveValue('// mine\n');
});
