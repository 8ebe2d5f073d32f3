import { box, expectInLink, pickShape, resetOf, slider, typeInto } from './support/controls.ts';
import { hashOf, NO_SCENE, open, quantities, settle, withoutScene } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

const START = '#/explore?shape=cone&method=exact';

test.use({ provoked: NO_SCENE });
test.beforeEach(async ({ page }) => {
  await withoutScene(page);
  await open(page, START);
});

// It comes first, where nothing is to be undone yet.
test('a whole drag of a slider is one step', async ({ page }) => {
  const at = await slider(page, 'c').boundingBox();
  if (!at) throw new Error('no slider');
  await page.mouse.move(at.x + at.width * 0.25, at.y + at.height / 2);
  await page.mouse.down();
  for (const share of [0.4, 0.5, 0.6, 0.8]) {
    await page.mouse.move(at.x + at.width * share, at.y + at.height / 2);
    await settle(page);
  }
  await page.mouse.up();
  await settle(page);
  expect(Number((await quantities(page)).c)).toBeGreaterThan(1);
  await page.keyboard.press('Control+z');
  await settle(page);
  expect((await quantities(page)).c).toBe('0.5');
  await expect(page.getByRole('button', { name: 'Undo' })).toHaveAttribute('aria-disabled', 'true');
});

test('undo and redo by keys and by buttons bring back every number', async ({ page }) => {
  const first = await quantities(page);
  await typeInto(page, 'c', '1/3');
  const second = await quantities(page);
  await pickShape(page, 'square');
  await page.keyboard.press('Control+z');
  await settle(page);
  expect(await quantities(page)).toEqual(second);
  await page.getByRole('button', { name: 'Undo' }).click();
  await settle(page);
  expect(await quantities(page)).toEqual(first);
  await page.keyboard.press('Control+Shift+z');
  await settle(page);
  expect(await quantities(page)).toEqual(second);
  await page.getByRole('button', { name: 'Redo' }).click();
  await expectInLink(page, { shape: 'square' });
});

test('a run of key presses on one control is one step; another control begins a new one', async ({
  page,
}) => {
  for (let i = 0; i < 5; i++) await slider(page, 'c').press('ArrowRight');
  for (let i = 0; i < 3; i++) await slider(page, 'E.y').press('ArrowRight');
  await settle(page);
  const { c } = await quantities(page);
  await page.keyboard.press('Control+z');
  await settle(page);
  expect(await quantities(page)).toMatchObject({ c, 'E.y': '1' });
  await page.keyboard.press('Control+z');
  await settle(page);
  expect((await quantities(page)).c).toBe('0.5');
});

test('in a box Ctrl+Z belongs to the text', async ({ page }) => {
  await typeInto(page, 'c', '1');
  await box(page, 'E.x').focus();
  await page.keyboard.type('77');
  await page.keyboard.press('Control+z');
  await settle(page);
  expect((await quantities(page)).c).toBe('1');
});

test('reset everything is one step; reset of one parameter is only that', async ({ page }) => {
  await typeInto(page, 'c', '2');
  await typeInto(page, 'E.x', '4');
  await slider(page, 'c').focus();
  await page.keyboard.press('Shift+R');
  await settle(page);
  expect(await quantities(page)).toMatchObject({ c: '1', 'E.x': '2.5' });
  await page.keyboard.press('Control+z');
  await settle(page);
  expect(await quantities(page)).toMatchObject({ c: '2', 'E.x': '4' });
  await resetOf(page, 'c').click();
  await settle(page);
  expect(await quantities(page)).toMatchObject({ c: '1', 'E.x': '4' });
});

test('the link follows undo, and the history of the browser does not grow', async ({ page }) => {
  const before = await page.evaluate(() => history.length);
  await typeInto(page, 'c', '2');
  await expectInLink(page, { c: '2' });
  await slider(page, 'c').focus();
  await page.keyboard.press('Control+z');
  await expectInLink(page, { c: null });
  expect(await hashOf(page)).toBe(START);
  expect(await page.evaluate(() => history.length)).toBe(before);
});
