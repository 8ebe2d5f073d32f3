import type { Page } from '@playwright/test';
import { expectInLink, press, slider, typeInto } from './support/controls.ts';
import {
  hashOf,
  linkWritten,
  NO_SCENE,
  open,
  quantities,
  SCENE_CHUNK,
  settle,
  withoutScene,
} from './support/page.ts';
import { frames, framesAsked } from './support/pending.ts';
import { drawn, middleOf, openScene, picture, still } from './support/scene.ts';
import { test as alone, expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

test.use({ viewport: { width: 940, height: 700 }, ink: true });

const START = '#/explore?shape=cone&method=exact';

async function viewInLink(page: Page): Promise<number[]> {
  await linkWritten(page);
  const view = new URLSearchParams((await hashOf(page)).split('?')[1]).get('view') ?? '';
  return view.split(',').map(Number);
}

alone('formulas stand on the page before the picture has been loaded', async ({ page }) => {
  let release = (): void => {};
  const gate = new Promise<void>((open) => {
    release = open;
  });
  await page.route(SCENE_CHUNK, async (route) => {
    await gate;
    await route.continue();
  });
  await page.goto(`./${START}`);
  await expect(page.locator('[data-quantity="A"]')).toHaveAttribute('data-value', /^0\.72/);
  await expect(page.locator('.step[data-step="A"] math').first()).toBeVisible();
  await expect(page.locator('.graph-svg')).toBeVisible();
  await expect(page.locator('canvas')).toHaveCount(0);
  release();
  await expect(page.locator('canvas')).toBeVisible();
});

test.describe('without the picture', () => {
  test.use({ provoked: NO_SCENE });
  alone('numbers and formulas work, and a sentence says what is missing', async ({ page }) => {
    await withoutScene(page);
    await open(page, START);
    await expect(page.locator('.view-waiting')).toContainText('not be loaded');
    await typeInto(page, 'E.x', '4');
    // The graph, which has the bead, comes after the first frame.
    await page.locator('.graph-bead').waitFor();
    expect(await quantities(page)).toMatchObject({ 'E.x': '4', 'bead.t': /./ });
    await press(page, page.locator('.graph-bead'), 'ArrowRight');
    await expectInLink(page, { E: '4,1,1' });
  });
});

test('the five views', async ({ page }) => {
  await openScene(page, START);
  const seen = new Set([(await picture(page)).toString('base64')]);
  for (const [title, id] of [
    ['top', 'top'],
    ['front', 'front'],
    ['side', 'side'],
    ['along ray', 'ray'],
  ]) {
    const button = page.locator('.scene-views button', { hasText: title ?? '' });
    await button.dispatchEvent('click');
    await expect(button).toHaveAttribute('aria-pressed', 'true');
    await expectInLink(page, { view: id ?? '' });
    seen.add((await picture(page)).toString('base64'));
  }
  await page.locator('.scene-views button', { hasText: 'iso' }).dispatchEvent('click');
  await expectInLink(page, { view: null });
  seen.add((await picture(page)).toString('base64'));
  expect(seen.size, 'five different pictures, and iso looks as it did at first').toBe(5);
});

test('the scene is turned by mouse, wheel and keys', async ({ page }) => {
  await openScene(page, START);
  const [x, y] = await middleOf(page, '.scene-root');
  await page.mouse.move(x, y + 60);
  await page.mouse.down();
  await page.mouse.move(x + 50, y + 80, { steps: 5 });
  await page.mouse.up();
  const [azimuth = 0, elevation = 0, zoom = 0] = await viewInLink(page);
  expect([azimuth, elevation, zoom]).toEqual([16 - 20, 14 + 8, 1]);
  await page.mouse.wheel(0, -400);
  const zoomed = await viewInLink(page);
  expect(zoomed[2]).toBeGreaterThan(1.2);
  await page.locator('.scene-root').focus();
  await page.keyboard.press('ArrowRight');
  await settle(page);
  await page.keyboard.press('Shift+ArrowUp');
  expect(await viewInLink(page)).toEqual([azimuth + 5, elevation + 1, zoomed[2]]);
  await page.keyboard.press('-');
  expect((await viewInLink(page))[2]).toBeLessThan(zoomed[2] ?? 0);
  await page.keyboard.press('0');
  await expectInLink(page, { view: null });
  expect(await quantities(page), 'the ray is left alone').toMatchObject({
    'E.x': '3',
    'd.x': '-0.8',
  });
});

test('nothing is drawn while nothing changes', async ({ page }) => {
  await openScene(page, START);
  const idle = async (): Promise<number> => {
    const before = await still(page);
    await linkWritten(page);
    const asked = await framesAsked(page);
    await frames(page, 60);
    expect(await framesAsked(page)).toBe(asked);
    expect(await drawn(page)).toBe(before);
    return before;
  };
  const first = await idle();
  await slider(page, 'E.x').press('ArrowRight');
  await page.locator('.scene-views button', { hasText: 'top' }).dispatchEvent('click');
  expect(await idle(), 'a change is drawn').toBeGreaterThan(first);
});

test('the picture follows the ray and the shape', async ({ page }) => {
  await openScene(page, START);
  const first = await picture(page);
  expect((await picture(page)).equals(first), 'the same state gives the same picture').toBe(true);
  await typeInto(page, 'E.y', '2');
  const moved = await picture(page);
  expect(moved.equals(first)).toBe(false);
  await typeInto(page, 'c', '1');
  expect((await picture(page)).equals(moved)).toBe(false);
});

test('the page says when a hit or E lies outside the drawn part', async ({ page }) => {
  await openScene(page, START);
  const notes = page.locator('.scene-notes');
  await expect(notes).toBeEmpty();
  await open(page, '#/explore?shape=plane&N=0,1,0&P=0,0,0&E=0,1,0&d=1,-0.0001,0&method=exact');
  await expect(notes).toContainText(/P₁ .*lies outside the drawn part/);
  await open(page, '#/explore?shape=cylinder&E=1e6,0,0&d=-1,0,0&method=exact');
  await expect(notes).toContainText(/E .*lies outside the drawn part/);
  await open(page, START);
  await expect(notes).toBeEmpty();
});
