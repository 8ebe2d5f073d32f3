import { box, typeInto } from './support/controls.ts';
import { NO_SCENE, open, withoutScene } from './support/page.ts';
import { expect, test } from './support/test.ts';

test.use({ provoked: NO_SCENE });

test('one voice: the value first, the consequence second, after a pause', async ({ page }) => {
  await withoutScene(page);
  await open(page, '#/explore?shape=cylinder&C=0,0,0&r=1.4&E=4,1,1.5&d=-1,0,0&method=exact');
  const voice = page.locator('.announcer');
  await expect(voice).toHaveCount(1);
  await typeInto(page, 'r', '1.45');
  await typeInto(page, 'r', '1.5');
  await expect(voice).toHaveText('r 1.5. Now tangent: one double root, the ray touches, t₁ 4.');
  await box(page, 'r').press('ArrowUp');
  await expect(voice).toContainText('r 1.55. Now two points');
});

test('the scene is described in words that are true', async ({ page }) => {
  await open(page, '#/explore?shape=cylinder&C=0,0,0&r=2.5&E=4,1,1.5&d=-1,0,0&method=exact');
  await page.locator('canvas').waitFor();
  const words = page.locator('.scene-description').first();
  await expect(words).toContainText('two points: the ray enters, then leaves');
  await expect(words).toContainText('t₁ = 2, first hit, enters, at (2, 1, 1.5)');
});
