import type { Page } from '@playwright/test';
import {
  hashOf,
  linkWritten,
  NO_SCENE,
  open,
  problems,
  quantities,
  settle,
  withoutScene,
} from './support/page.ts';
import { expect, test } from './support/test.ts';

const TITLES = ['Explore', 'Accuracy', 'Picture', 'Check'];
const SMALL = 'scene=plain&size=64x36&method=certified';

test.use({ viewport: { width: 1280, height: 800 } });

test.describe('from page to page', () => {
  test.use({ provoked: NO_SCENE });
  test.beforeEach(({ page }) => withoutScene(page));

  test('tabs lead to each page and back, the ray and the method come along', async ({ page }) => {
    await open(page, '#/explore?shape=cylinder&E=6,1,2&d=-1,0.5,-0.5&C=1,0,-1&r=2&method=moment');
    for (const title of [...TITLES.slice(1), 'Explore']) {
      await page.getByRole('link', { name: title, exact: true }).click();
      await expect(page.getByRole('link', { name: title, exact: true })).toHaveAttribute(
        'aria-current',
        'page',
      );
      await linkWritten(page);
      const hash = await hashOf(page);
      expect(hash).toMatch(new RegExp(`^#/${title.toLowerCase()}\\?.*method=moment`));
      expect(hash.includes('E=6,1,2')).toBe(title !== 'Picture');
      await expect(page).toHaveTitle(title === 'Explore' ? /^Graze/ : `${title} · Graze`);
      // One heading, and every quantity of a page without rows of its own stands once.
      await expect(page.getByRole('heading', { level: 1 }).first()).toBeAttached();
    }
    expect(await quantities(page)).toMatchObject({ 'E.x': '6', r: '2' });
  });

  test('the browser’s Back leads from page to page, not from step to step', async ({ page }) => {
    await open(page, '#/explore?shape=cone&method=exact');
    await page.getByRole('link', { name: 'Check', exact: true }).click();
    await expect(page.getByRole('heading', { name: /Question 1/ })).toBeVisible();
    await linkWritten(page);
    await page.locator('input[name="seed"]').fill('7');
    await page.locator('input[name="seed"]').press('Enter');
    await expect(page).toHaveURL(/#\/check\?.*seed=7/);
    await page.goBack();
    await expect(page).toHaveURL(/#\/explore/);
    await expect(page.locator('[data-quantity="class"]')).toBeVisible();
    await page.goForward();
    await expect(page).toHaveURL(/#\/check\?.*seed=7/);
    await expect(page.getByRole('heading', { name: /Question 1/ })).toBeVisible();
  });

  test('what was typed on a page is there again', async ({ page }) => {
    await open(page, '#/explore');
    await page.getByRole('link', { name: 'Check', exact: true }).click();
    const answer = page.locator('form.answers input').first();
    await answer.fill('17/3');
    await page.getByRole('link', { name: 'Explore', exact: true }).click();
    await expect(page.locator('[data-quantity="class"]')).toBeVisible();
    await page.getByRole('link', { name: 'Check', exact: true }).click();
    await expect(answer).toHaveValue('17/3');
  });

  test('undo goes to the page where the step was taken', async ({ page }) => {
    await open(page, '#/explore');
    await page.getByRole('link', { name: 'Check', exact: true }).click();
    await page.locator('input[name="seed"]').fill('9');
    await page.locator('input[name="seed"]').press('Enter');
    await expect(page).toHaveURL(/seed=9/);
    await page.getByRole('link', { name: 'Explore', exact: true }).click();
    await expect(page.locator('[data-quantity="class"]')).toBeVisible();
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect(page).toHaveURL(/#\/check/);
    await expect(page).not.toHaveURL(/seed=9/);
  });

  test('what a link says wrongly of a page is quoted, and the rest is opened', async ({ page }) => {
    await page.goto('./#/picture?scene=plain&size=huge&method=certified&colour=red');
    await expect(problems(page)).toContainText("'huge'");
    await expect(problems(page)).toContainText("'colour'");
    await linkWritten(page);
    expect(await hashOf(page)).toBe('#/picture?method=certified&scene=plain');
  });
});

test('a saved state brings back every page’s settings', async ({ page }) => {
  await page.goto(`./#/picture?${SMALL}`);
  await expect(page.locator('[data-trace="finished"]')).toBeVisible();
  await page.getByRole('button', { name: 'File and export' }).click();
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save state' }).click(),
  ]);
  await page.goto('./#/check');
  await expect(page.getByRole('heading', { name: /Question 1/ })).toBeVisible();
  await page.getByRole('button', { name: 'File and export' }).click();
  const [chooser] = await Promise.all([
    page.waitForEvent('filechooser'),
    page.getByRole('button', { name: 'Open a file' }).click(),
  ]);
  await chooser.setFiles(await file.path());
  await expect(page).toHaveURL(/#\/picture\?.*size=64x36/);
});

/** Each page, with the parts that have stylesheets of their own. */
const STYLED = [
  '#/explore?shape=cone&derive=4',
  '#/lesson/ray?step=5',
  '#/accuracy?shape=cone',
  '#/picture?scene=shadows&size=64x36',
  '#/picture?scene=shadows&size=64x36&pixel=30,20',
  '#/check?seed=41',
  '#/check?part=class',
];

/** What stylesheets give each element of the page, by the way that leads to it. */
async function styles(page: Page): Promise<[way: string, style: string][]> {
  return page.evaluate(() => {
    const names = ['display', 'position', 'flexWrap', 'margin', 'padding', 'borderWidth'];
    const wayTo = (element: Element): string => {
      const own = `${element.tagName}.${element.getAttribute('class')}`;
      const { parentElement: parent } = element;
      return parent && element.tagName !== 'MAIN' ? `${wayTo(parent)} > ${own}` : own;
    };
    const all = [...document.querySelectorAll('main *')];
    const seen = all.filter(({ parentElement: parent }) => parent?.checkVisibility());
    return seen.map((element) => {
      const style = getComputedStyle(element) as unknown as Record<string, string>;
      return [wayTo(element), names.map((name) => `${name}: ${style[name]}`).join('; ')];
    });
  });
}

test('a page has the same styles wherever one has come from', async ({ page }) => {
  const show = async (link: string): Promise<[string, string][]> => {
    if (page.url() === 'about:blank') await page.goto(`./${link}`);
    else await open(page, link);
    if (link.startsWith('#/picture')) {
      await expect(page.locator('.picture')).toHaveAttribute('data-trace', 'finished');
      await page.getByRole('tab', { name: 'Scene' }).click();
    }
    await page.locator('main :is(h2, canvas, table)').filter({ visible: true }).first().waitFor();
    await settle(page);
    return styles(page);
  };
  const first = new Map<string, Map<string, Set<string>>>();
  for (const link of STYLED) {
    await page.goto('about:blank');
    const byWay = new Map<string, Set<string>>();
    for (const [way, style] of await show(link)) {
      byWay.set(way, (byWay.get(way) ?? new Set()).add(style));
    }
    first.set(link, byWay);
  }
  await page.goto('about:blank');
  for (const link of STYLED) await show(link);
  for (const link of STYLED) {
    const before = first.get(link);
    // What came late the first time is not compared.
    const differ = (await show(link)).filter(([way, style]) => {
      const known = before?.get(way);
      return known && !known.has(style);
    });
    expect.soft([...new Set(differ.map((one) => one.join(' ')))], link).toEqual([]);
  }
});
