import { readFileSync } from 'node:fs';
import type { Download, Page } from '@playwright/test';
import { violations, violationsInThemes } from './support/axe.ts';
import { problems } from './support/page.ts';
import { frames, timersDone } from './support/pending.ts';
import { expect, test as fresh, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

test.use({ viewport: { width: 1280, height: 900 } });

/** A tangent in whole numbers, one pixel one double. */
const TORN =
  'shape=cylinder&C=0,0,0&r=1&E=5,0,1&d=-1,0,0&method=textbook&atlas=E.z,r&zoom=13&by=ulps';
const map = (page: Page, i = 0) => page.locator('.map-field').nth(i);
const sentence = (page: Page, i = 0) => page.locator('.atlas-sentence').nth(i);

async function open(page: Page, settings: string): Promise<void> {
  await page.goto(`./#/accuracy?${settings}`);
  await drawn(page);
}

/** Until every map that is shown is whole. */
async function drawn(page: Page): Promise<void> {
  await expect(page.locator('.map-field[aria-busy="true"]')).toHaveCount(0, { timeout: 60_000 });
  await expect(sentence(page)).not.toContainText('being drawn', { timeout: 60_000 });
}

async function saved(page: Page, name: string): Promise<Buffer> {
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: `Save ${name}` }).click(),
  ]);
  return readFileSync(await (file as Download).path());
}

test('textbook’s torn edge: by keys and wheel, each gesture one step of undo', async ({ page }) => {
  await open(page, TORN);
  await expect(sentence(page)).toHaveText(
    /^Textbook is wrong in [\d.]+ % of this window\. What tears is D: its sign is wrong in all 24 /,
    { timeout: 60_000 },
  );
  await expect(page.locator('.failure-map > p').first()).toContainText('of D = 0');
  // No ink is lost on the way: the canvas has paper, grey and black.
  const tones = await map(page)
    .locator('canvas')
    .evaluate((canvas: HTMLCanvasElement) => {
      const { data } =
        canvas.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height) ?? {};
      return new Set(data?.filter((_, i) => i % 4 === 0)).size;
    });
  expect(tones).toBeGreaterThan(3);
  await map(page).focus();
  await page.keyboard.press('PageDown');
  await expect(page).toHaveURL(/zoom=12(&|$)/);
  await page.keyboard.press('Control+z');
  await expect(page).toHaveURL(/zoom=13/);
  await drawn(page);
  const box = await map(page).boundingBox();
  if (!box) throw new Error('the map is not shown');
  await page.mouse.move(box.x + box.width / 4, box.y + box.height / 4);
  await page.mouse.wheel(0, 480);
  await expect(page).toHaveURL(/zoom=11\.8/);
  await expect(page).toHaveURL(/at=/);
  await page.keyboard.press('Control+z');
  await expect(page).not.toHaveURL(/at=/);
  await expect(page).toHaveURL(/zoom=13/);
  // A drag moves the window, and is one step too.
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2, { steps: 6 });
  await page.mouse.up();
  await expect(page).toHaveURL(/at=/);
  await page.keyboard.press('Control+z');
  await expect(page).not.toHaveURL(/at=/);
});

// Where the cursor of the maps stands is kept.
fresh('a pixel is the ray of the table, of Explore, and where its digits go', async ({ page }) => {
  await open(page, TORN);
  await map(page).focus();
  // Below the middle, on the line: textbook sees a tangent where there is none.
  await page.keyboard.press('Home');
  for (const key of ['ArrowDown', 'ArrowRight']) await page.keyboard.press(key);
  await page.keyboard.press('Enter');
  const card = page.locator('.atlas-picked');
  await expect(card).toContainText('E.z = 1.0000000000000002, r = 0.9999999999999999');
  await expect(card).toContainText('textbook says “touches once”, right is “no point”');
  await expect(page.locator('.announcer')).toContainText('Chosen: E.z = 1.0000000000000002');
  await card.getByRole('button', { name: 'Where did its digits go?' }).click();
  await expect(page.locator('.steps-verdict')).toBeVisible();
  const row = page.locator('.ladder [data-method="textbook"]');
  await expect(row).toContainText('sees a hit that is not there');
  // The window stays.
  await expect(page).toHaveURL(/at=1,1/);
  await page.keyboard.press('Control+z');
  await expect(page).not.toHaveURL(/at=/);
  await card.getByRole('button', { name: 'Open in Explore' }).click();
  await expect(page).toHaveURL(/#\/explore\?.*E=5,0,1\.0000000000000002/);
});

test('two maps of one window; a rectangle is test cases; picture and numbers', async ({ page }) => {
  await open(page, `${TORN}&maps=textbook,moment`);
  await expect(sentence(page, 1)).toHaveText(/^Moment has the right class in every pixel/, {
    timeout: 60_000,
  });
  await map(page).focus();
  await page.keyboard.press('PageDown');
  await drawn(page);
  for (const i of [0, 1]) {
    await expect(page.locator('.atlas-axes').nth(i)).toContainText(
      '1 280 doubles'.replace(' 280', '.28 · 10³'),
    );
  }
  await page.keyboard.press('PageUp');
  await drawn(page);
  await page.keyboard.press('r');
  for (let i = 0; i < 3; i++) await page.keyboard.press('Control+ArrowDown');
  for (let i = 0; i < 3; i++) await page.keyboard.press('Control+ArrowRight');
  await page.keyboard.press('r');
  await expect(page.locator('.atlas-rectangle')).toContainText('49 by 49 pixels');
  const cases = JSON.parse(String(await saved(page, 'rays as cases')));
  expect(cases.graze).toBe('hard-cases');
  expect(cases.cases.length).toBeGreaterThan(10);
  expect(String(await saved(page, 'rays as tests'))).toContain("from 'vitest'");
  const csv = String(await saved(page, 'map as CSV'));
  expect(csv.trim().split('\n')).toHaveLength(256 * 256 + 1);
  const json = JSON.parse(String(await saved(page, 'map as JSON')));
  expect(json.maps.map((one: { rows: string[] }) => one.rows.length)).toEqual([256, 256]);
  expect(json.maps[1].rows.join('')).toMatch(/^\.+$/);
  expect((await saved(page, 'map as PNG')).subarray(1, 4).toString()).toBe('PNG');
});

const PROGRAM = `function intersect(shape: Shape, ray: Ray) {
  const [px, , pz] = ray.origin, [dx, , dz] = ray.direction, r = shape.radius;
  const A = dx * dx + dz * dz, B = 2 * (px * dx + pz * dz), C = px * px + pz * pz - r * r;
  const D = B * B - 4 * A * C;
  if (D < 0) return { t: [] };
  if (D === 0) return { t: [-B / (2 * A)] };
  return { t: [(-B - Math.sqrt(D)) / (2 * A), (-B + Math.sqrt(D)) / (2 * A)] };
}`;

fresh('the student’s own program has a map, beside certified’s', async ({ page }) => {
  await page.goto('./#/check');
  await page.evaluate((text) => localStorage.setItem('graze.check.program', text), PROGRAM);
  await open(page, `${TORN}&maps=own,certified`);
  await expect(sentence(page)).toHaveText(/^Your program is wrong in [\d.]+ % of this window/, {
    timeout: 90_000,
  });
  await expect(sentence(page, 1)).toHaveText('Certified has the right class in every pixel.');
  await map(page).focus();
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Try your program on it' }).click();
  await expect(page.locator('.atlas-picked [data-say]')).toContainText(
    'Your program answers t = 5; right is t = 5.',
    { timeout: 60_000 },
  );
});

test('without a program it says so; a link’s mistakes are told', async ({ page }) => {
  await page.goto(`./#/accuracy?${TORN}&maps=own`);
  await expect(page.locator('.atlas-progress').first()).toContainText(
    'There is no program of yours yet',
  );
  await page.goto('./#/accuracy?shape=sphere&atlas=k,E.z&maps=newton');
  await expect(problems(page).first()).toContainText("opened without maps: 'newton'");
  await expect(page.locator('.atlas')).toContainText("'k' is no number of this shape");
});

test('the plots lead to the map, and back; ready maps open', async ({ page }) => {
  await page.goto('./#/accuracy?shape=cone&method=textbook');
  await page.getByRole('button', { name: 'Map around this ray' }).click();
  await expect(page).toHaveURL(/atlas=E\.z,E\.y/);
  await drawn(page);
  await expect(page.locator('.acc-plot')).toBeHidden();
  await page.getByRole('button', { name: 'Close the map' }).click();
  await expect(page.locator('.acc-plot')).toBeVisible();
  await page.getByRole('button', { name: 'leaving a surface' }).click();
  await drawn(page);
  await expect(sentence(page)).toHaveText(/^Textbook with no start rule is wrong in \d+ % of/);
  await expect(sentence(page, 1)).toHaveText(/^Textbook with start rule: every ray/);
  await timersDone(page);
  await frames(page, 3);
});

test('axe finds nothing, and nothing is wider than the page', async ({ page }) => {
  for (const width of [1280, 390]) {
    await page.setViewportSize({ width, height: 844 });
    await open(page, `${TORN}&maps=textbook,moment`);
    await map(page).focus();
    await page.keyboard.press('Enter');
    const found = await (width > 390 ? violationsInThemes(page) : violations(page));
    expect.soft(found, `${width} px`).toEqual([]);
    const reach = await page.locator('main').evaluate((main) => main.scrollWidth);
    expect(reach).toBeLessThanOrEqual(width);
  }
});
