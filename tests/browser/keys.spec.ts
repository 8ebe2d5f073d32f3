import { SHAPES } from '../../src/math/index.ts';
import { box, expectInLink, slider } from './support/controls.ts';
import {
  hashOf,
  linkWritten,
  NO_SCENE,
  open,
  quantities,
  settle,
  withoutScene,
} from './support/page.ts';
import { frames } from './support/pending.ts';
import { expect, test } from './support/test.ts';

test.use({ provoked: NO_SCENE });
test.beforeEach(async ({ page }) => {
  await withoutScene(page);
  await open(page, '#/explore');
});

test('1 to 6 pick the shape', async ({ page }) => {
  for (const [i, { kind }] of SHAPES.entries()) {
    await page.keyboard.press(String(i + 1));
    await expectInLink(page, { shape: kind });
  }
});

test('digits and letters typed into a box are text', async ({ page }) => {
  const before = await hashOf(page);
  await box(page, 'c').focus();
  await page.keyboard.type('1hgt');
  await settle(page);
  expect(await hashOf(page)).toBe(before);
  await expect(box(page, 'c')).toHaveValue('1hgt');
});

test('on a slider Page Down belongs to the slider, and Shift makes a step fine', async ({
  page,
}) => {
  await slider(page, 'c').press('PageDown');
  await slider(page, 'c').press('ArrowRight');
  await slider(page, 'c').press('Shift+ArrowRight');
  await settle(page);
  expect((await quantities(page)).c).toBe('0.322');
  await expect(page.locator('.example-name')).toContainText('choose one');
});

test('the help lists every key', async ({ page }) => {
  await page.keyboard.press('?');
  const help = page.getByRole('dialog', { name: 'Help' });
  await expect(help).toBeVisible();
  const keys = await help.locator('kbd').allInnerTexts();
  const some = ['1', '6', 'Page Down', 'h', 'g', 'b', 'Ctrl+Z', '?'];
  expect(keys).toEqual(expect.arrayContaining(some));
  await page.keyboard.press('Escape');
  await expect(help).toBeHidden();
});

test('on another page it lists what works there, and how that page is worked', async ({ page }) => {
  await page.getByRole('link', { name: 'Check' }).click();
  await expect(page.getByRole('heading', { name: /Question 1/ })).toBeVisible();
  await page.keyboard.press('?');
  const help = page.getByRole('dialog', { name: 'Help' });
  await expect(help).toContainText('Enter hands in an answer');
  const keys = await help.locator('kbd').allInnerTexts();
  expect(keys).toEqual(expect.arrayContaining(['Ctrl+Z', 's', '?']));
  expect(keys).not.toContain('g');
  await page.keyboard.press('Escape');
  await page.keyboard.press('6');
  await expect(page).toHaveURL(/shape=cone/);
});

test('single keys can be switched off, and stay off', async ({ page }) => {
  await page.keyboard.press('?');
  await page.getByLabel(/single letters and digits/).uncheck();
  await page.keyboard.press('Escape');
  await expectInLink(page, { shape: 'cone' });
  await page.keyboard.press('1');
  await linkWritten(page);
  await expectInLink(page, { shape: 'cone' });
  await page.reload();
  await page.locator('[data-quantity="class"]').waitFor();
  await page.keyboard.press('2');
  await linkWritten(page);
  await expectInLink(page, { shape: 'cone' });
  await page.keyboard.press('PageDown');
  await expect(page.locator('.example-name')).toContainText('one point');
});

const beadAt = async (page: Parameters<typeof quantities>[0]) =>
  Number((await quantities(page))['bead.t']);

test('the bead plays, and stands still when it is stopped', async ({ page }) => {
  await page.keyboard.press('b');
  await expect.poll(() => beadAt(page)).toBeLessThan(1);
  await expect.poll(() => beadAt(page)).toBeGreaterThan(1);
  await page.keyboard.press('b');
  await settle(page);
  const rest = await beadAt(page);
  // While it plays it moves with every frame.
  await frames(page, 20);
  expect(await beadAt(page)).toBe(rest);
});

test('with less motion the bead steps from root to root', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  const { t1 } = await quantities(page);
  const seen = new Set<string>();
  await page.keyboard.press('b');
  await settle(page);
  await expect
    .poll(async () => {
      seen.add((await quantities(page))['bead.t'] ?? '');
      return [...seen];
    })
    .toContain(t1);
  await page.keyboard.press('b');
  expect(seen.size).toBeLessThanOrEqual(3);
});
