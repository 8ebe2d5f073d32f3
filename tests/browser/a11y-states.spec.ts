import { SHAPES } from '../../src/math/index.ts';
import { THEMES } from '../../src/ui/theme.ts';
import { violations } from './support/axe.ts';
import { open, settle } from './support/page.ts';
import { expect, test } from './support/test.ts';

test.use({ viewport: { width: 1280, height: 720 } });

for (const theme of THEMES) {
  test(`axe finds nothing in the dialogs and the states of the page, ${theme}`, async ({
    page,
  }) => {
    await page.addInitScript((t) => localStorage.setItem('graze.theme', t), theme);
    await open(page, '#/explore?shape=square');
    await page.locator('canvas').waitFor();
    for (const [key, name] of [
      ['x', 'Examples'],
      ['e', 'File and export'],
      ['?', 'Help'],
    ] as const) {
      await page.keyboard.press(key);
      const dialog = page.getByRole('dialog', { name });
      await expect(
        dialog.getByRole('button').nth(1).or(dialog.locator('kbd').first()),
      ).toBeVisible();
      expect.soft(await violations(page), name).toEqual([]);
      await page.keyboard.press('Escape');
      await expect(dialog).toBeHidden();
    }
    for (const key of ['PageDown', 'g', 'h']) {
      await page.keyboard.press(key);
      await settle(page);
      expect.soft(await violations(page), `after ${key}`).toEqual([]);
    }
  });
}

test('axe finds nothing for any shape on the projector', async ({ page }) => {
  await page.addInitScript(() => localStorage.setItem('graze.theme', 'projector'));
  await open(page, '#/explore');
  await page.locator('canvas').waitFor();
  for (let i = 1; i <= SHAPES.length; i++) {
    await page.keyboard.press(String(i));
    await settle(page);
    expect.soft(await violations(page), SHAPES[i - 1]?.kind).toEqual([]);
  }
});
