import { GALLERY } from '../../src/state/gallery/index.ts';
import { NO_SCENE, open, quantities, readable, settle, withoutScene } from './support/page.ts';
import { expect, test } from './support/test.ts';

const LINK = '#/explore?shape=cylinder&C=0,1,0&r=1.5&E=4,2,1&d=-1,-0.25,-0.25&method=exact';
const RESULTS = ['A', 'B', 'C', 'D', 't1', 't2', 'P1.x', 'N2.z', 'class'];

test.describe('without the picture', () => {
  test.use({ provoked: NO_SCENE });
  test.beforeEach(async ({ page }) => {
    await withoutScene(page);
    await open(page, LINK);
  });

  test('hidden results are nowhere on the page; lines come back one by one', async ({ page }) => {
    const all = await quantities(page);
    expect(Object.keys(all)).toEqual(expect.arrayContaining(RESULTS));
    await page.keyboard.press('h');
    await settle(page);
    const hidden = await quantities(page);
    expect(RESULTS.filter((name) => name in hidden)).toEqual([]);
    expect(await readable(page)).not.toMatch(/enters|the ray leaves|two points/);
    for (const [n, name] of ['A', 'B', 'C', 'D'].entries()) {
      await page.keyboard.press('n');
      await settle(page);
      const shown = await quantities(page);
      expect(shown[name]).toBe(all[name]);
      expect(RESULTS.filter((result) => result in shown)).toHaveLength(n + 1);
    }
    for (let i = 0; i < 3; i++) await page.keyboard.press('n');
    await settle(page);
    expect(await quantities(page)).toEqual(all);
  });

  test("a clicker's one key reveals first and then goes on, still hidden", async ({ page }) => {
    await page.keyboard.press('h');
    for (let i = 0; i < 7; i++) await page.keyboard.press('PageDown');
    await settle(page);
    expect((await quantities(page)).class).toBe('two');
    await page.keyboard.press('PageDown');
    await settle(page);
    await expect(page.locator('.example-name')).toContainText(/\d+ of \d+/);
    expect(await quantities(page)).not.toHaveProperty('class');
    await page.keyboard.press('h');
    await settle(page);
    expect((await quantities(page)).class).toBe('one');
  });
});

test.describe('asked', () => {
  test.use({ provoked: NO_SCENE });
  test.beforeEach(({ page }) => withoutScene(page));

  test('what is hidden and asked survives a reload; the answer and its gap come after', async ({
    page,
  }) => {
    await page.goto(`./${LINK}&hide=1&ask=points`);
    await page.locator('.predict-asks').waitFor();
    await page.reload();
    await expect(page.locator('.predict-asks')).toContainText('How many points');
    await page.locator('[data-guess="1"]').click();
    await expect(page.locator('.predict')).toContainText('There are 2 points: you said 1 too few.');
    expect((await quantities(page)).class).toBe('two');
    expect(await readable(page)).toContain('two points');
  });

  test('no example tells its answer while it is hidden', async ({ page }) => {
    await page.goto(`./${LINK}&hide=1&ask=where`);
    await page.locator('.predict-asks').waitFor();
    for (const { id, link, title, asks, answer } of GALLERY) {
      await open(page, `${link}&hide=1&ask=where`);
      const words = await readable(page);
      expect(words, id).not.toContain(asks);
      expect(words, id).not.toContain(answer);
      expect(await page.locator('.example-name strong').innerText(), id).not.toContain(title);
      const shown = await quantities(page);
      expect(
        RESULTS.filter((name) => name in shown),
        id,
      ).toEqual([]);
    }
  });
});

test('the picture does not give away what is hidden', async ({ page }) => {
  await open(page, LINK);
  await page.locator('canvas').waitFor();
  const marks = page.locator('.scene-mark[data-mark="P1"], .scene-mark[data-mark="P2"]');
  await expect(marks.first()).toBeAttached();
  await page.keyboard.press('h');
  await expect(marks).toHaveCount(0);
  expect(await page.locator('.scene-area').innerText()).not.toMatch(/t₁|enters/);
});
