import { createServer } from 'node:http';
import type { Page } from '@playwright/test';
import { findMisconception } from '../../src/check/misconceptions/index.ts';
import { LONGEST_PROGRAM } from '../../src/check/program/script.ts';
import { programOf } from '../../src/check/program/source.ts';
import { byTurns } from '../unit/many.ts';
import { withoutScene } from './support/page.ts';
import { editor, openCheck, report, runProgram, told } from './support/program.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

/*
 * A student's program in the real browser: what is right, what is wrong, and what is none of its
 * business.
 */

test.use({
  isolated: true,
  viewport: { width: 1280, height: 800 },
  // The policy says on the console what it stopped.
  provoked: /Content.Security.Policy|ERR_FAILED|net::ERR|example\.com|blocked/i,
});

const body = (line: string): string =>
  `function intersect(shape, ray) {\n  ${line}\n  return { t: [] };\n}\n`;

async function passesAll(page: Page, group: string): Promise<void> {
  const score = report(page).locator(`[data-quantity="passed.${group}"]`);
  const total = await score.getAttribute('data-total');
  expect(Number(total)).toBeGreaterThan(0);
  await expect(score).toHaveAttribute('data-value', total ?? '');
}

/** The page still answers, and the sandbox goes. */
async function alive(page: Page): Promise<void> {
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
  for (const group of ['ordinary', 'special']) await passesAll(page, group);
  for (const method of ['textbook', 'certified']) {
    const beside = page.locator(`[data-quantity="passed.hard.${method}"]`);
    await expect(beside).toHaveAttribute('data-value', /\d/);
  }
  await expect(page.locator('[data-quantity="multiple"]')).toHaveAttribute('data-value', /\d/);
  expect(await told(page)).toContain('in the middle half of the rounds');
  await expect(report(page).locator('[data-cause]')).toHaveCount(0);
  await expect(editor(page)).toHaveValue(source);
  await alive(page);
});

test('causes are named, two at once too', async ({ page }) => {
  await openCheck(page, 'cases=cone');
  const minusLost = findMisconception('lost-minus');
  const turned = findMisconception('normal-turned');
  if (!minusLost || !turned) throw new Error('no such misconception');
  await runProgram(
    page,
    programOf('cone', (course) => turned.edit(minusLost.edit(course) ?? course)) ?? '',
  );
  for (const id of ['lost-minus', 'normal-turned']) {
    await expect(report(page).locator(`[data-cause="${id}"]`)).toHaveCount(1);
  }
});

test('the smallest failing case of each branch is found, drawn, and opened in Explore', async ({
  page,
}) => {
  await openCheck(page, 'cases=cylinder');
  const lost = findMisconception('strict');
  if (!lost) throw new Error('no such misconception');
  await runProgram(page, programOf('cylinder', (course) => lost.edit(course)) ?? '');
  await expect(report(page)).toHaveAttribute('data-shrinking', 'false', { timeout: 60_000 });
  const rows = report(page).locator('[data-branch]');
  await expect(rows.first()).toHaveAttribute('data-branch', 'two');
  await expect(report(page).locator('[data-branch="two"] button')).toHaveCount(0);
  const failing = report(page).locator('[data-branch="tangent"]');
  await expect(failing).toHaveAttribute('data-passed', '0');
  await expect(failing).toHaveAttribute('data-selected', 'true');
  const text = await report(page).locator('.failure').innerText();
  expect(text).toContain('misses the hit');
  // Whole numbers of one digit.
  expect(text.split('expected')[0]).not.toMatch(/\d[.\d]/);
  await page.getByRole('link', { name: 'See it in Explore' }).click();
  await expect(page.getByRole('main')).toContainText('double, touches');
  // A search that is cancelled leaves the report as it is, and a new run ends it.
  await openCheck(page, 'cases=cylinder');
  const run = page.getByRole('button', { name: 'Run', exact: true });
  await run.click();
  await report(page).getByRole('button', { name: 'Cancel' }).click();
  await expect(report(page)).toHaveAttribute('data-shrinking', 'false');
  await expect(failing).toHaveAttribute('data-passed', '0');
  await expect(page.locator('iframe')).toHaveCount(0);
});

test('a program may use any name, and export what it likes', async ({ page }) => {
  await openCheck(page, 'cases=plane');
  const names = ['top', 'parent', 'location', 'frames', 'navigator', 'caches', 'opener', 'fetch'];
  const more = ['textbook', 'run', 'post', 'self', 'window', 'intersects', 'name', 'status'];
  const all = [...names, ...more].map((name) => `const ${name} = 1;`).join('\n');
  const close = 'function close(a, b) { return Math.abs(a - b) < 1e-9; }';
  await runProgram(page, `${all}\n${close}\n${programOf('plane') ?? ''}`);
  await passesAll(page, 'ordinary');
  await expect(page.locator('[data-quantity="multiple"]')).toHaveAttribute('data-value', /\d/);
  await runProgram(page, `${programOf('plane', undefined, 'hit') ?? ''}\nexport default hit;`);
  await passesAll(page, 'ordinary');
  await runProgram(page, 'function intersect(shape: Shape, ray: Ray) {}');
  // Types are taken away: it runs, and meets nothing.
  expect(await told(page)).toContain('It never returns a root');
});

test('what a program writes on its console is shown, as text and with a limit', async ({
  page,
}) => {
  await openCheck(page, 'cases=plane');
  const lines = [
    "console.log('<b>d</b>', ray.direction, { a: [1, { b: -0 }] });",
    "console.warn('x'.repeat(1e6));",
    'for (let i = 0; i < 1000; i++) console.error(i);',
  ];
  await runProgram(page, `console.log('at the top');\n${body(lines.join(' '))}`);
  const shown = await page.locator('.console pre').innerText();
  expect(shown).toMatch(
    /^at the top\ncase 1 {2}<b>d<\/b> \[[-\d.e, ]+\] \{a: \[1, \{b: -0\}\]\}\n/,
  );
  expect(shown).toContain('case 1  warning: xxxx');
  expect(shown).toContain('case 1  error: 96');
  expect(shown).toContain('more was written');
  expect(shown.length).toBeLessThan(5000);
});

test('messages of any size and number: the run ends, and the page lives', async ({ page }) => {
  await openCheck(page, 'cases=plane');
  const never = 'function intersect() { return { t: [] }; }';
  for (const [what, source, words] of [
    [
      'errors of 16 MB',
      "const s = 'x'.repeat(2 ** 24); function intersect() { throw new Error(s); }",
      'threw in line 1: xxxx',
    ],
    ['results of 16 MB', body("return { t: ['x'.repeat(2 ** 24)] };"), 't holds text'],
    [
      '20,000 rejections',
      `${never}\nfor (let i = 0; i < 20000; i++) Promise.reject(i);`,
      'on the way: 19',
    ],
    [
      'no timers, and a rejection now and then for ever',
      `${never}\nsetInterval(() => Promise.reject('again'), 200); setTimeout = () => 0;`,
      'It never returns a root',
    ],
    [
      'functions of the language that shout',
      "String.prototype.slice = String.prototype.replace = () => 'x'.repeat(2 ** 24); " +
        'function intersect() { throw 1; }',
      'threw: 1',
    ],
  ] as const) {
    await runProgram(page, source);
    const all = await told(page);
    expect(all, what).toContain(words);
    expect(all.length, what).toBeLessThan(20_000);
    await expect(editor(page)).toHaveValue(source);
  }
  await alive(page);
});

test('a time cannot be forged, and chance is noticed', async ({ page }) => {
  await openCheck(page, 'cases=plane');
  const program = programOf('plane') ?? '';
  await runProgram(page, `Math.sqrt = () => 1;\n${program}`);
  expect(await told(page)).toContain('was not measured: it replaces functions of the language');
  await expect(page.locator('[data-quantity="multiple"]')).toHaveCount(0);
  await runProgram(page, body('return { t: [Math.random()] };'));
  expect(await told(page)).toContain('run twice, gave two results');
});

test('a text that is too long is not taken, and nothing is lost', async ({ page }) => {
  await openCheck(page, 'cases=plane');
  await editor(page).fill('// mine');
  const long = '\n'.repeat(LONGEST_PROGRAM + 1);
  await editor(page).fill(long);
  const refusal = page.locator('.refusal');
  await expect(refusal).toContainText(`a program may have up to ${LONGEST_PROGRAM}`);
  await expect(editor(page)).toHaveValue('// mine');
  await editor(page).fill('// mine, too');
  await expect(refusal).toBeEmpty();
  await page.evaluate((text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], 'intersect.js'));
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true }));
  }, `function intersect() {}${long}`);
  await expect(refusal).toContainText('The file was not taken');
  await expect(editor(page)).toHaveValue('// mine, too');
  // As an older version may have left it.
  await page.evaluate((text) => localStorage.setItem('graze.check.program', text), long);
  await page.reload();
  await expect(refusal).toContainText('this device remembers is not shown');
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save it as a file' }).click(),
  ]);
  expect(file.suggestedFilename()).toBe('intersect.js');
});

test.describe('a sandbox that cannot be opened', () => {
  test.use({ provoked: /404|ERR_|X-Frame-Options|Content.Security.Policy|frame|blocked|refused/i });
  for (const [what, answer, words] of [
    ['is missing', { status: 404, body: 'gone' }, 'the server answers 404'],
    ['is another page', { contentType: 'text/html', body: '<h1>Start</h1>' }, 'another page'],
    ['is forbidden to be framed', { headers: { 'X-Frame-Options': 'DENY' } }, 'X-Frame-Options'],
    [
      'may run no script',
      { headers: { 'Content-Security-Policy': "default-src 'self'" } },
      'Content-Security-Policy',
    ],
    [
      'may start no worker',
      { headers: { 'Content-Security-Policy': "script-src 'unsafe-inline'; worker-src 'none'" } },
      'Content-Security-Policy',
    ],
    ['never comes', null, 'sandbox.html cannot be fetched'],
  ] as const) {
    test(`since it ${what}, is said to be that, and nothing is graded`, async ({ page }) => {
      await page.clock.install();
      await openCheck(page, 'cases=plane');
      await page.route('**/sandbox.html', async (route) => {
        // Asked again from the page, after the frame has failed: then the connection is known to be
        // broken.
        if (answer === null) {
          if (route.request().resourceType() === 'fetch') await route.abort();
          return;
        }
        if ('body' in answer) await route.fulfill(answer);
        else {
          const response = await route.fetch();
          await route.fulfill({ response, headers: { ...response.headers(), ...answer.headers } });
        }
      });
      await page.getByRole('button', { name: 'Run', exact: true }).click();
      await expect(async () => {
        await page.clock.fastForward(6000);
        expect(await told(page)).toContain('The sandbox could not be opened');
      }).toPass();
      expect(await told(page)).toContain(words);
      expect(await told(page)).toContain('Your program was not run.');
      await expect(page.locator('.scores, .families')).toHaveCount(0);
      await expect(page.locator('iframe')).toHaveCount(0);
      await expect(page.getByRole('button', { name: 'Run', exact: true })).toBeVisible();
    });
  }
});

test('endless loops and bombs are ended, and the page lives', async ({ page }) => {
  await openCheck(page, 'cases=plane');
  for (const [what, line] of byTurns([
    ['an endless loop', 'for (;;) {}'],
    ['an endless loop with a little work', 'let k = 0; while (true) k += Math.sqrt(k);'],
    ['a bomb of bytes', 'const all = []; for (;;) all.push(new Uint8Array(1e8).fill(1));'],
    ['a bomb of arrays', 'const all = []; for (;;) all.push(new Array(1e6).fill(1));'],
  ] as const)) {
    const source = body(line);
    await runProgram(page, source);
    expect(await told(page), what).toContain('no sign of life for a second');
    expect(await told(page), what).toContain('did not end within a second');
    await expect(editor(page)).toHaveValue(source);
    await runProgram(page, body('return { t: [] };'));
    expect(await told(page), `after ${what}`).toContain('It never returns a root');
  }
  await runProgram(page, body('let s = "x"; for (;;) s += s + s;'));
  expect(await told(page)).toContain('threw in line 2: Invalid string length');
  await runProgram(page, 'for (;;) {}');
  expect(await told(page)).toContain('Stopped at case 1');
  await alive(page);
});

test('errors come with the line in the student’s code', async ({ page }) => {
  await openCheck(page, 'cases=plane');
  const source =
    'function helper(x) {\n  return x.nothing.more;\n}\n\nexport function ' +
    'intersect(shape, ray) {\n  return helper({});\n}\n';
  await runProgram(page, source);
  expect(await told(page)).toMatch(/threw in line 2: .*undefined/);
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
  await openCheck(page, 'cases=plane');
  for (const [line, words] of [
    ['return ["a", 2];', 'returned an array'],
    ['return [1, 2];', 'it returned a plain array'],
    ['return { t: ["a"] };', 't holds text'],
    ['return { t: new Array(1e6).fill(1) };', 't has 20 entries'],
    ['return { t: [1], normal: [[1, 2]] };', 'normal is not an array of triples'],
    ['return Promise.resolve({ t: [] });', 'a promise'],
    ['return { get t() { throw new Error("mine"); } };', 'threw in line 2: mine'],
  ] as const) {
    await runProgram(page, body(line));
    expect.soft(await told(page), line).toContain(words);
  }
});

/** Each is stopped at once, and says so. */
const FORBIDDEN = [
  ['fetch("https://example.com");', 'fetch: there is no network'],
  ['new XMLHttpRequest();', 'XMLHttpRequest: there is no network'],
  ['new WebSocket("wss://example.com");', 'WebSocket: there is no network'],
  ['navigator.sendBeacon("https://example.com", "x");', 'navigator: there is no network'],
  [
    'importScripts("https://example.com/x.js");',
    'importScripts: there is no loading of other code',
  ],
  ['new Worker("data:text/javascript,1");', 'Worker: there is no loading of other code'],
  ['indexedDB.open("x");', 'indexedDB: there is no storage'],
  ['localStorage.setItem("x", "y");', 'localStorage: there is no storage'],
  ['caches.open("x");', 'caches: there is no storage'],
  ['parent.document.title = "x";', 'parent: there is no page'],
  ['top.location.href = "https://example.com";', 'top: there is no page'],
  ['location.href = "https://example.com";', 'location: there is no page'],
  ['document.body.remove();', 'there is no page in the sandbox'],
  ['window.open("https://example.com");', 'there is no page in the sandbox'],
  ['self.postMessage({ type: "done", id: 1 });', 'postMessage: there is no message to the outside'],
  ['close();', 'close: there is no message to the outside'],
  ['new BroadcastChannel("x");', 'BroadcastChannel: there is no message'],
  ['eval("1");', 'unsafe-eval'],
] as const;

test('network, storage, page and top navigation are blocked and named', async ({ page }) => {
  await openCheck(page, 'cases=plane');
  const url = page.url();
  const storage = await page.evaluate(() => JSON.stringify(localStorage));
  // What happens outside of a case is noted; three notes are shown.
  for (let i = 0; i < FORBIDDEN.length; i += 3) {
    const some = FORBIDDEN.slice(i, i + 3);
    const tried = some.map(([line]) => `try { ${line} } catch (e) { Promise.reject(e); }`);
    await runProgram(page, `${tried.join('\n')}\n${body('')}`);
    const notes = await told(page);
    for (const [line, words] of some) expect.soft(notes, line).toContain(words);
  }
  // As one that is not caught, in a case.
  for (const [line, words] of [
    ['fetch("https://example.com");', 'fetch: there is no network'],
    ['document.body.remove();', 'there is no page in the sandbox'],
    ['import("https://example.com/x.js");', 'Failed to fetch dynamically imported module'],
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
    await openCheck(page, 'cases=plane');
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
  await expect(report(page)).toContainText('Cancelled.');
  await expect(page.locator('iframe')).toHaveCount(0);
  await expect(page.getByRole('button', { name: 'Run', exact: true })).toBeVisible();
});

test('what was typed survives a reload', async ({ page }) => {
  await openCheck(page, 'cases=plane');
  await editor(page).fill('// mine\n');
  await page.reload();
  await expect(editor(page)).toHaveValue('// mine\n');
});
