import { violationsInThemes } from './support/axe.ts';
import { hashOf, open } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

/* A curved shape that is kept between two heights. */

const CAN = '#/explore?shape=cylinder&E=3,4,1&d=-1,-1,-0.3&C=0,1,0&r=1.5&method=certified';

test('is made finite, capped and moved, by keys alone, and the voice says each', async ({
  page,
}) => {
  await open(page, CAN);
  const spoken = page.locator('.announcer');
  const finite = page.getByLabel('finite');
  await finite.focus();
  await page.keyboard.press('Space');
  await expect.poll(() => hashOf(page)).toContain('between=-0.5,2.5');
  await expect(spoken).toContainText('Open ends.');
  await page.getByLabel('caps').focus();
  await page.keyboard.press('Space');
  await expect.poll(() => hashOf(page)).toContain('caps=1');
  await expect(page.locator('.verdict')).toContainText('capped: first hit t₁');
  await expect(page.locator('.cap-line')).toHaveCount(2);
  // The handle in the scene, a step by an arrow.
  const high = page.getByRole('slider', { name: 'high, upper end', exact: true }).first();
  const handle = page.locator('[data-handle=high][role=slider]');
  await handle.focus();
  await page.keyboard.press('ArrowDown');
  await expect.poll(() => hashOf(page)).toContain('between=-0.5,2.4');
  await expect(spoken).toContainText('high 2.4');
  await expect(high).toBeAttached();
  // The box beside it refuses what is below the other end, and says why.
  const box = page.locator('#box-high input');
  await box.fill('-3');
  await box.press('Enter');
  await expect(page.locator('#box-high')).toContainText('low must be below high');
  await box.fill('2');
  await box.press('Enter');
  await expect.poll(() => hashOf(page)).toContain('between=-0.5,2');
  await finite.focus();
  await page.keyboard.press('Space');
  await expect.poll(() => hashOf(page)).not.toContain('between');
  await expect(spoken).toContainText('The cylinder is whole.');
});

test('an end is dragged in the scene', async ({ page }) => {
  await open(page, `${CAN}&between=-0.5,2.5`);
  const handle = page.locator('[data-handle=high][role=slider]');
  const box = await handle.locator('.scene-hit').boundingBox();
  if (!box) throw new Error('a handle was expected');
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y + 30, { steps: 3 });
  await page.mouse.up();
  await expect
    .poll(async () => Number((await hashOf(page)).match(/between=-0.5,([\d.]+)/)?.[1]))
    .toBeLessThan(2.5);
});

test('axe finds nothing, and nothing is wider than the window, with ends', async ({ page }) => {
  await open(page, `${CAN}&between=-0.5,2&caps=1`);
  await expect(page.locator('.cap-line')).toHaveCount(2);
  expect(await violationsInThemes(page)).toEqual([]);
  for (const [width, height] of [
    [1024, 768],
    [390, 844],
    [844, 390],
  ] as const) {
    await page.setViewportSize({ width, height });
    if (width < 560) await page.getByRole('button', { name: 'ends' }).click();
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(wide, String(width)).toBeLessThanOrEqual(0);
    if (width < 560) await expect(page.getByLabel('caps')).toBeVisible();
  }
});
