import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { GALLERY } from '../../src/state/gallery/index.ts';
import { ASKS } from '../../src/state/prediction-ask.ts';
import { PAGES } from '../../src/state/state.ts';
import { decode } from '../../src/state/url.ts';
import { display, shortest } from '../../src/text/format.ts';
import { share } from '../unit/many.ts';
import {
  linkWritten,
  NO_SCENE,
  open,
  quantities,
  readable,
  settle,
  withoutScene,
} from './support/page.ts';
import { expect, test as fresh, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

const LINK = '#/explore?shape=cylinder&C=0,1,0&r=1.5&E=4,2,1&d=-1,-0.25,-0.25&method=exact';
/**
 * Results of a link that are not given with it, in full and as they would be shown; `inFull`: only
 * so, for where something is measured, which may by chance be the same to three digits.
 */
function resultsOf(link: string, inFull = false): string[] {
  const { found, derivation, ray, shape, scene } = createDerive(() => exploreDetails)(decode(link));
  const given = new Set(JSON.stringify([ray, shape, scene.stage]).match(NUMBERS)?.map(Number));
  const results = [
    ...derivation.steps.flatMap(({ value }) => value ?? []),
    ...found.hits.flatMap(({ t, point, normal }) => [t, ...point, ...normal]),
  ].filter((x) => !given.has(x) && shortest(x).length > 6);
  const shown = (x: number) => (inFull ? [] : [display(x), display(x, 3)]);
  return [...new Set(results.flatMap((x) => [shortest(x), ...shown(x)]))];
}

/** Of these, what stands in a text as a number of its own. */
function numbersIn(text: string, results: readonly string[]): string[] {
  const numbers = new Set(text.replaceAll('−', '-').match(NUMBERS) ?? []);
  return results.filter((result) => numbers.has(result.replaceAll('−', '-')));
}

/** Results that stand somewhere in the page's elements. */
async function leaksOf(page: Page, link: string, inFull = false): Promise<string[]> {
  return numbersIn(await page.evaluate(() => document.body.outerHTML), resultsOf(link, inFull));
}
const NUMBERS = /-?\d+(?:\.\d+)?(?:e[+-]?\d+)?/g;

const RESULTS = ['A', 'B', 'C', 'D', 't1', 't2', 'P1.x', 'N2.z', 'class'];

test.describe('without the picture', () => {
  test.use({ provoked: NO_SCENE });
  test.beforeEach(async ({ page }) => {
    await withoutScene(page);
    await open(page, LINK);
  });

  test('hidden results are nowhere on the page; lines come back one by one', async ({ page }) => {
    // The graph's code comes after the page's own.
    await page.locator('[data-quantity="bead.t"]').waitFor();
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
      if (name !== 'B') continue;
      // A reload keeps what has been shown; whoever else opens the link sees nothing of it.
      await linkWritten(page);
      const link = page.url();
      const names = async () => Object.keys(await quantities(page)).filter((one) => one in shown);
      await page.reload();
      await expect.poll(names).toEqual(Object.keys(shown));
      await page.goto('about:blank');
      await page.goto(link);
      await page.locator('[data-quantity="E.x"]').first().waitFor();
      await settle(page);
      expect(await names()).not.toContain('A');
      await page.goBack();
      await page.goBack();
      await expect.poll(names).toEqual(Object.keys(shown));
    }
    for (let i = 0; i < 3; i++) await page.keyboard.press('n');
    await settle(page);
    expect(await quantities(page)).toEqual(all);
  });

  fresh("a clicker's one key reveals first and then goes on, still hidden", async ({ page }) => {
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
  // What Accuracy measures by itself is no result either.
  test.use({ provoked: NO_SCENE, idle: true });
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

  test('on small windows the whole question is in view, with its answers', async ({ page }) => {
    await open(page, LINK);
    for (const [width, height] of [
      [390, 844],
      [844, 390],
      [667, 375],
    ] as const) {
      await page.setViewportSize({ width, height });
      // A plane has the highest parameters.
      for (const shape of ['plane', 'cylinder']) {
        for (const ask of ASKS.filter((one) => shape !== 'plane' || one !== 'sign')) {
          await open(page, `#/explore?shape=${shape}&hide=1&ask=${ask}`);
          const asked = page.locator('.predict-asks, .predict [data-guess], .predict-t');
          await expect(page.locator('.predict-asks')).toBeVisible();
          const covered = await asked.evaluateAll((all) =>
            all.flatMap((one) => {
              const { left, right, top, bottom } = one.getBoundingClientRect();
              const inside = [
                [left + 2, top + 2],
                [right - 2, bottom - 2],
              ] as const;
              const isSeen = inside.every(([x, y]) => {
                const at = document.elementFromPoint(x, y);
                return at !== null && (one.contains(at) || at.contains(one));
              });
              return isSeen ? [] : [one.textContent];
            }),
          );
          expect(covered, `${shape}, ${ask}, ${width} × ${height}`).toEqual([]);
        }
      }
    }
  });

  test('no other page tells what is hidden, nor its files, also after a reload', async ({
    page,
  }) => {
    const own = LINK.slice(LINK.indexOf('?'));
    for (const { id, ray } of PAGES) {
      await page.goto(`./#/explore${own}&hide=1`);
      await page.locator('.predict-asks').waitFor();
      await page.goto(`./#/${id}`.replace(/explore$/, `explore${own}`));
      await page.locator('main > :not([hidden])').first().waitFor();
      for (const again of ray ? [false, true] : [false]) {
        await linkWritten(page);
        if (again) await page.reload();
        if (id === 'accuracy') {
          await expect(page.locator('.acc-ray')).toContainText('Results are hidden on Explore');
          await expect(page.locator('.ladder')).toHaveCount(0);
        }
        expect(await leaksOf(page, LINK, id === 'accuracy'), `${id}, ${again}`).toEqual([]);
        expect(await page.title()).not.toMatch(/\d|point|miss|tangent/);
      }
    }
    await page.goto(`./#/explore${own}&hide=1`);
    await page.locator('.predict-asks').waitFor();
    await page.getByRole('link', { name: 'Accuracy' }).click();
    await expect(page.locator('.acc-foot')).toContainText('CSV');
    for (const name of ['table as CSV', 'everything as JSON']) {
      const [file] = await Promise.all([
        page.waitForEvent('download'),
        page.getByRole('button', { name: `Save ${name}` }).click(),
      ]);
      const text = readFileSync(await file.path(), 'utf8');
      expect(text.length).toBeGreaterThan(200);
      expect(numbersIn(text, resultsOf(LINK, true))).toEqual([]);
    }
    await page.locator('[data-show-hidden]').click();
    await expect(page.locator('.ladder [data-method="exact"]')).toContainText(/two/);
    await page.getByRole('link', { name: 'Explore' }).click();
    await settle(page);
    expect((await quantities(page)).class).toBe('two');
  });

  test('no example tells its answer while it is hidden', async ({ page }) => {
    await page.goto(`./${LINK}&hide=1&ask=where`);
    await page.locator('.predict-asks').waitFor();
    for (const [i, { id, link, title, asks, answer }] of share(GALLERY).entries()) {
      await open(page, `${link}&hide=1&ask=${ASKS[i % ASKS.length]}`);
      expect(await leaksOf(page, link), id).toEqual([]);
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

test('the picture does not give away what is hidden; a mark is put on its ray', async ({
  page,
}) => {
  await open(page, LINK);
  await page.locator('canvas').waitFor();
  const marks = page.locator('.scene-mark[data-mark="P1"], .scene-mark[data-mark="P2"]');
  await expect(marks.first()).toBeAttached();
  await page.keyboard.press('h');
  await expect(marks).toHaveCount(0);
  expect(await page.locator('.scene-area').innerText()).not.toMatch(/t₁|enters/);

  await open(page, `${LINK}&hide=1&ask=where`);
  const handle = page.locator('.scene-area [data-handle="t"]');
  const put = async (): Promise<number> => {
    await settle(page);
    return Number(await handle.getAttribute('aria-valuenow'));
  };
  await expect(handle).toBeAttached();
  expect(await put()).toBe(1);
  const ray = await page.locator('.scene-mark[data-mark="d"]').boundingBox();
  const eye = await page.locator('.scene-mark[data-mark="E"]').boundingBox();
  const middle = (box: typeof ray) =>
    box ? { x: box.x + box.width / 2, y: box.y + box.height / 2 } : { x: 0, y: 0 };
  const [d, E] = [middle(ray), middle(eye)];
  await page.mouse.click(E.x + 2.2 * (d.x - E.x), E.y + 2.2 * (d.y - E.y));
  const clicked = await put();
  expect(clicked).toBeGreaterThan(1.5);
  await handle.focus();
  await page.keyboard.press('ArrowRight');
  expect(await put()).toBeGreaterThan(clicked);
  const slider = page.locator('.graph-bead');
  await slider.focus();
  await page.keyboard.press('Home');
  expect(await put()).toBeLessThan(0);
  await page.locator('.predict-t').fill('5.45');
  await page.locator('.predict-t').press('Enter');
  expect(await put()).toBe(5.45);
  await linkWritten(page);
  await page.reload();
  await expect(handle).toHaveAttribute('aria-valuenow', '5.45');
  await page.locator('[data-guess="mark"]').click();
  await expect(page.locator('.predict')).toContainText(/is 2\.91 beyond it: .* far root/);
  await expect(page.locator('.scene-bracket')).toBeAttached();
  await expect(page.locator('.graph-gap')).toContainText('Δt = 2.91, length 3.08');
});
