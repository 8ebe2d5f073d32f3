import type { Page } from '@playwright/test';
import { NO_SCENE, open, settle, withoutScene } from './support/page.ts';
import { expect, test } from './support/test.ts';

const CONE = '#/explore?shape=cone&V=0,1,0&c=0.5&E=4,2,1&d=-1,-0.25,-0.25&method=exact';
const CIRCLE = '#/explore?shape=circle&N=1,1,0&C=0,1,0&r=1.5&E=3,2,0.5&d=-1,-0.25,0&method=exact';

/** By hand: C = 16 + 1 − 1²/4 and B = 2(−4 − 1/4 + 1/16); N·(E − C) = 3 + 1, N·d = −5/4. */
const ABC = [/^A > 0: .*outside/, /^B < 0: f falls at E/, /^C > 0: E is outside the cone/];
const FLAT = [/^N·d < 0: f falls at E/, /^N·\(E − P\) > 0: E is on the side that N points to/];

test.use({ provoked: NO_SCENE });

const texOf = (page: Page, step: number): Promise<string[]> =>
  page
    .locator(`[data-derivation-step="${step}"] [data-tex]`)
    .evaluateAll((lines) => lines.map((line) => line.getAttribute('data-tex') ?? ''));

/** How many steps there are, by the bar. */
const stops = (page: Page): Promise<number> => page.locator('.walk-stop').count();

/** Goes to the end by one key and back by the other; the lines of each step on the way. */
async function thereAndBack(page: Page, on: string, back: string): Promise<string[]> {
  const last = await stops(page);
  const steps = page.locator('[data-derivation-step]');
  const seen: string[] = [];
  for (let step = 1; step <= last; step++) {
    await expect(steps).toHaveCount(step);
    const tex = await texOf(page, step);
    expect(tex.length, `lines of step ${step}`).toBeGreaterThan(0);
    for (const line of tex) expect(line).toMatch(/\S (=|\\le) \S/);
    seen.push(tex.join('\n'));
    await page.keyboard.press(on);
  }
  await expect(steps).toHaveCount(last);
  for (let step = last - 1; step >= 1; step--) {
    await page.keyboard.press(back);
    await expect(steps).toHaveCount(step);
  }
  return seen;
}

test('the walk by keys and by a clicker: each step says something new', async ({ page }) => {
  await withoutScene(page);
  for (const link of [CONE, CIRCLE]) {
    await open(page, link);
    await page.locator('button.derive').click();
    await page.locator('.walk').waitFor();
    await page.keyboard.press('Home');
    const byKeys = await thereAndBack(page, 'ArrowRight', 'ArrowLeft');
    const byClicker = await thereAndBack(page, 'PageDown', 'PageUp');
    expect(byClicker).toEqual(byKeys);
    await page.locator('.walk-stop', { hasText: /^(A, B, C|N·d and)/ }).click();
    await expect(page.locator('.walk-sign')).toContainText(link === CONE ? ABC : FLAT);
    for (const [i, lines] of byKeys.entries()) expect(lines).not.toBe(byKeys[i - 1]);
    await page.keyboard.press('Escape');
    await expect(page.locator('.walk')).toBeHidden();
    await expect(page.locator('button.derive')).toBeFocused();
  }

  await open(page, `${CONE}&hide=1`);
  await page.keyboard.press('d');
  await page.locator('.walk').waitFor();
  await page.keyboard.press('Home');
  const last = await stops(page);
  for (let step = 1; step <= last; step++) {
    await expect(page.locator('[data-derivation-step]')).toHaveCount(step);
    await expect(page.locator('.walk-numbers, .walk-results')).toHaveCount(0);
    await page.keyboard.press('PageDown');
  }
  await page.keyboard.press('Escape');
  await settle(page);
});

test('on a narrow screen the present step comes clear of the bar', async ({ page }) => {
  await withoutScene(page);
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, CONE);
  await page.keyboard.press('d');
  await page.locator('.walk').waitFor();
  await page.keyboard.press('Home');
  for (let step = 1; step <= 5; step++) {
    await expect(page.locator('[data-derivation-step]')).toHaveCount(step);
    const bottom = await page.locator('.walk-step.present > :last-child').boundingBox();
    const bar = await page.locator('.walk-bar').boundingBox();
    const lowest = (bottom?.y ?? 0) + (bottom?.height ?? 0);
    expect(lowest, `step ${step}`).toBeLessThanOrEqual(bar?.y ?? 0);
    await page.keyboard.press('PageDown');
  }
});
