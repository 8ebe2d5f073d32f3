import { problems } from './support/page.ts';
import { expect, test } from './support/test.ts';

test('storage that keeps nothing is said at the first word that is typed', async ({ page }) => {
  await page.addInitScript(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException('full', 'QuotaExceededError');
    };
  });
  await page.goto('./#/check?part=program');
  await page.getByRole('textbox', { name: /intersect/ }).fill('// mine');
  await expect(problems(page)).toContainText('this browser keeps nothing here');
  // Once it is dismissed, the next letters do not bring it back.
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await page.getByRole('textbox', { name: /intersect/ }).fill('// mine, and more');
  await expect(problems(page)).toHaveCount(0);
});

test('a file that is too large is said to be that', async ({ page }) => {
  await page.goto('./#/check');
  await page.getByRole('button', { name: 'File and export' }).click();
  const [chooser] = await Promise.all([
    page.waitForEvent('filechooser'),
    page.getByRole('button', { name: 'Open a file' }).click(),
  ]);
  const buffer = Buffer.alloc(2_000_001, ' ');
  await chooser.setFiles({ name: 'film.json', mimeType: 'application/json', buffer });
  await expect(problems(page)).toHaveText(/'film.json' was not opened: it is larger than 2 MB/);
});
