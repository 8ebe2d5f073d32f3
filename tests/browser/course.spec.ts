import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { FrameLocator, Locator, Page } from '@playwright/test';
import { strFromU8, unzipSync } from 'fflate';
import { plan, question, studentSeed } from '../../src/check/session.ts';
import type { Answer } from '../../src/check/types.ts';
import { pageWithCourse } from '../../src/state/course/package.ts';
import { readHandIn } from '../../src/state/hand-in.ts';
import { shortest } from '../../src/text/format.ts';
import { violationsInThemes } from './support/axe.ts';
import { NO_SCENE, withoutScene } from './support/page.ts';
import { openCheck } from './support/program.ts';
import { expect, test } from './support/test.ts';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const SET = 'coefficients,roots;shapes=cylinder;level=1';
const LINK = 'set=coefficients,roots&shapes=cylinder&level=1&seed=41';

/** The scene is kept away; a frame as Moodle may make it gets a word of warning. */
const PROVOKED = new RegExp(`${NO_SCENE.source}|^An iframe which has both allow-scripts and`);

test.use({ provoked: PROVOKED, viewport: { width: 700, height: 600 } });

const asText = (answer: Answer | undefined): string => {
  if (typeof answer === 'number') return shortest(answer);
  return typeof answer === 'object' ? answer.map(shortest).join(', ') : (answer ?? '');
};

const SITE = process.env.E2E_SITE ?? 'dist/site';

/** The page of a package for this system, as the page of a set makes it. */
const pageFor = (system: string, baseURL: string | undefined): string => {
  const activity = `${baseURL}#/check?${LINK}`;
  const course = { system, set: SET, seed: 41, pass: 50, own: true, activity };
  const page = readFileSync(resolve(ROOT, SITE, 'offline.html'), 'utf8');
  return pageWithCourse(page, course, `#/check?${LINK}`);
};

/** The files of a package that the page of a set saves, by name. */
async function packageOf(page: Page, button: string): Promise<Record<string, string>> {
  await openCheck(page, `part=set&${LINK}`);
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: button, exact: true }).click(),
  ]);
  const files = unzipSync(readFileSync(await file.path()));
  return Object.fromEntries(
    Object.entries(files).map(([name, bytes]) => [name, strFromU8(bytes)] as const),
  );
}

/** Serves a package's page, and a course system with a frame that shows it. */
async function serve(
  page: Page,
  { html, script, api, sandbox }: Record<'html' | 'script' | 'api' | 'sandbox', string>,
): Promise<void> {
  const library = readFileSync(resolve(ROOT, `node_modules/scorm-again/dist/${script}`), 'utf8');
  const name = script.startsWith('scorm12') ? 'Scorm12API' : 'Scorm2004API';
  const system =
    '<!doctype html><title>course system</title><link rel="icon" href="data:,">' +
    '<script src="library.js"></script><script>' +
    `const api = window.${api} = new ${name}({ autocommit: false, logLevel: 5 });` +
    "const kept = sessionStorage.getItem('kept'); if (kept) api.loadFromJSON(JSON.parse(kept));" +
    'const keep = () => sessionStorage.setItem("kept", JSON.stringify(api.cmi));' +
    `api.on('${name === 'Scorm12API' ? 'LMSCommit' : 'Commit'}', keep);` +
    `</script><iframe title="package" sandbox="${sandbox}" src="package/index.html"` +
    ' style="width:95vw;height:90vh"></iframe>';
  const texts: Readonly<Record<string, readonly [string, string]>> = {
    'index.html': ['text/html', system],
    'library.js': ['text/javascript', library],
    'package/index.html': ['text/html', html],
  };
  await page.unroute('**/system/**');
  await page.route('**/system/**', (route) => {
    const path = new URL(route.request().url()).pathname.replace(/^.*\/system\//, '');
    const [contentType, body] = texts[path] ?? ['text/plain', ''];
    return route.fulfill({ contentType, body });
  });
}

async function answer(frame: FrameLocator | Locator, seed: number, index: number): Promise<void> {
  const { fields, truth } = question(seed, index, SET);
  for (const { id } of fields) {
    await frame.locator(`.answer[data-field="${id}"] input`).fill(asText(truth[id]));
  }
  await frame.locator('.answers').getByRole('button', { name: 'Check', exact: true }).click();
}

const VERSIONS = [
  {
    system: 'scorm12',
    script: 'scorm12.min.js',
    api: 'API',
    learner: { core: { student_id: 's1234' } },
    done: { status: 'cmi.core.lesson_status', values: ['incomplete', 'passed'] },
    score: 'cmi.core.score.raw',
    get: 'LMSGetValue',
  },
  {
    system: 'scorm2004',
    script: 'scorm2004.min.js',
    api: 'API_1484_11',
    learner: { learner_id: 's1234' },
    done: { status: 'cmi.success_status', values: ['unknown', 'passed'] },
    score: 'cmi.score.raw',
    get: 'GetValue',
  },
] as const;

for (const { system, script, api, learner, done, score, get } of VERSIONS) {
  test(`${system}: a package reports to a course system, and goes on later`, async ({
    page,
    baseURL,
  }) => {
    await withoutScene(page);
    const html = pageFor(system, baseURL);
    await serve(page, { html, script, api, sandbox: 'allow-scripts allow-same-origin' });
    const value = (element: string): Promise<string> =>
      page.evaluate(
        ([name, method, path]) =>
          (window as unknown as Record<string, Record<string, (path: string) => string>>)[
            name as string
          ]?.[method as string]?.(path as string) ?? '',
        [api, get, element],
      );
    await page.goto('./sandbox.html');
    await page.evaluate((kept) => sessionStorage.setItem('kept', kept), JSON.stringify(learner));
    await page.goto('./system/index.html');
    const frame = page.frameLocator('iframe');
    const seed = studentSeed(41, 's1234');
    const course = frame.locator('.course');
    await expect(course).toContainText('0 of 2 right, 0 done');
    await answer(frame, seed, 0);
    await expect(course).toContainText('1 of 2 right, 1 done: reported to the course system.');
    await expect(frame.locator('main .summary')).not.toContainText('sent');
    expect(await value(score)).toBe('50.00');
    expect(await value(done.status)).toBe(done.values[0]);
    expect(await value('cmi.interactions._count')).toBe('1');
    const state = await value('cmi.suspend_data');
    const { who, asked } = readHandIn(state);
    expect([who, asked[0]?.solvedAt]).toEqual(['s1234', 1]);
    // Another set is a student's own affair.
    await frame.getByLabel('seed', { exact: true }).fill('5');
    await frame.getByLabel('seed', { exact: true }).press('Enter');
    await expect(course).toContainText('not the questions of the course');
    await frame.getByRole('button', { name: 'Back to them' }).click();
    await frame.getByRole('button', { name: /^Question 2,/ }).click();
    // Question 1 has boxes as well, until the next frame.
    await expect(frame.getByRole('heading', { name: 'Question 2 of 2' })).toBeVisible();
    await frame.locator('.answer input').first().fill('half typed');
    // The page is left, and opened again by the same student.
    await page.evaluate(() => {
      const package_ = document.querySelector('iframe');
      if (package_) package_.src = 'about:blank';
    });
    // Then all that the package had to say has been said.
    await expect.poll(() => page.frames()[1]?.url()).toBe('about:blank');
    expect(await page.evaluate(() => sessionStorage.getItem('kept'))).not.toContain(state);
    await page.evaluate(() => localStorage.clear());
    await page.reload();
    await expect(frame.getByRole('heading', { name: 'Question 2 of 2' })).toBeVisible();
    await expect(frame.locator('.answer input').first()).toHaveValue('half typed');
    await expect(course).toContainText('1 of 2 right, 1 done');
    expect(await violationsInThemes(page, 'iframe')).toEqual([]);
    await frame.getByRole('button', { name: 'Hand in as it is' }).press('Enter');
    await expect(course).toContainText('Handed in: 1 of 2 right, passed (from 50 % on)');
    expect(await value(done.status)).toBe(done.values[1]);
    await answer(frame, seed, 1);
    await expect(course).toContainText('Handed in: 2 of 2 right');
    expect(Number(await value(score))).toBe(100);
    expect(plan(seed, SET)).toHaveLength(2);
  });
}

test('where no course system is reached, the page says why, and the code has everything', async ({
  page,
  baseURL,
}) => {
  await withoutScene(page);
  const { 'index.html': html = '', ...others } = await packageOf(page, 'SCORM 1.2');
  expect(Object.keys(others)).toEqual(['imsmanifest.xml']);
  expect(html === pageFor('scorm12', baseURL)).toBe(true);
  // A frame of no origin has no storage either.
  await serve(page, { html, script: 'scorm12.min.js', api: 'API', sandbox: 'allow-scripts' });
  await page.goto('./system/index.html');
  const frame = page.frameLocator('iframe');
  const course = frame.locator('.course');
  await expect(course).toContainText('the windows around this page are out of its reach');
  await answer(frame, 41, 0);
  await expect(frame.locator('.feedback').first()).toHaveAttribute('data-verdict', 'correct');
  await frame.locator('main').getByText('Hand in', { exact: true }).click();
  const code = await frame.getByLabel('Code', { exact: true }).inputValue();
  expect(readHandIn(code).asked[0]?.solvedAt).toBe(1);
  await page.goto('./system/package/index.html');
  await expect(page.locator('main .course')).toContainText('there is none in the windows around');
});

test.describe('a record store', () => {
  // It answers so where nothing is kept yet, which the browser says by itself.
  test.use({
    provoked: new RegExp(`${PROVOKED.source}|^Failed to load resource: .* 40[34]`),
  });

  test('gets statements of a package that is launched with its address', async ({
    page,
    baseURL,
  }) => {
    await withoutScene(page);
    await serve(page, {
      ...{ html: pageFor('xapi', baseURL), script: 'scorm12.min.js', api: 'API' },
      sandbox: 'allow-scripts',
    });
    const heard: { readonly verb: string; readonly actor: string; readonly auth: string }[] = [];
    let kept = '';
    await page.route('**/store/**', async (route) => {
      const request = route.request();
      if (request.url().includes('/activities/state')) {
        if (request.method() === 'PUT') kept = request.postData() ?? '';
        const isThere = request.method() === 'PUT' || kept !== '';
        await route.fulfill({ status: isThere ? 200 : 404, body: kept });
        return;
      }
      const auth = request.headers().authorization ?? '';
      for (const { verb, actor } of request.postDataJSON()) {
        heard.push({ verb: verb.id.replace(/^.*\//, ''), actor: actor.account.name, auth });
      }
      await route.fulfill({ status: 200, body: '[]' });
    });
    const actor = { account: { homePage: 'https://school.example', name: 'Zoë' } };
    const launch = new URLSearchParams({
      endpoint: `${baseURL}store`,
      auth: 'Basic abc=',
      actor: JSON.stringify(actor),
    });
    await page.goto(`./system/package/index.html?${launch}`);
    const course = page.locator('main .course');
    await expect(course).toContainText('0 of 2 right');
    const seed = studentSeed(41, 'Zoë');
    const frame = page.locator('body');
    await answer(frame, seed, 0);
    await expect(course).toContainText('1 of 2 right, 1 done: reported');
    await course.getByRole('button', { name: 'Hand in as it is' }).click();
    await expect(course).toContainText('Handed in: 1 of 2 right, passed');
    expect(heard.map(({ verb }) => verb)).toEqual(['answered', 'completed', 'passed']);
    expect(new Set(heard.map((one) => `${one.actor} ${one.auth}`))).toEqual(
      new Set(['Zoë Basic abc=']),
    );
    await page.evaluate(() => localStorage.clear());
    await page.reload();
    await expect(course).toContainText('Handed in: 1 of 2 right, passed');
  });

  test('that refuses statements gets them by hand, as a file or on the next visit', async ({
    page,
    baseURL,
  }) => {
    await withoutScene(page);
    await serve(page, {
      ...{ html: pageFor('xapi', baseURL), script: 'scorm12.min.js', api: 'API' },
      sandbox: 'allow-scripts',
    });
    const heard: { readonly verb: { readonly id: string } }[] = [];
    let kept = '';
    let status = 403;
    await page.route('**/store/**', async (route) => {
      const request = route.request();
      if (request.url().includes('/activities/state')) {
        if (request.method() === 'PUT') kept = request.postData() ?? '';
        await route.fulfill({ status: kept === '' ? 404 : 200, body: kept });
        return;
      }
      if (status === 200) heard.push(...request.postDataJSON());
      await route.fulfill({ status, body: '[]' });
    });
    const actor = { account: { homePage: 'https://school.example', name: 'Zoë' } };
    const launch = new URLSearchParams({
      endpoint: `${baseURL}store`,
      actor: JSON.stringify(actor),
    });
    await page.goto(`./system/package/index.html?${launch}`);
    const course = page.locator('main .course');
    await expect(course).toContainText('0 of 2 right');
    await answer(page.locator('body'), studentSeed(41, 'Zoë'), 0);
    await expect(course).toContainText('One statement waits, also for your next visit');
    await course.getByRole('button', { name: 'Hand in as it is' }).click();
    await expect(course).toContainText('did not take the last report: it answers 403');
    await expect(course).toContainText('3 statements wait');
    expect(await violationsInThemes(page, '.course')).toEqual([]);
    const [file] = await Promise.all([
      page.waitForEvent('download'),
      course.getByRole('button', { name: 'Save it' }).click(),
    ]);
    const saved = JSON.parse(readFileSync(await file.path(), 'utf8'));
    await page.reload();
    await expect(course).toContainText('3 statements wait');
    status = 200;
    await course.getByRole('button', { name: 'Report again' }).click();
    await expect(course).toContainText('Handed in: 1 of 2 right, passed');
    await expect(course).not.toContainText('wait');
    expect(heard).toEqual(saved);
    expect(heard.map(({ verb }) => verb.id.replace(/^.*\//, ''))).toEqual([
      ...['answered', 'completed', 'passed'],
    ]);
  });
});
