import type { Page } from '@playwright/test';
import { SHAPES } from '../../src/math/index.ts';
import { GALLERY } from '../../src/state/gallery/index.ts';
import { byTurns } from '../unit/many.ts';
import { collisions, cutOff, extent } from './support/layout.ts';
import { NO_SCENE, open, settle, withoutScene } from './support/page.ts';
import { expect, test } from './support/test.ts';

test.use({ provoked: NO_SCENE, viewport: { width: 1280, height: 720 } });
test.beforeEach(({ page }) => withoutScene(page));

/** What ends below the window, in words. */
const below = (page: Page): Promise<(string | null)[]> =>
  page.evaluate(() =>
    [
      ...document.querySelectorAll(
        '.panel-area :is(.value, .verdict, .chip), .example-question p, .graph-area',
      ),
    ]
      .filter((element) => element.getBoundingClientRect().bottom > innerHeight)
      .map((element) => element.textContent),
  );

test('on the projector all is on one screen of any size, no text on another one', async ({
  page,
}) => {
  await page.addInitScript(() => localStorage.setItem('graze.theme', 'projector'));
  await page.setViewportSize({ width: 1024, height: 768 });
  await open(page, '#/explore');
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'projector');
  const fits = async (name: string, width: number, height: number): Promise<void> => {
    expect.soft(await extent(page), name).toEqual({ width, height });
    expect.soft(await below(page), name).toEqual([]);
    expect.soft(await collisions(page), name).toEqual([]);
    expect.soft(await cutOff(page), name).toEqual([]);
  };
  for (const { id, link } of byTurns(GALLERY)) {
    await open(page, link);
    // The longest headline: with its answer.
    await page.keyboard.press('a');
    await settle(page);
    await expect.soft(page.locator('#example-answer'), id).not.toBeEmpty();
    await fits(id, 1024, 768);
  }
  const sizes = [
    [1280, 720],
    [1920, 1080],
    [3840, 2160],
  ] as const;
  for (const [n, [width, height]] of sizes.entries()) {
    await page.setViewportSize({ width, height });
    // By turns: all grow alike.
    for (const { kind } of SHAPES.filter((_, i) => process.env.LONG || i % sizes.length === n)) {
      await open(page, `#/explore?shape=${kind}`);
      await fits(`${kind} at ${width} × ${height}`, width, height);
    }
    const types = await page.evaluate(() =>
      ['.verdict', '.hit .value', '.result .value', '.tab-param', '.shape-choice'].map((what) => {
        const element = document.querySelector(what) as Element;
        return Number.parseFloat(getComputedStyle(element).fontSize) * element.currentCSSZoom;
      }),
    );
    // 16 px at 1024 × 768, and as much more as the window is larger.
    const least = 16 * Math.min(width / 1024, height / 768);
    expect(Math.min(...types)).toBeGreaterThanOrEqual(least);
  }
  // A plot of a page that is zoomed as a whole keeps its words within it.
  await page.getByRole('link', { name: 'Accuracy' }).click();
  await page.locator('.acc-hard .plot-svg text').first().waitFor();
  const outside = await page.evaluate(() => {
    const plot = document.querySelector('.acc-hard .plot-svg') as Element;
    const { top, bottom } = plot.getBoundingClientRect();
    return [...plot.querySelectorAll('text')]
      .filter((text) => {
        const box = text.getBoundingClientRect();
        // The axis has its title in the line above.
        return box.top < top - 2 * box.height || box.bottom > bottom + 1;
      })
      .map((text) => text.textContent);
  });
  expect(outside).toEqual([]);
});

test('in full screen the controls withdraw, and what is left fills it', async ({ page }) => {
  await page.addInitScript(() => localStorage.setItem('graze.theme', 'projector'));
  await open(page, GALLERY[0]?.link ?? '');
  await page.keyboard.press('f');
  await expect(page.locator('.header')).toBeHidden();
  await settle(page);
  for (const away of ['.picker-area', '.ray-tools', '.example-name', '.example-question button']) {
    await expect(page.locator(away).first()).toBeHidden();
  }
  for (const stays of [
    '.example-question .asks',
    '.verdict',
    '.compact-controls',
    '.explore > .graph-area',
  ]) {
    await expect(page.locator(stays)).toBeVisible();
  }
  const size = await page.evaluate(() => ({ width: innerWidth, height: innerHeight }));
  expect(await extent(page)).toEqual(size);
  await page.keyboard.press('f');
  await expect(page.locator('.header')).toBeVisible();
});
