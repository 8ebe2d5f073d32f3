import type { Page } from '@playwright/test';
import { box } from './support/controls.ts';
import { open, settle } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

interface Stop {
  readonly place: string;
  readonly name: string;
  readonly top: number;
  readonly visible: boolean;
  /** Which of the page's groups it is an item of; null for none, and for sliders. */
  readonly group: number | null;
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
      const slides = at.matches('[role="slider"]');
      const group = slides ? null : at.parentElement?.closest('[role="group"]:not([tabindex])');
      return {
        group: group ? [...document.querySelectorAll('[role="group"]')].indexOf(group) : null,
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
    const groups = stops.map(({ group }) => group).filter((group) => group !== null);
    expect(groups.length).toBeGreaterThan(9);
    expect(groups, 'one stop a group').toEqual([...new Set(groups)]);
    expect(stops[0]?.name).toBe('Skip to the content');
    expect.soft(stops.filter(({ visible }) => !visible).map(({ name }) => name)).toEqual([]);
    const places = stops
      .slice(1)
      .map(({ place }) => place)
      .filter((place, i, all) => place !== all[i - 1]);
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

  test('arrows, Home and End reach everything in each group', async ({ page }) => {
    await open(page, '#/explore?shape=square&method=exact&E=3,1,2&d=-1,0.25,-0.5');
    await page.locator('canvas').waitFor();
    const groups = page.locator('[role="group"]:not([tabindex])').filter({ visible: true });
    let boxes = 0;
    for (const group of await groups.all()) {
      const items = await group.evaluate((element) =>
        [...element.querySelectorAll('a, button, input, select, summary')]
          .filter((item) => item.closest('[role="group"]') === element && item.checkVisibility())
          .filter((item) => !item.matches('[type="range"]'))
          .map((item) => item.getAttribute('aria-label') ?? item.textContent?.trim() ?? ''),
      );
      if (items.length < 2) continue;
      const name = (await group.getAttribute('aria-label')) ?? '';
      const focused = () =>
        page.evaluate(() => {
          const at = document.activeElement;
          return at?.getAttribute('aria-label') ?? at?.textContent?.trim() ?? '';
        });
      await page.keyboard.press('Tab');
      await group.locator('a, button, input, select, summary').first().focus();
      const found: string[] = [];
      for (const _ of items) {
        found.push(await focused());
        boxes += await page.evaluate(() => Number(document.activeElement?.matches('.number')));
        await page.keyboard.press('ArrowRight');
      }
      expect.soft(found, name).toEqual(items);
      expect.soft(await focused(), `${name}, round`).toBe(items[0]);
    }
    expect(boxes).toBeGreaterThan(5);
  });

  test('in a box arrows move the caret, and leave it at its ends', async ({ page }) => {
    await open(page, '#/explore?shape=cone&E=4.25,1,0.5&d=-1,0,0');
    const [x, y] = [box(page, 'E.x'), box(page, 'E.y')];
    await x.focus();
    // Once a digit was asked for, arrows are the text's.
    await page.keyboard.press('Home');
    for (const _ of '4.25') await page.keyboard.press('ArrowRight');
    await expect(x).toBeFocused();
    await page.keyboard.press('ArrowRight');
    await expect(y).toBeFocused();
    await page.keyboard.press('ArrowLeft');
    await expect(x).toBeFocused();
    // Up is a step, and Tab comes back to the box that was left.
    await page.keyboard.press('ArrowUp');
    await settle(page);
    await expect(x).toHaveValue('4.3');
    await page.keyboard.press('Tab');
    await expect(box(page, 'd.x')).toBeFocused();
    await page.keyboard.press('Shift+Tab');
    await expect(x).toBeFocused();
  });

  test('the focus is not lost with what it was on', async ({ page }) => {
    await open(page, '#/explore?shape=cone&E=4,1,0.5&d=-1,0,0&hide=1');
    await page.keyboard.press('Tab');
    await page.getByRole('button', { name: 'reveal next' }).focus();
    await page.keyboard.press('h');
    await expect(page.getByRole('button', { name: 'hide results' })).toBeFocused();
    await page.getByRole('button', { name: 'Skip to the content' }).press('Enter');
    await expect(page.getByRole('main')).toBeFocused();
    await page.keyboard.press('Tab');
    await expect(page.getByRole('button', { name: 'cone' })).toBeFocused();
  });
});
