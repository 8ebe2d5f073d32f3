import { byTurns } from '../unit/many.ts';
import { violationsInThemes } from './support/axe.ts';
import { open, settle } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

test.use({ viewport: { width: 1280, height: 720 } });

const SIZES = [
  { width: 1280, height: 720 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
  { width: 844, height: 390 },
] as const;

test('axe finds nothing in full screen, on Explore and in a lesson', async ({ page }) => {
  await open(page, '#/explore?shape=cone&E=4,1,0.5&d=-1,0,0');
  await page.keyboard.press('f');
  await page.waitForFunction(() => document.fullscreenElement !== null);
  for (const [n, size] of SIZES.entries()) {
    await page.setViewportSize(size);
    for (const link of byTurns(['#/explore?shape=cone', '#/lesson/ray?step=5'], n)) {
      await open(page, link);
      await page.locator('main :is(.lesson-text, .algebra)').filter({ visible: true }).waitFor();
      expect.soft(await violationsInThemes(page), `${link} ${size.width} px`).toEqual([]);
    }
  }
  await page.evaluate(() => document.exitFullscreen());
});

test('axe finds nothing in the dialogs and the states of the page', async ({ page }) => {
  await open(page, '#/explore?shape=square');
  await page.locator('canvas').waitFor();
  for (const [key, name] of [
    ['x', 'Examples'],
    ['e', 'File and export'],
    ['?', 'Help'],
  ] as const) {
    await page.keyboard.press(key);
    const dialog = page.getByRole('dialog', { name });
    await expect(dialog.getByRole('button').nth(1).or(dialog.locator('kbd').first())).toBeVisible();
    expect.soft(await violationsInThemes(page, 'dialog[open]'), name).toEqual([]);
    await page.keyboard.press('Escape');
    await expect(dialog).toBeHidden();
  }
  // The derivation beside the scene: a flat shape's last step, and the bill of a cone's terms.
  for (const link of ['#/explore?shape=square&derive=5', '#/explore?shape=cone&derive=4']) {
    await open(page, link);
    await page.locator('.walk').waitFor();
    expect.soft(await violationsInThemes(page), link).toEqual([]);
  }
  await page.keyboard.press('Escape');
  await expect(page.locator('.walk')).toBeHidden();
  await page.keyboard.press('PageDown');
  // An example with a kept ray, and then with hidden results.
  for (const key of ['g', 'h']) {
    await page.keyboard.press(key);
    await settle(page);
    expect.soft(await violationsInThemes(page), `after ${key}`).toEqual([]);
  }
});
