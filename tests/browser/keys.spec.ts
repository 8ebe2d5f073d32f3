import type { Page } from '@playwright/test';
import { SHAPES } from '../../src/math/index.ts';
import { PAGES } from '../../src/state/state.ts';
import { violations } from './support/axe.ts';
import { box, expectInLink, slider } from './support/controls.ts';
import {
  hashOf,
  linkWritten,
  NO_SCENE,
  open,
  quantities,
  settle,
  withoutScene,
} from './support/page.ts';
import { frames } from './support/pending.ts';
import { test as alone, expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

test.use({ provoked: NO_SCENE });
test.beforeEach(async ({ page }) => {
  await withoutScene(page);
  await open(page, '#/explore');
});

test('a digit picks the shape', async ({ page }) => {
  for (const [i, { kind }] of SHAPES.entries()) {
    await page.keyboard.press(String(i + 1));
    await expectInLink(page, { shape: kind });
  }
});

test('digits and letters typed into a box are text', async ({ page }) => {
  await linkWritten(page);
  const before = await hashOf(page);
  await box(page, 'c').focus();
  await page.keyboard.type('1hgt');
  await settle(page);
  expect(await hashOf(page)).toBe(before);
  await expect(box(page, 'c')).toHaveValue('1hgt');
  await page.keyboard.press('Escape');
});

test('on a slider Page Down belongs to the slider, and Shift makes a step fine', async ({
  page,
}) => {
  await slider(page, 'c').press('PageDown');
  await slider(page, 'c').press('ArrowRight');
  await slider(page, 'c').press('Shift+ArrowRight');
  await settle(page);
  expect((await quantities(page)).c).toBe('0.322');
  await expect(page.locator('.example-name')).toContainText('choose one');
});

test('the help lists every key', async ({ page }) => {
  await page.keyboard.press('?');
  const help = page.getByRole('dialog', { name: 'Help' });
  await expect(help).toBeVisible();
  const keys = await help.locator('kbd').allInnerTexts();
  const some = ['1', '6', 'Page Down', 'h', 'g', 'p', 'b', 'Ctrl+Z', '?'];
  expect(keys).toEqual(expect.arrayContaining(some));
  await page.keyboard.press('Escape');
  await expect(help).toBeHidden();
});

test('on another page it lists what works there, and how that page is worked', async ({ page }) => {
  await page.getByRole('link', { name: 'Check' }).click();
  await expect(page.getByRole('heading', { name: /Question 1/ })).toBeVisible();
  await page.keyboard.press('?');
  const help = page.getByRole('dialog', { name: 'Help' });
  await expect(help).toContainText('Enter hands in an answer');
  const keys = await help.locator('kbd').allInnerTexts();
  expect(keys).toEqual(expect.arrayContaining(['Ctrl+Z', 's', '?']));
  expect(keys).not.toContain('g');
  await page.keyboard.press('Escape');
  await page.keyboard.press('6');
  await expect(page).toHaveURL(/shape=cone/);
});

alone('single keys can be switched off, and stay off', async ({ page }) => {
  await page.keyboard.press('?');
  await page.getByLabel(/single letters and digits/).uncheck();
  await page.keyboard.press('Escape');
  await expectInLink(page, { shape: 'cone' });
  await page.keyboard.press('1');
  await linkWritten(page);
  await expectInLink(page, { shape: 'cone' });
  await page.reload();
  await page.locator('[data-quantity="class"]').waitFor();
  await page.keyboard.press('2');
  await linkWritten(page);
  await expectInLink(page, { shape: 'cone' });
  await page.keyboard.press('PageDown');
  await expect(page.locator('.example-name')).toContainText('one point');
});

const beadAt = async (page: Page) => Number((await quantities(page))['bead.t']);

test('the bead plays, and stands still when it is stopped', async ({ page }) => {
  await page.keyboard.press('p');
  await expect.poll(() => beadAt(page)).toBeLessThan(1);
  await expect.poll(() => beadAt(page)).toBeGreaterThan(1);
  await page.keyboard.press('p');
  await settle(page);
  const rest = await beadAt(page);
  // While it plays it moves with every frame.
  await frames(page, 20);
  expect(await beadAt(page)).toBe(rest);
  // Nobody sees it under the black screen: there it stops too.
  await page.keyboard.press('p');
  await expect.poll(() => beadAt(page)).not.toBe(rest);
  await page.keyboard.press('b');
  await page.getByRole('dialog', { name: 'Black screen' }).waitFor();
  const under = await beadAt(page);
  await frames(page, 20);
  expect(await beadAt(page)).toBe(under);
  await page.keyboard.press('b');
});

test('with less motion the bead steps from root to root', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  const { t1 } = await quantities(page);
  const seen = new Set<string>();
  await page.keyboard.press('p');
  await settle(page);
  await expect
    .poll(async () => {
      seen.add((await quantities(page))['bead.t'] ?? '');
      return [...seen];
    })
    .toContain(t1);
  await page.keyboard.press('p');
  expect(seen.size).toBeLessThanOrEqual(3);
});

alone('a clicker turns pages after a click on slider, box, list and bead', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  const title = page.locator('.example-name strong');
  const thereAndBack = async (of: string): Promise<void> => {
    const before = await title.innerText();
    await page.keyboard.press('PageDown');
    await expect(page.locator('#example-answer'), of).not.toBeEmpty();
    await page.keyboard.press('PageUp');
    await expect(page.locator('#example-answer'), of).toBeEmpty();
    await expect(title, of).toHaveText(before);
  };
  await page.keyboard.press('PageDown');
  await page.keyboard.press('PageDown');
  await page.keyboard.press('PageDown');
  await settle(page);
  const bead = page.locator('.graph-bead');
  await bead.click();
  await expect(bead).toBeFocused();
  await thereAndBack('bead');
  // An arrow takes the control into the hand again, and with it the page keys.
  const t = await beadAt(page);
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('PageUp');
  await settle(page);
  expect(await beadAt(page)).toBeGreaterThan(t);
  await page.keyboard.press('PageDown');
  // A click that moves nothing: what is changed is no example any more, and asks nothing.
  await box(page, 'E.x').click();
  await thereAndBack('box');
  await slider(page, 'E.x').click({ position: { x: 2, y: 6 } });
  await settle(page);
  const { 'E.x': x } = await quantities(page);
  await expect(slider(page, 'E.x')).toBeFocused();
  const mine = await page.locator('.example-name').innerText();
  await page.keyboard.press('PageDown');
  await settle(page);
  await expect(page.locator('.example-name')).not.toHaveText(mine);
  expect((await quantities(page))['E.x']).not.toBe(x);
  // While predicting, back takes one line away; the list of questions has the focus.
  await page.keyboard.press('h');
  await page.locator('.predict select').click();
  await page.keyboard.press('Escape');
  const at = await title.innerText();
  const lines: string[][] = [];
  for (const key of ['PageDown', 'PageDown', 'PageUp']) {
    await page.keyboard.press(key);
    await settle(page);
    lines.push(Object.keys(await quantities(page)));
  }
  const [one = [], two = [], again] = lines;
  expect(two.length).toBeGreaterThan(one.length);
  expect(again).toEqual(one);
  await expect(title).toHaveText(at);
});

const ENDS = ['.', 'b', 'Escape', 'PageDown', 'PageUp', null] as const;

test('the screen is black on every page, until a key or a click that does nothing else', async ({
  page,
}) => {
  const black = page.getByRole('dialog', { name: 'Black screen' });
  for (const [n, { id, title }] of PAGES.entries()) {
    await page.locator('header').getByRole('link', { name: title, exact: true }).click();
    await page.locator(`header [aria-current="page"]`).getByText(title).waitFor();
    await linkWritten(page);
    const before = await hashOf(page);
    // Every end on Explore, and two of them, by turns, on each other page.
    const own = n === 0 ? ENDS : [0, 1].map((k) => ENDS[(2 * n + k) % ENDS.length] ?? null);
    for (const end of own) {
      await page.keyboard.press(end === '.' ? 'b' : '.');
      await expect(black, id).toBeVisible();
      await page.keyboard.press('3');
      await page.keyboard.press('t');
      if (end) await page.keyboard.press(end);
      else await page.mouse.click(300, 300);
      await expect(black, `${id}, ${end}`).toBeHidden();
    }
    await linkWritten(page);
    expect(await hashOf(page), id).toBe(before);
  }
  await expect(page.locator('.announcer')).toContainText('The page is shown again.');
  await page.keyboard.press('.');
  const window = page.viewportSize();
  expect(await black.boundingBox()).toEqual({ x: 0, y: 0, ...window });
  const colours = await black.evaluate((dialog) =>
    [dialog, dialog.firstElementChild ?? dialog].map((of) => getComputedStyle(of).backgroundColor),
  );
  expect(colours).toEqual(['rgb(0, 0, 0)', 'rgb(0, 0, 0)']);
  expect(await violations(page)).toEqual([]);
  await page.keyboard.press('.');
});

alone(
  'on a stage F5 reloads nothing, and by its link all comes back that a link has',
  async ({ page }) => {
    const prevented = (): Promise<boolean[]> =>
      page.evaluate(() =>
        [false, true].map((shiftKey) => {
          const init = { key: 'F5', shiftKey, bubbles: true, cancelable: true };
          return !document.body.dispatchEvent(new KeyboardEvent('keydown', init));
        }),
      );
    // A reload is the browser's own elsewhere.
    expect(await prevented()).toEqual([false, false]);
    await page.keyboard.press('h');
    await page.keyboard.press('PageDown');
    await page.keyboard.press('PageDown');
    await page.keyboard.press('f');
    await page.waitForFunction(() => document.fullscreenElement !== null);
    const lines = Object.keys(await quantities(page));
    expect(await prevented()).toEqual([true, true]);
    expect(Object.keys(await quantities(page))).toEqual(lines);
    await page.keyboard.press('f');
    await page.waitForFunction(() => document.fullscreenElement === null);
    // Without a stage: the lines are hidden again and none is told; a lesson stands where it was.
    await linkWritten(page);
    await page.reload();
    await page.locator('[data-quantity="E.x"]').first().waitFor();
    await expect(page.locator('[data-quantity="class"]')).toHaveCount(0);
    await page.goto('./#/lesson/ray?step=4&guess=1.8');
    await expect(page.locator('[data-lesson-step]')).toHaveAttribute('data-lesson-step', '4');
    await page.reload();
    await expect(page.locator('[data-lesson-step]')).toHaveAttribute('data-lesson-step', '4');
    await expect(page.locator('main').getByText('Your guess 1.8: right')).toBeVisible();
  },
);
