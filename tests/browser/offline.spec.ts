import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { programOf } from '../../src/check/program/source.ts';
import { expectInLink, slider, typeInto } from './support/controls.ts';
import { openStep, ownLink } from './support/lesson.ts';
import { hashOf, quantities, settle } from './support/page.ts';
import { report, runProgram } from './support/program.ts';
import { expect, test } from './support/test.ts';

const root = fileURLToPath(new URL('../..', import.meta.url));
const USING = readFileSync(resolve(root, 'docs/USING.md'), 'utf8');
const FILE = pathToFileURL(
  resolve(root, process.env.E2E_OFFLINE ?? 'dist/offline/index.html'),
).href;

test.use({ viewport: { width: 940, height: 700 } });

test('one file, opened from disk, is the whole laboratory', async ({ page }) => {
  const asked: string[] = [];
  page.on('request', (request) => {
    if (!request.url().startsWith('data:')) asked.push(request.url());
  });
  await page.goto(`${FILE}#/explore?shape=cylinder&E=3,1,0&d=-1,0,0&r=1&method=exact`);
  await expect(page.locator('canvas')).toBeVisible();
  await expect(page.locator('[data-frames]')).toHaveAttribute('data-frames', /[1-9]/);
  expect(await quantities(page)).toMatchObject({
    A: '1',
    B: '-6',
    C: '8',
    D: '4',
    t1: '2',
    t2: '4',
  });
  await slider(page, 'E.x').press('ArrowRight');
  await typeInto(page, 'r', '1/2');
  expect(await quantities(page)).toMatchObject({ 'E.x': '3.1', r: '0.5', t1: '2.6', t2: '3.6' });
  await expectInLink(page, { E: '3.1,1,0', r: '1/2' });
  const link = await hashOf(page);
  await page.reload();
  await settle(page);
  expect(await hashOf(page)).toBe(link);
  await page.getByRole('button', { name: /^Theme/ }).click();
  expect(asked.filter((url) => !url.startsWith(FILE))).toEqual([]);
});

test('the mathematical font is in the file', async ({ page }) => {
  await page.goto(`${FILE}#/explore?shape=cone`);
  await page.locator('[data-quantity="class"]').waitFor();
  const status = await page.evaluate(async () => {
    await document.fonts.ready;
    const faces = [...document.fonts].filter(({ family }) => family.includes('STIX Two Math'));
    return faces.map((face) => face.status);
  });
  expect(status.length).toBeGreaterThan(0);
  expect(new Set(status)).toEqual(new Set(['loaded']));
});

test('it traces pictures too, with the workers that it holds inside', async ({ page }) => {
  await page.goto(
    `${FILE}#/picture?scene=everything&size=64x36&light=4&method=certified&pixel=30,22`,
  );
  await expect(page.locator('.picture')).toHaveAttribute('data-trace', 'finished');
  const rays = page.locator('[data-effect="camera"] [data-quantity="rays"]');
  await expect(rays).toHaveAttribute('data-value', String(64 * 36));
  await expect(page.locator('.rays tbody tr').first()).toBeVisible();
});

test('lessons are in it: those of Graze, and one that a link carries', async ({ page }) => {
  const [, text = ''] = USING.match(/```markdown\n([\s\S]*?)```/) ?? [];
  await page.goto(`${FILE}${ownLink(text, 3)}`);
  const said = page.locator('.lesson-text');
  await expect(said).toHaveText(/the formula finds: no point\. Right is: two points\./);
  await page.keyboard.press('PageUp');
  await page.keyboard.press('PageUp');
  await expect(said).toContainText('enters at t1=1.8 and leaves at t2=3');
  await openStep(page, '#/lesson/effects', 1);
  await expect(said).toContainText('rays make the whole picture');
});

test('a program runs in its sandbox there, too, and an endless one is ended', async ({ page }) => {
  await page.goto(`${FILE}#/check?part=program&cases=cylinder`);
  await runProgram(page, programOf('cylinder') ?? '');
  const typical = page.locator('.families tr[data-family="typical"]');
  await expect(typical).toHaveAttribute('data-passed', '14');
  await runProgram(page, 'function intersect() { for (;;) {} }');
  await expect(report(page)).toContainText('no sign of life for a second');
});
