import { GALLERY } from '../../src/state/gallery/index.ts';
import { NO_SCENE, open, withoutScene } from './support/page.ts';
import { expect, test } from './support/test.ts';

test.use({ provoked: NO_SCENE, viewport: { width: 1280, height: 720 } });
test.beforeEach(({ page }) => withoutScene(page));

test('on the projector everything is on one screen, for every example', async ({ page }) => {
  await page.addInitScript(() => localStorage.setItem('graze.theme', 'projector'));
  await open(page, '#/explore');
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'projector');
  const tooLarge: string[] = [];
  for (const { id, link } of GALLERY) {
    await open(page, link);
    const { height, width } = await page.evaluate(() => ({
      height: document.documentElement.scrollHeight,
      width: document.documentElement.scrollWidth,
    }));
    if (height > 720 || width > 1280) tooLarge.push(`${id}: ${width} × ${height}`);
  }
  expect(tooLarge).toEqual([]);
});

test('and its type is large', async ({ page }) => {
  await page.addInitScript(() => localStorage.setItem('graze.theme', 'projector'));
  await open(page, '#/explore');
  const sizes = await page.evaluate(() =>
    ['.verdict', '.hit .value', '.result .value', '.tab-param', '.example-name'].map((what) => {
      const element = document.querySelector(what);
      return element ? Number.parseFloat(getComputedStyle(element).fontSize) : 0;
    }),
  );
  expect(Math.min(...sizes)).toBeGreaterThanOrEqual(16);
});
