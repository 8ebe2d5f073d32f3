import { open } from './support/page.ts';
import { expect, test } from './support/test.ts';

test('the theme follows the system until one is chosen, and the choice is kept', async ({
  page,
}) => {
  await page.emulateMedia({ colorScheme: 'dark' });
  await open(page, '#/explore');
  const root = page.locator('html');
  const background = () => root.evaluate((html) => getComputedStyle(html).backgroundColor);
  await expect(root).toHaveAttribute('data-theme', 'dark');
  const dark = await background();
  await page.emulateMedia({ colorScheme: 'light' });
  await expect(root).toHaveAttribute('data-theme', 'light');
  expect(await background()).not.toBe(dark);
  const button = page.getByRole('button', { name: /^Theme/ });
  for (const theme of ['light', 'dark']) {
    await button.click();
    await expect(button).toHaveAccessibleName(`Theme: ${theme}`);
    await expect(root).toHaveAttribute('data-theme', theme);
  }
  await page.reload();
  await expect(root).toHaveAttribute('data-theme', 'dark');
  await button.click();
  await expect(button).toHaveAccessibleName('Theme: projector');
  await expect(root).toHaveAttribute('data-theme', 'projector');
  await button.click();
  await expect(button).toHaveAccessibleName('Theme: system');
  await expect(root).toHaveAttribute('data-theme', 'light');
});

test('a device that keeps nothing is no obstacle', async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(globalThis, 'localStorage', {
      get() {
        throw new DOMException('denied', 'SecurityError');
      },
    });
  });
  await open(page, '#/explore');
  const button = page.getByRole('button', { name: /^Theme/ });
  await button.click();
  await button.click();
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark');
});
