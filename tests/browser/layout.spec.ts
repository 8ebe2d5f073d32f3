import { SHAPES } from '../../src/math/index.ts';
import { box, press, slider } from './support/controls.ts';
import { collisions, cutOff, extent } from './support/layout.ts';
import { open, quantities, settle } from './support/page.ts';
import { expect, test } from './support/test.ts';

const THIRD = '1/3,2/3,-1/7';
const LONG = `E=${THIRD}&d=-0.123456789,0.987654321,-1/3`;
const HUGE = 'E=-1.23456789e-7,9.87654321e8,-1.5e-9&d=-1.11111e-5,-2.22222e6,3.33333e-6';

/** For every shape: its first state, long numbers, and numbers far from 1. */
const STATES = SHAPES.flatMap(({ kind }) =>
  ['', LONG, HUGE].map((ray) => `#/explore?shape=${kind}&method=exact${ray && `&${ray}`}`),
);

test.describe('1280 × 720', () => {
  test.use({ viewport: { width: 1280, height: 720 } });

  test('everything is on one screen, no text lies on another one or is cut off', async ({
    page,
  }) => {
    for (const state of STATES) {
      await open(page, state);
      expect.soft(await extent(page), state).toEqual({ width: 1280, height: 720 });
      const below = await page.evaluate(() =>
        [...document.querySelectorAll('.panel-area :is(.value, .number, .verdict, .chip)')]
          .filter((element) => element.getBoundingClientRect().bottom > innerHeight)
          .map((element) => element.textContent),
      );
      expect.soft(below, state).toEqual([]);
      expect.soft(await collisions(page), state).toEqual([]);
      expect.soft(await cutOff(page), state).toEqual([]);
    }
  });

  test('rows stay where they are while a slider moves', async ({ page }) => {
    for (const { kind } of SHAPES) {
      await open(page, `#/explore?shape=${kind}&method=exact`);
      const verdict = (await quantities(page)).class;
      const rows = () =>
        page.evaluate(() =>
          [...document.querySelectorAll('.step, .param, .verdict, .hit, .condition, .group')].map(
            (row) => {
              const { x, y, width, height } = row.getBoundingClientRect();
              return [row.classList[0], x, y, width, height].join(' ');
            },
          ),
        );
      const first = await rows();
      for (let i = 0; i < 20; i++) {
        await press(page, slider(page, 'E.z'), i < 10 ? 'Shift+ArrowUp' : 'Shift+ArrowDown');
        if ((await quantities(page)).class !== verdict) break;
        expect(await rows(), `${kind}, step ${i}`).toEqual(first);
      }
    }
  });

  test('the scene has more than half of the width', async ({ page }) => {
    await open(page, '#/explore');
    const scene = await page.locator('.scene-area').boundingBox();
    expect(scene?.width).toBeGreaterThanOrEqual(0.55 * 1280);
  });
});

test.describe('390 × 844', () => {
  test.use({ viewport: { width: 390, height: 844 } });

  test('nothing is wider than the screen, and no text lies on another one', async ({ page }) => {
    for (const state of STATES) {
      await open(page, state);
      expect.soft((await extent(page)).width, state).toBe(390);
      expect.soft(await collisions(page), state).toEqual([]);
    }
  });

  test('the parameters stay at the bottom, and a slider there moves the ray', async ({ page }) => {
    await open(page, '#/explore?shape=cone&method=exact');
    const dock = page.locator('.compact-controls');
    for (const share of [0, 0.5, 1]) {
      await page.evaluate((s) => scrollTo(0, s * document.body.scrollHeight), share);
      await settle(page);
      await expect(dock).toBeInViewport();
      const at = await dock.boundingBox();
      expect(Math.abs((at?.y ?? 0) + (at?.height ?? 0) - 844)).toBeLessThan(1);
    }
    await dock.locator('.tab-param[data-symbol="E"]').click();
    await press(page, slider(page, 'E.x'), 'ArrowRight');
    expect((await quantities(page))['E.x']).toBe('3.1');
    await box(page, 'E.y').fill('abc');
    await box(page, 'E.y').press('Enter');
    await expect(page.getByRole('alert')).toBeInViewport({ ratio: 1 });
    for (const target of await dock.locator('button, input').all()) {
      expect((await target.boundingBox())?.height).toBeGreaterThanOrEqual(36);
    }
  });
});

const SCREENS = [
  { width: 1366, height: 768 },
  { width: 1920, height: 1080 },
  { width: 1024, height: 768 },
  { width: 820, height: 1180 },
] as const;

test('nothing is wider than a screen between', async ({ page }) => {
  for (const screen of SCREENS) {
    await page.setViewportSize(screen);
    for (const { kind } of SHAPES) {
      const name = `${screen.width} × ${screen.height}, ${kind}`;
      await open(page, `#/explore?shape=${kind}&method=exact&${LONG}`);
      const { width, height } = await extent(page);
      expect.soft(width, name).toBe(screen.width);
      if (screen.width > 1280) expect.soft(height, name).toBe(screen.height);
      expect.soft(await collisions(page), name).toEqual([]);
    }
  }
});
