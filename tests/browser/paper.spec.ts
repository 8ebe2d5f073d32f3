import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { computed, lessonOf, stepShown } from './support/lesson.ts';
import { open } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });
test.use({ viewport: { width: 1280, height: 720 } });

/** Pages of the PDF that the browser makes. */
async function pages(page: Page, format: 'A4' | 'Letter'): Promise<number> {
  const pdf = await page.pdf({ format, printBackground: true });
  return pdf.toString('latin1').match(/\/Type\s*\/Page\b/g)?.length ?? 0;
}

/** Calls `look` with the paper as it lies in the printer. */
async function printed(page: Page, look: () => Promise<void>): Promise<void> {
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  await page.emulateMedia({ media: 'print' });
  await look();
  await page.emulateMedia({ media: null });
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  await expect(page.locator('.handout')).toHaveCount(0);
}

/** Until what prints has been loaded: it comes after the first frame. */
async function canPrint(page: Page): Promise<void> {
  await expect(async () => {
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    const found = await page.locator('.handout').count();
    await page.evaluate(() => dispatchEvent(new Event('afterprint')));
    expect(found).toBe(1);
  }).toPass();
}

test('Explore is printed on one page, light, as lines, with its caption, values and link', async ({
  page,
}) => {
  await page.addInitScript(() => localStorage.setItem('graze.theme', 'dark'));
  await open(page, '#/explore?shape=cone&method=certified');
  await canPrint(page);
  const onScreen = await page
    .locator('.panel-area [data-quantity="t1"]')
    .getAttribute('data-value');
  await printed(page, async () => {
    const paper = page.locator('.handout');
    await expect(paper.locator('[data-quantity="t1"]')).toHaveAttribute(
      'data-value',
      `${onScreen}`,
    );
    for (const shown of ['[data-quantity="N2.z"]', '.link-code', '.handout-graph', '.scene-E']) {
      await expect(paper.locator(shown).first()).toBeVisible();
    }
    expect(await paper.locator('.scene-paths path').count()).toBeGreaterThan(20);
    await expect(paper).toContainText('E = (3, 1, 1)');
    await expect(paper.locator('.handout-link')).toContainText('#/explore?shape=cone');
    const controls = await paper
      .locator('button, input, select')
      .evaluateAll((all) =>
        all
          .filter((one) => one.checkVisibility() && !one.matches('.value'))
          .map((one) => one.outerHTML),
      );
    expect(controls).toEqual([]);
    await expect(page.locator('#app')).toBeHidden();
    const dark = await page.evaluate(() => {
      const probe = document.querySelector('.handout') as HTMLElement;
      return [getComputedStyle(probe).color, getComputedStyle(probe).getPropertyValue('--bg')];
    });
    expect(dark).toEqual(['rgb(29, 28, 26)', '#fff']);
  });
  for (const format of ['A4', 'Letter'] as const) expect(await pages(page, format)).toBe(1);
});

test('what is hidden on the page is hidden on paper', async ({ page }) => {
  await open(page, '#/explore?shape=cone&method=certified&hide=1');
  await printed(page, async () => {
    const paper = page.locator('.handout');
    await expect(paper).toContainText('Hidden. Predict first');
    await expect(paper.locator('[data-quantity="t1"], [data-symbol~="t1"]')).toHaveCount(0);
  });
  await page.evaluate(() => document.documentElement.focus());
  await page.keyboard.press('h');
});

test('a lesson is printed whole, with the numbers of each step and its answers', async ({
  page,
}) => {
  const { title, steps } = lessonOf('ray');
  await page.goto('./#/lesson/ray?step=2');
  await stepShown(page, 2);
  // What other pages show is worked out first; then the browser is asked.
  await page.evaluate(() => {
    window.print = () => document.body.setAttribute('data-printed', '');
  });
  await page.getByRole('button', { name: 'Print the lesson' }).click();
  await expect(page.locator('body')).toHaveAttribute('data-printed', '');
  await stepShown(page, 2);
  await printed(page, async () => {
    const paper = page.locator('.handout');
    await expect(paper.getByRole('heading', { level: 1 })).toHaveText(title);
    await expect(paper.locator('.handout-missing')).toHaveCount(0);
    for (const [i, step] of steps.entries()) {
      const section = paper.locator('.handout-step').nth(i);
      await expect(section.locator('.handout-text h2')).toHaveText(`${i + 1} ${step.title}`);
      const live = section.locator('.handout-text [data-quantity]');
      const shown = await live.evaluateAll((all) =>
        all.map((one) => [one.getAttribute('data-quantity'), one.getAttribute('data-value')]),
      );
      const names = shown.map(([name]) => name ?? '');
      expect(Object.fromEntries(shown)).toEqual(computed(step, names));
    }
    await expect(paper.locator('.handout-scene svg').first()).toBeVisible();
    await expect(paper.locator('.handout-answer [data-quantity="t1"]')).toHaveText('1.8');
  });
  expect(await pages(page, 'A4')).toBe(2);
});

test('the scene is saved as lines, with every colour written out', async ({ page }) => {
  await open(page, '#/explore?shape=cone&method=certified');
  await page.keyboard.press('e');
  const row = page.locator('[data-export="picture-svg"]');
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    row.getByRole('button', { name: /^Save/ }).click(),
  ]);
  const svg = readFileSync(await download.path(), 'utf8');
  expect(svg).toMatch(/^<svg[^>]*xmlns="http:\/\/www.w3.org\/2000\/svg"/);
  expect(svg).not.toMatch(/NaN|var\(--|undefined/);
  expect(svg.match(/<path/g)?.length).toBeGreaterThan(30);
  for (const letter of ['𝐸', '𝑉', '𝑑']) expect(svg).toContain(letter);
  await expect(page.locator('.scene-for-file')).toHaveCount(0);
});
