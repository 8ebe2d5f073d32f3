import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { EFFECTS } from '../../src/scene/effects/index.ts';
import { findPreset } from '../../src/scene/presets/index.ts';
import { RAY_KINDS } from '../../src/tracer/types.ts';
import { expectInLink } from './support/controls.ts';
import { linkWritten, problems, settle } from './support/page.ts';
import { expect, test as fresh, visit as test } from './support/test.ts';
import { showTheme } from './support/theme.ts';

test.describe.configure({ mode: 'default' });

const SMALL = 'size=64x36&method=certified';

/** Opens the page with these settings and waits until all that they ask for is traced. */
async function openPicture(page: Page, settings: string): Promise<void> {
  if (page.url() === 'about:blank') await page.goto(`./#/picture?${settings}`);
  else {
    await page.evaluate((hash) => {
      location.hash = hash;
      dispatchEvent(new HashChangeEvent('hashchange'));
    }, `#/picture?${settings}`);
  }
  await traced(page);
}

async function traced(page: Page): Promise<void> {
  await settle(page);
  await expect(page.locator('.picture')).toHaveAttribute('data-trace', 'finished');
  await expect(page.locator('.progress')).toHaveCount(0);
  // While nothing else is to do the picture gets finer.
  await expect(page.locator('.picture')).toHaveAttribute('data-rest', 'still', { timeout: 60_000 });
}

/** A quantity in an effect's row; null where it is not. */
async function cell(page: Page, effect: string, quantity: string): Promise<number | null> {
  const element = page.locator(`[data-effect="${effect}"] [data-quantity="${quantity}"]`);
  if ((await element.count()) === 0) return null;
  return Number(await element.getAttribute('data-value'));
}

/** The picture on the right without loss, as text. */
async function pixels(page: Page): Promise<string> {
  return page
    .locator('.traced')
    .first()
    .evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL('image/png'));
}

const idle = (page: Page, id: string) => page.locator(`.idle [data-effect="${id}"]`);
const row = (page: Page, id: string) => page.locator(`.ledger [data-effect="${id}"]`);

test('glass cone on a mirror: what it cost; without the mirror its rays are gone', async ({
  page,
}) => {
  await openPicture(page, SMALL);
  expect(await cell(page, 'camera', 'rays')).toBe(64 * 36);
  expect(await cell(page, 'reflection', 'rays')).toBeGreaterThan(200);
  expect(await cell(page, 'reflection', 'roots')).toBeGreaterThan(200);
  const before = await cell(page, 'total', 'rays');
  // A plain picture of this size has some 300 characters.
  expect((await pixels(page)).length).toBeGreaterThan(2000);

  await page.getByRole('tab', { name: 'Scene' }).click();
  await page.getByRole('button', { name: 'remove mirror' }).click();
  await page.getByRole('tab', { name: 'What this picture needed' }).click();
  await traced(page);
  await expect(row(page, 'reflection')).toHaveCount(0);
  await expect(idle(page, 'reflection')).toContainText('no material is a mirror');
  expect(await cell(page, 'reflection', 'rays')).toBe(0);
  expect(await cell(page, 'total', 'rays')).toBeLessThan(before ?? 0);

  await page.getByRole('button', { name: 'Undo' }).click();
  await traced(page);
  expect(await cell(page, 'total', 'rays')).toBe(before);
});

test('rows add up: rays, questions and roots of camera and effects are the picture’s', async ({
  page,
}) => {
  await openPicture(page, `${SMALL}&scene=everything&light=4`);
  const named = await page
    .locator(':is(.ledger .entry:not(.total), .idle [data-effect])')
    .evaluateAll((rows) => rows.map((row) => row.getAttribute('data-effect') ?? ''));
  expect(named.sort()).toEqual(['camera', ...EFFECTS.map(({ id }) => id)].sort());
  for (const quantity of ['rays', 'questions', 'roots']) {
    const parts = await page
      .locator(`.ledger .entry:not(.total) [data-quantity="${quantity}"]`)
      .evaluateAll((cells) => cells.map((c) => Number(c.getAttribute('data-value'))));
    expect(parts.reduce((a, b) => a + b, 0)).toBe(await cell(page, 'total', quantity));
  }
  for (const quantity of ['rays', 'questions', 'roots']) {
    const kinds = await page
      .locator(`.kinds [data-quantity^="${quantity}."]`)
      .evaluateAll((cells) => cells.map((c) => Number(c.getAttribute('data-value'))));
    expect(kinds).toHaveLength(RAY_KINDS.length);
    expect(kinds.reduce((a, b) => a + b, 0)).toBe(await cell(page, 'total', quantity));
  }
  const sum = page.locator('.picture-map [data-quantity="sum"]');
  await expect(sum).toHaveAttribute('data-value', String(await cell(page, 'total', 'questions')));
});

test('time is measured when asked for: repeats of warm workers, and their sum', async ({
  page,
}) => {
  await openPicture(page, `${SMALL}&scene=shadows&on=reflection`);
  await page.getByRole('button', { name: 'measure the time' }).click();
  const waited = page.locator('[data-quantity="time.waited"]');
  await expect(waited).toBeVisible({ timeout: 60_000 });
  const number = async (name: string): Promise<number> =>
    Number(await page.locator(`[data-quantity="time.${name}"]`).getAttribute('data-value'));
  const count = page.locator('[data-quantity="time.workers"]');
  const workers = (await count.count()) ? await number('workers') : 1;
  const sum = (await number('work')) / workers + (await number('rest'));
  expect(sum).toBeCloseTo(await number('waited'), 6);
  expect(await cell(page, 'shadow', 'ms')).toBeGreaterThan(0);
  await expect(row(page, 'reflection').locator('[data-quantity="unforced"]')).toBeVisible();
  await page.getByLabel('bars by').selectOption('ms');
  await settle(page);
  expect(await cell(page, 'shadow', 'share')).toBeGreaterThan(0);
});

test('built up by one key, taken away by another; both ledgers of a comparison', async ({
  page,
}) => {
  await openPicture(page, `${SMALL}&scene=cone-on-mirror`);
  const built = page.locator('[data-quantity="built"]');
  const whole = Number(await built.getAttribute('data-value'));
  const total = await cell(page, 'total', 'questions');
  await page.keyboard.press('n');
  await expect(built).toHaveAttribute('data-value', '0');
  await traced(page);
  expect(await cell(page, 'total', 'rays')).toBe(64 * 36);
  await page.keyboard.press('n');
  await traced(page);
  await expect(row(page, 'shadow')).toHaveCount(1);
  await expect(row(page, 'reflection')).toHaveCount(0);
  await page.keyboard.press('Shift+N');
  await expect(built).toHaveAttribute('data-value', '0');
  await page.keyboard.press('Shift+N');
  await expect(built).toHaveAttribute('data-value', String(whole));
  await traced(page);
  expect(await cell(page, 'total', 'questions')).toBe(total);

  await page.getByRole('button', { name: 'Compare' }).click();
  await expectInLink(page, { against: 'off:reflection' });
  await traced(page);
  const both = page.locator('.two-ledgers [data-row="total"]');
  await expect(both.locator('[data-quantity="right"]')).toHaveAttribute('data-value', `${total}`);
  const value = async (name: string): Promise<number> =>
    Number(await both.locator(`[data-quantity="${name}"]`).getAttribute('data-value'));
  expect(await value('ratio')).toBe((await value('left')) / (await value('right')));
  expect(await value('ratio')).toBeLessThan(1);
  await expect(page.locator('.two-ledgers')).toContainText(
    'only the left one is without reflection',
  );
});

test('at rest the picture on the screen becomes the one with sixteen rays a pixel', async ({
  page,
}) => {
  await openPicture(page, `${SMALL}&scene=shadows&samples=16`);
  const whole = await pixels(page);
  for (const samples of [1, 9]) {
    await openPicture(page, `${SMALL}&scene=shadows&samples=${samples}`);
    await expect(page.locator('[data-quantity="rest"]')).toHaveText('16 rays a pixel');
    expect(await pixels(page)).toBe(whole);
  }
});

test('the camera is moved by drag, wheel and keys; one drag is one step of undo', async ({
  page,
}) => {
  await openPicture(page, `${SMALL}&scene=shadows`);
  await expect(page.locator('[data-quantity="rest"]')).toHaveAttribute('data-value', '16');
  const picture = page.getByRole('application');
  await picture.scrollIntoViewIfNeeded();
  const before = await pixels(page);
  const sceneIs = (value: string | RegExp) =>
    expect(page.getByLabel('scene:')).toHaveValue(value, { timeout: 15_000 });
  const box = await picture.boundingBox();
  if (!box) throw new Error('no picture');
  await page.mouse.move(box.x + 100, box.y + 100);
  await page.mouse.down();
  for (const step of [20, 40, 60]) await page.mouse.move(box.x + 100 + step, box.y + 110);
  await expect(page.locator('.picture')).toHaveAttribute('data-trace', 'moving');
  await page.mouse.up();
  await sceneIs(/^~/);
  await traced(page);
  await expectInLink(page, { pixel: null });
  expect(await pixels(page)).not.toBe(before);
  await page.getByRole('button', { name: 'Undo' }).click();
  await sceneIs('shadows');
  await traced(page);
  expect(await pixels(page)).toBe(before);
  for (const key of ['Shift+ArrowLeft', 'Control+Shift+ArrowUp', '+']) {
    await picture.press(key);
    await sceneIs(/^~/);
    await traced(page);
    await page.getByRole('button', { name: 'Undo' }).click();
    await sceneIs('shadows');
    await traced(page);
  }
  await picture.focus();
  await page.mouse.move(box.x + 100, box.y + 100);
  await page.mouse.wheel(0, -200);
  await sceneIs(/^~/);
});

test('a pixel’s number is read from the map, by the pointer or by the cursor', async ({ page }) => {
  await openPicture(page, `${SMALL}&scene=cone-on-mirror`);
  const value = page.locator('[data-quantity="pixel.questions"]');
  await expect(value).toHaveCount(0);
  await page.locator('.map-frame').scrollIntoViewIfNeeded();
  const box = await page.locator('.map-frame').boundingBox();
  if (!box) throw new Error('no map');
  await page.mouse.move(box.x + (box.width * 32.5) / 64, box.y + (box.height * 17.5) / 36);
  const glass = Number(await value.getAttribute('data-value'));
  await page.mouse.move(box.x + 3, box.y + 3);
  await expect(page.locator('.map-pixel')).toContainText('pixel 0, 0');
  expect(Number(await value.getAttribute('data-value'))).toBeLessThan(glass / 4);
  await page.mouse.move(0, 0);
  await page.getByRole('application').focus();
  await page.keyboard.press('ArrowRight');
  await expect(page.locator('.map-pixel')).toContainText('pixel 33, 18');
  await page.getByRole('tab', { name: 'questions' }).press('ArrowRight');
  await expectInLink(page, { show: 'roots' });
  await expect(page.getByRole('tab', { name: 'roots' })).toBeFocused();
});

fresh('before the first picture its map has the same place, and says so', async ({ page }) => {
  const held: (() => Promise<void>)[] = [];
  await page.route(/\/worker-[^/]*\.js$/, (route) => {
    held.push(() => route.continue());
  });
  await page.goto(`./#/picture?${SMALL}&scene=plain`);
  await expect(page.locator('.map-pixel')).toHaveText('not traced yet');
  const place = async () => (await page.locator('.map-frame').boundingBox())?.height ?? 0;
  const before = await place();
  for (const go of held) await go();
  await traced(page);
  await expect(page.locator('.map-pixel')).not.toHaveText('not traced yet');
  expect(before).toBeGreaterThan(100);
  expect(Math.abs((await place()) - before)).toBeLessThan(1);
});

fresh('only what a scene needs is loaded', async ({ page }) => {
  const asked: string[] = [];
  page.context().on('request', (request) => asked.push(request.url()));
  const bodies = () =>
    [...new Set(asked.flatMap((url) => /([a-z-]+)-body/.exec(url)?.[1] ?? []))].sort();
  await openPicture(page, `${SMALL}&scene=plain`);
  const { simulated } = await page.evaluate(() => ({
    simulated: [...document.querySelectorAll('.ledger tbody.entry')].map(
      (e) => e.getAttribute('data-effect') ?? '',
    ),
  }));
  const effects = simulated.filter((id) => id !== 'camera' && id !== 'total').sort();
  expect(bodies()).toEqual(effects);
  expect(bodies()).not.toContain('reflection');
  await openPicture(page, `${SMALL}&scene=mirror`);
  expect(bodies()).toContain('reflection');
  expect(bodies()).not.toContain('refraction');
});

test('forced on, an effect costs rays and changes no bit; forced off, it changes some', async ({
  page,
}) => {
  await openPicture(page, `${SMALL}&scene=shadows`);
  const before = await pixels(page);
  await idle(page, 'reflection').getByRole('button').click();
  await traced(page);
  await expect(row(page, 'reflection')).toContainText(
    'forced on; not needed: no material is a mirror',
  );
  expect(await cell(page, 'reflection', 'rays')).toBeGreaterThan(100);
  expect(await cell(page, 'reflection', 'pixels')).toBe(0);
  expect(await pixels(page)).toBe(before);
  await row(page, 'reflection').getByRole('button', { name: 'as called for' }).click();
  await traced(page);
  await expect(row(page, 'reflection')).toHaveCount(0);

  await row(page, 'shadow').getByRole('button', { name: 'force off' }).click();
  await traced(page);
  await expect(idle(page, 'shadow')).toContainText('forced off; needed');
  expect(await cell(page, 'shadow', 'pixels')).toBeGreaterThan(20);
  expect(await pixels(page)).not.toBe(before);
  await expectInLink(page, { off: 'shadow', on: null });
});

test('the pixels that each effect changes are counted when asked for', async ({ page }) => {
  // A size of its own: of pictures that were compared the pixels are known.
  await openPicture(page, 'size=90x50&method=certified&scene=cone-on-mirror');
  expect(await cell(page, 'reflection', 'pixels')).toBeNull();
  await page.getByRole('button', { name: 'count the pixels that each changes' }).click();
  await expect(
    page.locator('.ledger tbody:not([data-effect=camera]) [data-quantity=pixels]'),
  ).toHaveCount(5, { timeout: 40_000 });
  expect(await cell(page, 'reflection', 'pixels')).toBeGreaterThan(100);
  expect(await cell(page, 'reflection', 'pixels')).toBeLessThan(90 * 50);
});

test('a trace can be cancelled, and goes on at a change', async ({ page }) => {
  await page.goto('./#/picture?size=1280x720&samples=16&scene=everything&method=exact');
  await expect(page.getByRole('progressbar')).toBeVisible();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await expect(page.locator('.picture')).toHaveAttribute('data-trace', 'cancelled');
  await expect(page.locator('.picture-status')).toContainText('cancelled at');
  await expect(page.getByRole('button', { name: 'Trace again' })).toBeVisible();
  await page.getByLabel('size', { exact: true }).selectOption('160x90');
  await page.getByLabel('rays a pixel').selectOption('1');
  await page
    .getByRole('group', { name: 'Method for every ray' })
    .getByRole('button', { name: 'moment' })
    .click();
  await traced(page);
});

test('acne: no method cures it, the start rule does', async ({ page }) => {
  const scene = 'size=160x90&scene=self-intersection';
  const differing = async (): Promise<number> =>
    Number(await page.locator('[data-quantity="differing"]').getAttribute('data-value'));
  for (const method of ['moment', 'exact']) {
    await openPicture(page, `${scene}&method=${method}&against=start:none`);
    expect(await differing(), `${method}: rule against none`).toBeGreaterThan(1000);
  }
  await openPicture(page, `${scene}&method=moment&against=method:exact`);
  expect(await differing(), 'with the rule, moment against exact').toBeLessThan(20);
  await expect(page.locator('.compare-sentence')).toContainText('only the method is not');
});

test('holes and wrong silhouettes come from the method', async ({ page }) => {
  const verdicts = async (): Promise<number> =>
    Number(await page.locator('[data-quantity="verdicts"]').getAttribute('data-value'));
  await openPicture(page, 'size=160x90&scene=far&method=certified&against=method:textbook32');
  expect(await verdicts()).toBeGreaterThan(500);
  await openPicture(page, 'size=160x90&scene=far&method=certified&against=method:exact');
  expect(await verdicts()).toBe(0);
});

test('the divider is moved by keys and by the pointer; one drag is one step of undo', async ({
  page,
}) => {
  await openPicture(page, `${SMALL}&scene=shadows&against=start:none`);
  const divider = page.getByRole('slider', { name: /divider/ });
  await expect(divider).toHaveAttribute('aria-valuenow', '50');
  await divider.press('ArrowRight');
  await settle(page);
  await expect(divider).toHaveAttribute('aria-valuenow', '55');
  await divider.press('Shift+ArrowLeft');
  await settle(page);
  await expect(divider).toHaveAttribute('aria-valuenow', '54.5');
  const box = await divider.boundingBox();
  if (!box) throw new Error('no divider');
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (const dx of [-20, -60, -120]) await page.mouse.move(x + dx, y);
  await page.mouse.up();
  await settle(page);
  expect(Number(await divider.getAttribute('aria-valuenow'))).toBeLessThan(45);
  await page.getByRole('button', { name: 'Undo' }).click();
  await settle(page);
  await expect(divider).toHaveAttribute('aria-valuenow', '54.5');
  await page.getByRole('tab', { name: 'errors' }).click();
  await expect(page.locator('.map-key')).toBeVisible();
  await expectInLink(page, { show: 'errors' });
});

test('a pixel’s rays: the list, the algebra, and the same ray in Explore', async ({ page }) => {
  await openPicture(page, `${SMALL}&scene=cone-on-mirror&pixel=32,17`);
  const list = page.locator('.rays tbody tr');
  await expect(list.first()).toContainText('glass cone');
  expect(await list.count()).toBeGreaterThan(3);
  await expect(page.locator('.rays [data-kind="refracted"]').first()).toBeVisible();
  const t = await list.first().locator('[data-quantity="t"]').getAttribute('data-value');
  // One after another: in the list and in space there is what has been fired.
  const [at, later] = [page.locator('[data-quantity="ray"]'), page.locator('.rays tr.later')];
  const all = await list.count();
  await page.getByRole('button', { name: 'next ray' }).click();
  await expect(at).toHaveAttribute('data-value', '1');
  await expect(at).toContainText('camera ray; glass cone at t =');
  await expect(later).toHaveCount(all - 1);
  const space = page.locator('.tree-root');
  await space.press('PageDown');
  await expect(at).toHaveAttribute('data-value', '2');
  await page.getByRole('button', { name: 'play the rays' }).click();
  await page.getByRole('button', { name: 'stand still' }).click();
  // Back to before the first, however far it has come.
  const come = Number(await at.getAttribute('data-value'));
  expect(come).toBeGreaterThan(1);
  for (let i = 0; i < come; i++) await space.press('PageUp');
  await expect(later).toHaveCount(0);
  // Picked in space, lit in the list.
  await space.press('PageUp');
  await expect(list.last()).toHaveClass('chosen');
  await expect(at).toHaveAttribute('data-value', String(all));
  await page.getByRole('button', { name: 'camera ray', exact: true }).click();
  await settle(page);
  await expect(page.locator('.hit-step[data-step="D"]')).toBeVisible();
  await expect(page.locator('.camera-line[data-step="u"]')).toContainText('=');
  await page.locator('.camera-line[data-step="d"] summary').click();
  await expect(page.locator('.camera-line[data-step="d"]')).toContainText('t is a length');
  await expect(page.locator('.pixel-space canvas')).toBeVisible();
  const link = await page
    .getByRole('link', { name: 'Open this ray in Explore' })
    .getAttribute('href');
  await page.getByRole('link', { name: 'Open this ray in Explore' }).click();
  await page.locator('[data-quantity="class"]').waitFor();
  await settle(page);
  expect(await page.evaluate(() => location.hash)).toBe(link);
  const roots = await page
    .locator('[data-quantity="t1"], [data-quantity="t2"]')
    .evaluateAll((cells) => cells.map((c) => c.getAttribute('data-value')));
  expect(roots).toContain(t);
  const started = page.locator('.started');
  await expect(started).toContainText('first hit');
  expect(await started.getAttribute('data-first')).toBe(t);
  await started.getByRole('link', { name: 'back to pixel 32, 17' }).click();
  await expect(page.getByRole('heading', { name: 'Pixel 32, 17' })).toBeVisible();
  await expectInLink(page, { pixel: '32,17', scene: 'cone-on-mirror' });
});

test('the picture is used by keys alone', async ({ page }) => {
  await openPicture(page, `${SMALL}&scene=mirror`);
  const frame = page.getByRole('application', { name: /Picture, 64 by 36/ });
  await frame.focus();
  await frame.press('ArrowRight');
  await frame.press('ArrowDown');
  await frame.press('Control+ArrowDown');
  await frame.press('Enter');
  await settle(page);
  await expectInLink(page, { pixel: '33,29' });
  await expect(page.getByRole('heading', { name: 'Pixel 33, 29' })).toBeVisible();
  await expect(page.locator('.announcer')).toContainText('pixel 33, 29');
  await page.getByRole('button', { name: 'close' }).click();
  await expectInLink(page, { pixel: null });
  await page.getByRole('tab', { name: 'What this picture needed' }).press('ArrowRight');
  await settle(page);
  await expect(page.getByRole('tab', { name: 'Scene' })).toBeFocused();
  await expect(page.getByRole('tabpanel', { name: 'Scene' })).toBeVisible();
});

fresh('a click chooses the pixel under it', async ({ page }) => {
  await openPicture(page, `${SMALL}&scene=mirror`);
  const frame = page.getByRole('application');
  const box = await frame.boundingBox();
  if (!box) throw new Error('no picture');
  await frame.click({ position: { x: (box.width * 10.5) / 64, y: (box.height * 20.5) / 36 } });
  await expectInLink(page, { pixel: '10,20' });
});

test('a broken link opens what can be opened, and says what was wrong', async ({ page }) => {
  await openPicture(page, `${SMALL}&scene=~nonsense&against=method:none&zoom=3`);
  const alert = problems(page);
  await expect(alert).toContainText('opened without scene:');
  await expect(alert).toContainText("'~nonsense'");
  await expect(alert).toContainText("'method:none' is nothing to compare with");
  await expect(alert).toContainText("'zoom' means nothing for a picture");
  await expect(page.getByLabel('scene:')).toHaveValue('cone-on-mirror');
});

test('a scene is edited, saved, opened again, and travels in the link', async ({ page }) => {
  await openPicture(page, `${SMALL}&scene=plain`);
  await page.getByRole('tab', { name: 'Scene' }).click();
  await page.getByRole('button', { name: 'add a square' }).click();
  await traced(page);
  await expect(page.locator('[data-part="square"]')).toBeVisible();
  await page.locator('[data-part="square"] input.number[data-symbol="L"]').fill('1.25');
  await page.locator('[data-part="square"] input.number[data-symbol="L"]').press('Enter');
  await page.getByLabel('mirror', { exact: true }).fill('2');
  await page.getByLabel('mirror', { exact: true }).press('Enter');
  await expect(
    page.locator('main').getByText('mirror must be a number from 0 to 1, got 2'),
  ).toBeVisible();
  await page.getByLabel('mirror', { exact: true }).fill('0.5');
  await page.getByLabel('mirror', { exact: true }).press('Enter');
  await traced(page);
  const saved = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save scene' }).click();
  const file = await (await saved).path();
  const { scene } = JSON.parse(readFileSync(file, 'utf8'));
  const square = scene.things.at(-1);
  expect(square).toMatchObject({ id: 'square', shape: { side: 1.25 }, material: { mirror: 0.5 } });
  await linkWritten(page);
  const link = await page.evaluate(() => location.hash);
  expect(link).toContain('scene=~');

  await openPicture(page, `${SMALL}&scene=plain`);
  await page.getByRole('tab', { name: 'Scene' }).click();
  await expect(page.locator('[data-part="square"]')).toHaveCount(0);
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Open a scene' }).click();
  await (await chooser).setFiles(file);
  await expect(page.locator('[data-part="square"]')).toBeVisible();
  await traced(page);
  await linkWritten(page);
  const scenes = [link, await page.evaluate(() => location.hash)].map((hash) =>
    new URLSearchParams(hash.split('?')[1]).get('scene'),
  );
  expect(scenes[1]).toBe(scenes[0]);
});

test('what is dragged takes its heights along; one drag is one step of undo', async ({ page }) => {
  await openPicture(page, `${SMALL}&scene=cone-on-mirror&drag=wall`);
  await page.getByRole('tab', { name: 'Scene' }).click();
  await expect(page.getByRole('radio', { name: 'a wall' })).toBeChecked();
  await page.getByRole('application').scrollIntoViewIfNeeded();
  const box = await page.getByRole('application').boundingBox();
  if (!box) throw new Error('no picture');
  const [x, y] = [box.x + box.width * 0.5, box.y + box.height * 0.4];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await settle(page);
  const form = page.locator('[data-part="glass cone"] .part-form');
  await expect(form).toBeVisible();
  const number = async (label: string): Promise<number> =>
    Number(await form.getByRole('textbox', { name: label, exact: true }).getAttribute('title'));
  const before = [await number('V.x'), await number('V.y'), await number('from y')] as const;
  for (const step of [1, 2, 3]) await page.mouse.move(x + 20 * step, y - 10 * step);
  await page.mouse.up();
  await traced(page);
  const [Vx, Vy, low] = [await number('V.x'), await number('V.y'), await number('from y')];
  expect(Vx - before[0]).toBeGreaterThan(0.3);
  expect(Vy - before[1]).toBeGreaterThan(0.1);
  expect(low - before[2]).toBeCloseTo(Vy - before[1], 9);
  await expectInLink(page, { pixel: null });
  await page.getByRole('button', { name: 'Undo' }).click();
  await traced(page);
  await expect(page.getByLabel('scene:')).toHaveValue('cone-on-mirror');

  // The lamp by its handle, which the pointer leaves with its first move; then by a key.
  const lamp = page.locator('.scene-grip[data-handle="lamp"]');
  const placeOf = async (): Promise<readonly number[]> => {
    const words = (await lamp.getAttribute('aria-label')) ?? '';
    return [...words.replaceAll('−', '-').matchAll(/-?[\d.]+(?=[,)])/g)].map(Number);
  };
  const start = await placeOf();
  const grip = await lamp.boundingBox();
  if (!grip) throw new Error('no handle');
  const [gx, gy] = [grip.x + grip.width / 2, grip.y + grip.height / 2];
  await page.mouse.move(gx, gy);
  await page.mouse.down();
  await page.mouse.move(gx + 60, gy);
  await page.mouse.up();
  // It is let go of: this moves nothing.
  await page.mouse.move(gx + 90, gy + 60);
  await traced(page);
  const dragged = await placeOf();
  expect(dragged[0]).toBeGreaterThan((start[0] ?? 0) + 0.1);
  expect(dragged[1]).toBe(start[1]);
  await lamp.press('ArrowUp');
  await traced(page);
  const pressed = await placeOf();
  expect(pressed[1]).toBeGreaterThan(dragged[1] ?? 0);
  expect([pressed[0], pressed[2]]).toEqual([dragged[0], dragged[2]]);
  for (const before of [dragged, start]) {
    await page.getByRole('button', { name: 'Undo' }).click();
    await traced(page);
    expect(await placeOf()).toEqual(before);
  }
  await expect(page.getByLabel('scene:')).toHaveValue('cone-on-mirror');
});

test('new things stand beside the others, by their names, and are taken out by one undo', async ({
  page,
}) => {
  await openPicture(page, `${SMALL}&scene=plain`);
  await page.getByRole('tab', { name: 'Scene' }).click();
  const add = page.getByRole('button', { name: 'add a ball' });
  await add.click();
  await add.click();
  const form = page.locator('[data-part="ball 3"] .part-form');
  await expect(form.locator('input.number[data-symbol="r"]')).toBeVisible();
  await expect(page.locator('.announcer')).toContainText('ball 3 added');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.locator('[data-part="ball 2"]')).toBeVisible();
  await expect(page.locator('[data-part="ball 3"]')).toHaveCount(0);
});

test('a file that is no scene says why, and changes nothing', async ({ page }) => {
  await openPicture(page, `${SMALL}&scene=plain`);
  await page.getByRole('tab', { name: 'Scene' }).click();
  const scene = { ...findPreset('plain')?.scene, ambient: 7 };
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Open a scene' }).click();
  await (await chooser).setFiles({
    name: 'scene.json',
    mimeType: 'application/json',
    buffer: Buffer.from(JSON.stringify(scene)),
  });
  await expect(problems(page)).toContainText('ambient must be a number from 0 to 1, got 7');
  await expect(page.getByLabel('scene:')).toHaveValue('plain');
});

test('the shape of Explore can be put into a scene', async ({ page }) => {
  await page.goto('./#/explore?shape=circle&r=0.75');
  await page.locator('[data-quantity="class"]').waitFor();
  await page.getByRole('link', { name: 'Picture' }).click();
  await page.getByRole('tab', { name: 'Scene' }).click();
  await page.getByRole('button', { name: 'the circle of Explore' }).click();
  await settle(page);
  await expect(page.locator('[data-part="circle"] input.number[data-symbol="r"]')).toHaveValue(
    '0.75',
  );
});

test('another page is shown: the trace rests, and the picture is there again afterwards', async ({
  page,
}) => {
  await openPicture(page, `${SMALL}&scene=mirror`);
  const before = await pixels(page);
  await page.getByRole('link', { name: 'Explore' }).click();
  await page.locator('[data-quantity="class"]').waitFor();
  await expect(page.locator('.picture')).toHaveCount(0);
  await page.getByRole('link', { name: 'Picture' }).click();
  await expect(page.locator('.picture')).toHaveAttribute('data-trace', 'finished');
  expect(await pixels(page)).toBe(before);
});

test('picture, scene and ledger can be taken away', async ({ page }) => {
  await openPicture(page, `${SMALL}&scene=mirror`);
  for (const [id, start] of [
    ['picture-png', Buffer.from([0x89, 0x50, 0x4e, 0x47])],
    ['scene-json', Buffer.from('{\n  "graze": "scene"')],
    ['ledger-csv', Buffer.from('effect,needed,')],
  ] as const) {
    await page.getByRole('button', { name: 'File and export' }).click();
    const saved = page.waitForEvent('download');
    await page.locator(`[data-export="${id}"]`).getByRole('button', { name: 'Save' }).click();
    const content = readFileSync(await (await saved).path());
    expect(content.subarray(0, start.length), id).toEqual(start);
  }
});

test('the PNG has the pixels that are on the screen, with sixteen rays each', async ({ page }) => {
  await openPicture(page, `${SMALL}&scene=shadows`);
  await page.getByRole('button', { name: 'File and export' }).click();
  const saved = page.waitForEvent('download');
  await page.locator('[data-export="picture-png"]').getByRole('button', { name: 'Save' }).click();
  const png = readFileSync(await (await saved).path()).toString('base64');
  await page.keyboard.press('Escape');
  await expect(page.locator('[data-quantity="rest"]')).toHaveText('16 rays a pixel');
  expect(`data:image/png;base64,${png}`).toBe(await pixels(page));
});

test('a link measures how the price grows, and finds the cheapest picture within a budget', async ({
  page,
}) => {
  await openPicture(page, 'size=48x27&method=certified&scene=glass&growth=on&budget=10%25,5');
  await expect(page.locator('.picture')).toHaveAttribute('data-prices', 'rests', {
    timeout: 120_000,
  });
  const names = await page
    .locator('.growth-plot [data-quantity]')
    .evaluateAll((all) => all.map((one) => (one as HTMLElement).dataset.value));
  expect(names.length).toBeGreaterThan(5);
  for (const name of names) {
    expect(['constant', 'linear', 'logarithmic', 'neither']).toContain(name);
  }
  await page.getByRole('tab', { name: 'What this picture needed' }).click();
  await page.getByLabel('bars by').selectOption('rays');
  await expect(page.locator('.growth-words').first()).toContainText('rays, the same on every');
  const share = page.locator('[data-quantity="budget.share"]');
  const part = Number(await share.getAttribute('data-value'));
  expect(part).toBeLessThan(1);
  const whole = await cell(page, 'total', 'questions');
  for (const theme of ['projector', 'light']) {
    await showTheme(page, theme);
    await expect(page.locator('.budget-classes'), theme).toBeVisible();
  }
  await page.getByRole('button', { name: 'show it beside the whole picture' }).click();
  await traced(page);
  await expectInLink(page, { against: 'whole', show: 'errors', budget: '10%,5' });
  expect(await cell(page, 'total', 'questions')).toBeLessThan(whole ?? 0);
  await expect(page.locator('.compare-sentence')).toContainText('Left: the whole picture');
  // What was found stays while its picture is shown.
  await expect(share).toHaveAttribute('data-value', String(part));
  await page.getByRole('button', { name: 'File and export' }).click();
  for (const id of ['growth-csv', 'budget-csv']) {
    await expect(page.locator(`[data-export="${id}"]`)).toBeVisible();
  }
  await page.keyboard.press('Escape');
  await page.getByLabel('largest difference').selectOption('');
  await page.getByRole('button', { name: 'close' }).click();
  await expectInLink(page, { budget: null, growth: null });
  await expect(page.locator('.growth-plot')).toHaveCount(0);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 } });
  test('nothing sticks out to the side', async ({ page }) => {
    for (const settings of [
      `${SMALL}&scene=everything&light=4&pixel=32,20`,
      `${SMALL}&scene=self-intersection&against=start:none&pixel=20,20`,
    ]) {
      await openPicture(page, settings);
      const width = await page.evaluate(() => document.scrollingElement?.scrollWidth);
      expect(width, settings).toBe(390);
    }
    await page.getByRole('tab', { name: 'Scene' }).click();
    for (const part of ['cone', 'lamp', 'camera', 'background']) {
      await page.locator('.part-name', { hasText: part }).first().click();
      await settle(page);
      const width = await page.evaluate(() => document.scrollingElement?.scrollWidth);
      expect(width, part).toBe(390);
    }
  });
});

test.describe('under a finger', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });
  test('the picture says how fingers move the camera, not keys and wheel', async ({ page }) => {
    await openPicture(page, `${SMALL}&scene=plain`);
    const hint = page.locator('.camera-hint');
    await expect(hint).toContainText(/two fingers move/, { useInnerText: true });
    await expect(hint).not.toContainText(/Shift|wheel/, { useInnerText: true });
  });

  test('on a phone on its side the whole picture is in view, with any choice over it', async ({
    page,
  }) => {
    await page.setViewportSize({ width: 844, height: 390 });
    for (const settings of ['scene=mirror', 'scene=shadows&samples=16', 'scene=everything.2']) {
      await openPicture(page, `${SMALL}&${settings}`);
      await expect(page.locator('.picture-frame'), settings).toBeInViewport({ ratio: 1 });
    }
  });
});

test('nothing sticks out to the side at any width', async ({ page }) => {
  await openPicture(
    page,
    `${SMALL}&scene=everything&light=4&pixel=32,20&against=start:none&split=100`,
  );
  for (const width of [600, 768, 1000, 1024, 1100, 1920]) {
    await page.setViewportSize({ width, height: 800 });
    await settle(page);
    expect.soft(await page.evaluate(() => document.scrollingElement?.scrollWidth)).toBe(width);
  }
  // A phone on its side: the ledger stands beside the picture.
  await page.setViewportSize({ width: 844, height: 390 });
  await settle(page);
  expect(await page.evaluate(() => document.scrollingElement?.scrollWidth)).toBe(844);
  const boxes = await Promise.all(
    ['.compare-view', '.side-panel'].map((name) => page.locator(name).boundingBox()),
  );
  const [picture, panel] = boxes;
  if (!picture || !panel) throw new Error('not there');
  expect(panel.x).toBeGreaterThan(picture.x + picture.width);
  expect(panel.y).toBeLessThan(390);
});

fresh.describe('without WebGL', () => {
  fresh('the list of rays and their lines in space are there', async ({ page }) => {
    await page.addInitScript(() => {
      const get = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (
        this: HTMLCanvasElement,
        kind: string,
        ...rest: never[]
      ) {
        return kind === 'webgl2'
          ? null
          : (get as never as (...all: unknown[]) => unknown).call(this, kind, ...rest);
      } as never;
    });
    await openPicture(page, `${SMALL}&scene=mirror&pixel=32,20`);
    await expect(page.locator('.rays tbody tr').first()).toBeVisible();
    await expect(async () => {
      const lines = await page.locator('.pixel-space .scene-paths path').count();
      expect(lines).toBeGreaterThan(5);
    }).toPass({ timeout: 10_000 });
  });
});
