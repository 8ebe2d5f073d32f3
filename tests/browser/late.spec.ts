import type { Locator, Page } from '@playwright/test';
import { open, quantities, withoutScene } from './support/page.ts';
import { expect, test } from './support/test.ts';

/* What failed to load is fetched again when it is asked for again. */

test.use({ provoked: /Failed to load resource|Failed to fetch dynamically imported module/ });

/** Keeps files away while `is` is true. */
async function away(page: Page, files: RegExp): Promise<{ is: boolean }> {
  const kept = { is: true };
  await page.route(files, (route) => (kept.is ? route.abort() : route.continue()));
  return kept;
}

const tab = (page: Page, name: string) => page.getByRole('link', { name, exact: true });

test('a page, its style sheet, its picture and its graph', async ({ page }) => {
  const code = await away(page, /\/check-[^/]*\.js$/);
  const style = await away(page, /\/check-[^/]*\.css$/);
  const scene = await away(page, /\/scene-[^/]*\.js$/);
  const graph = await away(page, /\/charts-[^/]*\.js$/);
  await page.goto('./#/explore');
  const [ofScene, ofGraph] = ['.scene-host', '.graph-host'].map((host) =>
    page.locator(`${host} .view-waiting`),
  ) as [Locator, Locator];
  await expect(ofScene).toContainText('The picture could not be loaded');
  await expect(ofGraph).toContainText('The plot could not be loaded');
  expect(await quantities(page)).toMatchObject({ class: /./ });
  await tab(page, 'Check').click();
  const notice = page.locator('.page-waiting');
  await expect(notice).toContainText('could not be loaded');
  await expect(notice.getByRole('button', { name: 'Reload Graze' })).toBeVisible();
  // The same tab: its address does not change.
  code.is = false;
  await tab(page, 'Check').click();
  await expect(notice).toContainText('could not be loaded');
  style.is = false;
  await notice.getByRole('button', { name: 'Try again' }).click();
  await expect(page.getByRole('heading', { name: /Question 1/ })).toBeVisible();
  await expect(page.locator('.check')).toHaveCSS('display', 'grid');
  await tab(page, 'Explore').click();
  scene.is = false;
  await ofScene.getByRole('button', { name: 'Try again' }).click();
  await expect(page.locator('canvas')).toBeVisible();
  graph.is = false;
  await ofGraph.getByRole('button', { name: 'Try again' }).click();
  await expect(page.locator('.graph-bead')).toBeVisible();
});

test('what can be taken away', async ({ page }) => {
  await withoutScene(page);
  const exports = await away(page, /\/exports-[^/]*\.js$/);
  await open(page, '#/explore');
  await page.getByRole('button', { name: 'File and export' }).click();
  const dialog = page.locator('dialog[open]');
  await expect(dialog).toContainText('did not come');
  exports.is = false;
  await dialog.getByRole('button', { name: 'Try again' }).click();
  await expect(dialog.getByRole('button', { name: 'Copy the derivation as LaTeX' })).toBeVisible();
});

test('without its program the page has words', async ({ page }) => {
  await away(page, /\/first-[^/]*\.js$/);
  await page.goto('./');
  await expect(page.locator('#app')).toHaveText(/reload the page/);
  await expect(page.locator('.starting')).toBeVisible();
});
