import type { Page } from '@playwright/test';
import { open, settle } from './support/page.ts';
import { expect, test } from './support/test.ts';

interface Stop {
  readonly place: string;
  readonly name: string;
  readonly top: number;
  readonly visible: boolean;
}

/** Presses Tab until the focus leaves the page; where it stood, and whether that could be seen. */
async function tabThrough(page: Page): Promise<Stop[]> {
  const stops: Stop[] = [];
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  for (let i = 0; i < 150; i++) {
    await page.keyboard.press('Tab');
    const stop = await page.evaluate(() => {
      const at = document.activeElement;
      if (!at || at === document.body) return null;
      const areas = [
        'header',
        '.picker-area',
        '.scene-area',
        '.graph-area',
        '.controls',
        '.algebra',
      ];
      const outlined = [at, ...at.querySelectorAll('.graph-focus, .scene-focus')].some(
        (element) => {
          const { outlineStyle, outlineWidth, stroke, opacity, visibility } =
            getComputedStyle(element);
          const ring =
            element.matches('.graph-focus, .scene-focus') && stroke !== 'none' && opacity !== '0';
          const outline = outlineStyle !== 'none' && Number.parseFloat(outlineWidth) >= 1;
          return (ring && visibility === 'visible') || outline;
        },
      );
      return {
        place: areas.find((area) => at.closest(area)) ?? '?',
        name: at.getAttribute('aria-label') ?? at.textContent?.trim() ?? '',
        top: at.getBoundingClientRect().top,
        visible: outlined,
      };
    });
    if (!stop) break;
    stops.push(stop);
  }
  return stops;
}

test.describe('the keyboard', () => {
  test.use({ viewport: { width: 1280, height: 720 } });

  test('goes through the page in the order in which it is read, and is always seen', async ({
    page,
  }) => {
    await open(page, '#/explore?shape=square&method=exact');
    await page.locator('canvas').waitFor();
    const stops = await tabThrough(page);
    expect(stops.length).toBeGreaterThan(40);
    expect.soft(stops.filter(({ visible }) => !visible).map(({ name }) => name)).toEqual([]);
    const places = stops.map(({ place }) => place).filter((place, i, all) => place !== all[i - 1]);
    expect(places).toEqual([
      'header',
      '.picker-area',
      '.scene-area',
      '.graph-area',
      '.controls',
      '.algebra',
    ]);
    const first = stops.findIndex(({ place }) => place === '.controls');
    expect(stops.slice(first).findIndex(({ name }) => name === 'E.x')).toBeLessThan(3);
  });

  test('reaches what the mouse reaches: shapes, views, theme, values', async ({ page }) => {
    await open(page, '#/explore?shape=cone&method=exact');
    await page.locator('canvas').waitFor();
    await page.getByRole('button', { name: 'circle' }).press('Enter');
    await settle(page);
    await expect(page.locator('[data-quantity="class"]')).toHaveAttribute('data-value', /one|none/);
    await page.locator('.scene-views button').nth(1).press('Space');
    await expect(page.locator('.scene-views button').nth(1)).toHaveAttribute(
      'aria-pressed',
      'true',
    );
    const value = page.locator('.value[data-quantity="N.d"]');
    await value.press('Enter');
    await expect(value.locator('.long')).toBeVisible();
  });
});
