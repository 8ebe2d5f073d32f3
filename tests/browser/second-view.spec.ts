import { expectSaid, open, quantities, settle } from './support/page.ts';
import { framesDone } from './support/pending.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

const TANGENT = '#/explore?shape=cylinder&C=0,1,0&r=1.5&E=4,1,1.5&d=-1,0,0';

test('a second view shows the same from above, and its handles move the ray', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 720 });
  await open(page, TANGENT);
  const second = page.locator('.second-view');
  await expect(second).toHaveCount(0);
  await page.keyboard.press('v');
  const E = second.locator('[data-handle="E"]').first();
  await E.waitFor();
  await framesDone(page);
  const [left, right] = await Promise.all([
    page.locator('.scene-host').first().boundingBox(),
    second.boundingBox(),
  ]);
  expect(Math.abs((left?.x ?? 0) + (left?.width ?? 0) - (right?.x ?? 0))).toBeLessThan(1);
  await expect(second.locator('.scene-views')).toBeHidden();
  await E.focus();
  await page.keyboard.press('ArrowLeft');
  await settle(page);
  expect((await quantities(page))['E.x']).not.toBe('4');
  const button = page.getByRole('button', { name: 'two views' });
  await expect(button).toHaveAttribute('aria-pressed', 'true');
  await button.click();
  await expect(second).toHaveCount(0);
});

test('on a phone there is none, and that is said', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, TANGENT);
  await expect(page.getByRole('button', { name: 'two views' })).toBeHidden();
  await page.keyboard.press('v');
  await expectSaid(page, /^a second view needs a window of 900 pixels or more/);
  await expect(page.locator('.second-view')).toHaveCount(0);
});
