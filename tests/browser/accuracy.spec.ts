import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { METHODS } from '../../src/math/index.ts';
import { violations, violationsInThemes } from './support/axe.ts';
import { problems } from './support/page.ts';
import { frames } from './support/pending.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

test.use({ viewport: { width: 1280, height: 900 }, isolated: true });

/** A cone that is nearly grazed from afar. */
const RAY = 'shape=cone&E=153,34,31.75&d=-.93,-.206,-.1901&V=0,3,0&c=0.5';
const row = (page: Page, id: string) => page.locator(`.ladder [data-method="${id}"]`);
const marks = (page: Page) => page.locator('.plot-mark');

async function open(page: Page, settings = ''): Promise<void> {
  await page.goto(`./#/accuracy?${RAY}&method=textbook${settings}`);
  await expect(page.locator('.ladder tbody tr')).toHaveCount(METHODS.length);
}

const value = async (page: Page, id: string, quantity: string): Promise<string | null> =>
  row(page, id).locator(`[data-quantity="${quantity}"]`).getAttribute('data-value');

test('this ray, whatever is measured: verdicts, digits, and where they go', async ({ page }) => {
  await open(page);
  expect(await value(page, 'textbook', 'class')).toBe('two');
  const t1 = Number(await value(page, 'exact', 't1'));
  const own = Number(await value(page, 'textbook', 't1'));
  const digits = Number(await value(page, 'textbook', 'digits'));
  expect(own).not.toBe(t1);
  expect(digits).toBeLessThan(14);
  // As many bold digits as the count says, for the root with the fewest.
  for (const { id } of METHODS) {
    const count = Number(await row(page, id).locator('.count').textContent());
    const bold = await row(page, id).locator('.marked b').allTextContents();
    const counts = bold.map((text) => text.replace(/[^0-9]/g, '').length);
    expect(Math.min(...counts), id).toBe(count);
  }
  await expect(row(page, 'textbook')).toContainText('nearly equal numbers');
  await page.locator('main').getByText('Where did the digits go?').click();
  await expect(page.locator('.steps tr.worst')).toContainText('digits');
  await expect(page.locator('.steps-verdict')).toContainText('D = B² − 4 A C');
});

/** It measures by itself. On a machine of its own that takes some seconds. */
const measured = (page: Page) =>
  expect(page.locator('.measure-words')).toHaveText('Measured on this device.', {
    timeout: 100_000,
  });

test.describe('measured', () => {
  test.use({ idle: true });

  test('shows the reference, measures by itself, and the sentence has the table’s numbers', async ({
    page,
  }) => {
    await open(page, '&family=far-origin&target=typescript');
    await expect(page.locator('.acc-sentence')).toHaveText(
      /^By the reference prices of typical rays in random order, .+ costs? /,
    );
    await expect(page.locator('.plot-dot.faint')).toHaveCount(METHODS.length);
    await expect(page.locator('.measure-reference')).toContainText('typical rays');
    await measured(page);
    await expect(page.locator('.plot-dot.faint')).toHaveCount(0);
    await expect(page.locator('.measure-reference')).toHaveCount(0);
    await expect(marks(page)).toHaveCount(METHODS.length);
    for (const { id } of METHODS) {
      expect(Number(await value(page, id, 'typescript ns')), id).toBeGreaterThan(0);
    }
    expect(Number(await value(page, 'textbook', 'typescript ratio'))).toBe(1);
    const words = (await page.locator('.acc-sentence').textContent()) ?? '';
    const roots =
      /both roots, faithful to the last digit, cost .+? ([\d.]+) times .+?(\((\w+)\)|\.)$/;
    const [, times] = roots.exec(words) ?? [];
    if (times) {
      const prices = await page.locator('[data-quantity="typescript ratio"]').allTextContents();
      expect(prices).toContain(`${times}×`);
    }
    await expect(page.locator('.acc-details')).toContainText(/the textbook formula misjudges \d+/);
    await expect(row(page, 'textbook32')).toContainText('emulated');
    await expect(page.locator('.head-timed')).toHaveText(
      '× textbook: “far away” rays, both roots, above',
    );
    // Nothing certified or exact is wrong; the textbook formula is.
    await expect(
      page.getByRole('button', { name: /^certified: .* 0 of 3.072 verdicts wrong, 0 undecided/ }),
    ).toBeVisible();
    await expect(
      page.getByRole('button', { name: /^exact: .* 0 of 3.072 verdicts wrong, 0 undecided/ }),
    ).toBeVisible();
    await expect(
      page.getByRole('button', { name: /^textbook: .* [1-9]\d* of 3.072 verdicts wrong/ }),
    ).toBeVisible();
    // A mark is a choice of method, for the row and for Explore.
    await marks(page).and(page.locator('[data-method="moment"]')).focus();
    await page.keyboard.press('Enter');
    await expect(row(page, 'moment')).toHaveClass(/is-chosen/);
    await expect(page).toHaveURL(/method=moment/);
    const csv = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'table as CSV' }).click(),
    ]);
    const lines = readFileSync(await csv[0].path(), 'utf8')
      .trim()
      .split('\n');
    expect(lines).toHaveLength(METHODS.length + 1);
    expect(lines[2]?.startsWith('textbook,two,right,')).toBe(true);
    for (const line of lines)
      expect(line.split(',')).toHaveLength(lines[0]?.split(',').length ?? 0);
    const svg = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Save the frontier plot as SVG' }).click(),
    ]);
    expect(readFileSync(await svg[0].path(), 'utf8')).toMatch(
      /^<svg[\s\S]*certified[\s\S]*<\/svg>$/,
    );
    const png = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Save the frontier plot as PNG' }).click(),
    ]);
    expect(
      readFileSync(await png[0].path())
        .subarray(1, 4)
        .toString(),
    ).toBe('PNG');
    expect(await violations(page), 'with what is measured').toEqual([]);
  });

  test('cancelling ends it at once and keeps what was found; the page moves meanwhile', async ({
    page,
  }) => {
    await open(page);
    await measured(page);
    // No price of TypeScript stands in the column of SIMD.
    const simd = page.getByRole('button', { name: 'SIMD', exact: true });
    const details = page.locator('.acc-details');
    if ((await simd.getAttribute('aria-pressed')) === 'true') {
      await expect(details).not.toContainText('Compared in TypeScript');
    } else {
      await expect(details).toContainText('Compared in TypeScript: ');
      for (const { id } of METHODS)
        await expect(row(page, id).locator('.price.simd')).toHaveText('–');
    }
    await page.getByRole('button', { name: 'TypeScript', exact: true }).click();
    await page.getByRole('button', { name: 'Measure longer' }).click();
    await expect(page.locator('.measure-left')).toContainText(/round [2-9]/, { timeout: 100_000 });
    const slider = page.locator('.acc-dial input');
    await page.locator('main').getByText('What does one double more or less change?').click();
    await page.getByRole('button', { name: 'E.x one double up' }).click();
    await expect(page.locator('.nudge [data-quantity="E.x"]')).toHaveAttribute(
      'data-value',
      '153.00000000000003',
    );
    await page.getByRole('button', { name: 'Cancel' }).click();
    await expect(page.getByRole('button', { name: 'Measure longer' })).toBeVisible();
    await expect(page.locator('main').getByText(/Cancelled after \d+ of 15 rounds/)).toBeVisible();
    await expect(marks(page)).toHaveCount(METHODS.length);
    const before = await value(page, 'exact', 'typescript ns');
    // A round that was still on its way would come with one of the next frames.
    await frames(page, 30);
    expect(await value(page, 'exact', 'typescript ns')).toBe(before);
    // Other rays: what was measured does not belong to them, and they are measured in turn.
    const thumb = await slider.inputValue();
    await slider.focus();
    await page.keyboard.press('ArrowRight');
    await expect(slider).not.toHaveValue(thumb);
    await expect(page).toHaveURL(/dial=/);
    await expect(page.getByRole('button', { name: 'Cancel' })).toBeVisible();
    await expect(row(page, 'exact').locator('.price.typescript')).toHaveText('–');
  });
});

test('how hard: textbook ends in lost hits, and its worst ray opens in Explore', async ({
  page,
}) => {
  await open(page, '&hard=far-origin');
  const line = page.locator('.plot-line[data-method="textbook"]');
  await expect(page.locator('.plot-line')).toHaveCount(METHODS.length);
  await expect(page.locator('.acc-hard')).toContainText('loses hits');
  // The lines grow point by point.
  await expect(page.locator('.plot-line[data-method="certified"] .plot-shape')).toHaveCount(13);
  await line.focus();
  await page.keyboard.press('End');
  await expect(line).toHaveAttribute('aria-valuetext', /^textbook at 10.+ lose a hit/);
  // With the method that was picked, whichever was chosen before.
  await row(page, 'moment').getByRole('radio').check();
  await page.getByRole('button', { name: 'make it “This ray”' }).click();
  await expect(row(page, 'textbook')).toHaveClass(/is-chosen/);
  await expect(row(page, 'textbook')).toContainText('misses a hit');
  await row(page, 'moment').getByRole('radio').check();
  await page.getByRole('button', { name: 'open in Explore', exact: true }).click();
  await expect(page).toHaveURL(/#\/explore\?.*method=textbook/);
  await expect(page.getByRole('link', { name: 'Explore', exact: true })).toHaveAttribute(
    'aria-current',
    'page',
  );
});

test('one double more flips a verdict, with the keys', async ({ page }) => {
  // Tangent in whole numbers: one double nearer is two points, one farther none.
  await page.goto('./#/accuracy?shape=cylinder&E=2,0,-5&d=0,0,1&C=0,0,0&r=2&method=exact');
  await expect(row(page, 'exact')).toContainText('touches once');
  await page.locator('main').getByText('What does one double more or less change?').click();
  await page.getByRole('button', { name: 'E.x one double up' }).focus();
  await page.keyboard.press('ArrowUp');
  await expect(row(page, 'exact')).toContainText('no point');
  await expect(page.locator('.nudge-answer')).toHaveText(
    /^E\.x = 2 → 2\.0000000000000004: .*exact: touches once → no point \(right\)/,
  );
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  await expect(row(page, 'exact')).toContainText('two points');
  await expect(row(page, 'textbook32')).toContainText('misses a hit');
});

test('a link restores the settings, and says what it cannot use', async ({ page }) => {
  await page.goto(
    './#/accuracy?family=near-tangent&worth=wrong&order=sorted&target=typescript&hard=nea' +
      'r-axis&seed=9',
  );
  for (const name of [
    'near tangent',
    'wrong verdicts',
    'hits first',
    'TypeScript',
    'generator angle',
  ]) {
    await expect(page.getByRole('button', { name, exact: true })).toHaveAttribute(
      'aria-pressed',
      'true',
    );
  }
  await expect(page.locator('.provenance')).toContainText('seed 9');
  await page.getByRole('button', { name: 'far away', exact: true }).click();
  await expect(page).not.toHaveURL(/family=/);
  await page.goto('about:blank');
  await page.goto('./#/accuracy?family=nowhere&split=3');
  await expect(problems(page)).toContainText("opened without family: 'nowhere'");
  await expect(problems(page)).toContainText("'split' means nothing");
});

test('axe finds nothing, and nothing is wider than the page', async ({ page }) => {
  for (const width of [1280, 390]) {
    await page.setViewportSize({ width, height: 844 });
    await open(page);
    await expect(page.locator('.plot-line')).toHaveCount(METHODS.length);
    for (const part of await page.locator('details').all()) {
      if ((await part.getAttribute('open')) === null) await part.locator('> summary').click();
    }
    // A narrow screen has no colours of its own.
    const found = await (width > 390 ? violationsInThemes(page) : violations(page));
    expect.soft(found, `${width} px`).toEqual([]);
    const reach = await page.locator('main').evaluate((main) => main.scrollWidth);
    expect(reach).toBeLessThanOrEqual(width);
  }
});
