import { SHAPES } from '../../src/math/index.ts';
import { byTurns } from '../unit/many.ts';
import { violationsInThemes } from './support/axe.ts';
import { box, press, slider } from './support/controls.ts';
import { collisions, cutOff, extent } from './support/layout.ts';
import { open, problems, quantities, settle } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

const THIRD = '1/3,2/3,-1/7';
const LONG = `E=${THIRD}&d=-0.123456789,0.987654321,-1/3`;
const HUGE = 'E=-1.23456789e-7,9.87654321e8,-1.5e-9&d=-1.11111e-5,-2.22222e6,3.33333e-6';

/** For every shape: its first state, long numbers, and numbers far from 1; by turns one of them. */
const states = (turn: number): string[] =>
  SHAPES.flatMap(({ kind }, i) =>
    byTurns(['', LONG, HUGE], i + turn, 3).map(
      (ray) => `#/explore?shape=${kind}&method=exact${ray && `&${ray}`}`,
    ),
  );

test.describe('1280 × 720', () => {
  test.use({ viewport: { width: 1280, height: 720 } });

  test('everything is on one screen, no text lies on another one or is cut off', async ({
    page,
  }) => {
    for (const state of states(0)) {
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
    for (const { kind } of byTurns(SHAPES)) {
      await open(page, `#/explore?shape=${kind}&method=exact`);
      const moved = await page.evaluate(async () => {
        const rows = () =>
          [...document.querySelectorAll('.step, .param, .verdict, .hit, .condition, .group')].map(
            (row) => {
              const { x, y, width, height } = row.getBoundingClientRect();
              return [row.classList[0], x, y, width, height].join(' ');
            },
          );
        const shown = (name: string) =>
          document.querySelector(`[data-quantity="${name}"]`)?.getAttribute('data-value');
        const [first, verdict, z] = [rows(), shown('class'), shown('E.z')];
        const slider = document.querySelector('input[type="range"][data-symbol="E.z"]');
        for (let i = 0; i < 20 && shown('class') === verdict; i++) {
          const key = i < 10 ? 'ArrowUp' : 'ArrowDown';
          const init = { key, shiftKey: true, bubbles: true, cancelable: true };
          slider?.dispatchEvent(new KeyboardEvent('keydown', init));
          for (const _ of [1, 2]) await new Promise((drawn) => requestAnimationFrame(drawn));
          if (i === 0 && shown('E.z') === z) return ['the slider does not move'];
          const now = rows();
          const changed = now.filter((row, k) => row !== first[k]);
          if (shown('class') === verdict && (changed.length > 0 || now.length !== first.length))
            return [`step ${i}`, ...changed];
        }
        return [];
      });
      expect(moved, kind).toEqual([]);
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
    for (const state of states(1)) {
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
    await expect(problems(page)).toBeInViewport({ ratio: 1 });
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

/** From a small phone on; low ones are a phone on its side, and pages at 200 %. */
const WINDOWS = [
  ...[320, 360, 390, 480, 601].map((width) => ({ width, height: 780 })),
  ...[512, 640, 844].map((width) => ({ width, height: 384 })),
  ...[900, 1024].map((width) => ({ width, height: 768 })),
] as const;
/** Those that large type is tried in. */
const TIGHT = new Set([320, 512, 900]);
/** Those that a page may be laid out otherwise in. */
const DISTINCT = new Set([320, 390, 601, 512, 844, 900]);

/** A link of each page, and of steps with each other page. */
const EVERY_PAGE = [
  '#/explore?shape=hyperboloid',
  '#/lesson',
  '#/lesson/ray?step=5',
  '#/picture?size=64x36',
  '#/check?seed=41',
  '#/lesson/ray?step=6',
  '#/accuracy?shape=cone',
];

test('no page and no header is wider than a window, in any theme', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  for (const [n, link] of EVERY_PAGE.entries()) {
    await open(page, link);
    // By now its code is there: a heading, a table or the scene.
    await page.locator('main :is(canvas, table, h2)').filter({ visible: true }).first().waitFor();
    for (const theme of ['light', 'projector']) {
      const widths = theme === 'light' ? DISTINCT : TIGHT;
      const all = WINDOWS.filter(({ width }) => widths.has(width));
      for (const window of byTurns(all, n)) {
        await page.setViewportSize(window);
        const wide = await page.evaluate(async (name) => {
          document.documentElement.dataset.theme = name;
          // What is measured for the new room is drawn a frame later.
          for (const _ of [1, 2, 3, 4]) await new Promise((drawn) => requestAnimationFrame(drawn));
          const out = [...document.querySelectorAll('header *')].filter((element) => {
            const { left, right, width } = element.getBoundingClientRect();
            return width > 1 && (left < -0.5 || right > innerWidth + 0.5);
          });
          const names = out.map((element) => element.getAttribute('class') ?? element.tagName);
          const { scrollWidth } = document.documentElement;
          return scrollWidth > innerWidth ? [...names, `${scrollWidth} px`] : names;
        }, theme);
        const at = `${link}, ${theme}, ${window.width} × ${window.height}`;
        expect.soft(wide, at).toEqual([]);
      }
    }
    await page.setViewportSize({ width: 1000, height: 800 });
  }
  await page.evaluate(() => {
    document.documentElement.dataset.theme = 'light';
  });
});

test('on a low window scene, parameter and caption are in view at once', async ({ page }) => {
  for (const window of WINDOWS.filter(({ height }) => height < 500)) {
    await page.setViewportSize(window);
    await open(page, '#/explore?shape=cylinder&C=0,1,0&r=1.5&E=4,1,1.5&d=-1,0,0');
    const name = `${window.width} × ${window.height}`;
    for (const share of [0, 1]) {
      await page.evaluate((s) => scrollTo(0, s * document.body.scrollHeight), share);
      await settle(page);
      const scene = await page.locator('.scene-area').boundingBox();
      const dock = await page.locator('.compact-controls').boundingBox();
      if (!scene || !dock) throw new Error('not shown');
      expect.soft(scene.y, name).toBeGreaterThanOrEqual(-1);
      expect.soft(scene.y + scene.height, name).toBeLessThanOrEqual(window.height + 1);
      expect.soft(dock.y + dock.height, name).toBeLessThanOrEqual(window.height + 1);
      expect.soft(dock.x, name).toBeGreaterThanOrEqual(scene.x + scene.width - 1);
      if (share === 0) await expect.soft(page.locator('.asks')).toBeInViewport();
    }
  }
  expect(await violationsInThemes(page)).toEqual([]);
});

test('nothing is wider than a screen between', async ({ page }) => {
  for (const [n, screen] of SCREENS.entries()) {
    await page.setViewportSize(screen);
    for (const { kind } of byTurns(SHAPES, n)) {
      const name = `${screen.width} × ${screen.height}, ${kind}`;
      await open(page, `#/explore?shape=${kind}&method=exact&${LONG}`);
      const { width, height } = await extent(page);
      expect.soft(width, name).toBe(screen.width);
      if (screen.width > 1280) expect.soft(height, name).toBe(screen.height);
      expect.soft(await collisions(page), name).toEqual([]);
    }
  }
});
