import { open, quantities, settle } from './support/page.ts';
import { expect, test } from './support/test.ts';

test.use({ viewport: { width: 900, height: 660 }, provoked: /WebGL|THREE/ });

test('without WebGL the lines are drawn, the page says so, and all else works', async ({
  page,
}) => {
  await page.addInitScript(() => {
    const get = HTMLCanvasElement.prototype.getContext as (...all: unknown[]) => unknown;
    HTMLCanvasElement.prototype.getContext = function (this: unknown, ...all: unknown[]) {
      return String(all[0]).startsWith('webgl') ? null : get.apply(this, all);
    } as typeof HTMLCanvasElement.prototype.getContext;
  });
  await open(page, '#/explore');
  await expect(page.locator('.scene-area')).toContainText('no WebGL');
  expect(await page.locator('.scene-area svg path').count()).toBeGreaterThan(5);
  await page.keyboard.press('2');
  await settle(page);
  expect((await quantities(page)).class).toBe('two');
});

test('a lost context comes back', async ({ page }) => {
  await open(page, '#/explore');
  await page.locator('canvas').waitFor();
  const frames = () =>
    page.locator('[data-frames]').evaluate((e) => Number((e as HTMLElement).dataset.frames));
  await expect.poll(frames).toBeGreaterThan(0);
  await page.evaluate(() => {
    const context = document.querySelector('canvas')?.getContext('webgl2');
    const lose = context?.getExtension('WEBGL_lose_context');
    Object.assign(window, { lose });
    lose?.loseContext();
  });
  await expect(page.locator('.scene-area')).toContainText('no WebGL');
  await page.evaluate(() =>
    (window as unknown as { lose: WEBGL_lose_context }).lose.restoreContext(),
  );
  await expect(page.locator('.scene-area')).not.toContainText('no WebGL');
  const before = await frames();
  await page.keyboard.press('2');
  await expect.poll(frames).toBeGreaterThan(before);
});
