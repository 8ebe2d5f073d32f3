import { cone } from '../unit/math/shorthand.ts';
import { box, expectInLink, slider } from './support/controls.ts';
import { expectedBead } from './support/expected.ts';
import { quantities, settle } from './support/page.ts';
import { middleOf, openScene, still } from './support/scene.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

test.use({ viewport: { width: 940, height: 700 } });

const START = '#/explore?shape=cone&method=exact';

test('the bead is dragged along the graph, and moved by keys', async ({ page }) => {
  await openScene(page, START);
  const shape = cone([0, 3, 0], 0.5);
  const ray = { origin: [3, 1, 1], direction: [-0.8, -0.2, -0.3] } as const;
  const expectBead = async (): Promise<number> => {
    await settle(page);
    const shown = await quantities(page);
    const t = Number(shown['bead.t']);
    expect(shown).toMatchObject(expectedBead(shape, ray, t));
    await expectInLink(page, { t: shown['bead.t'] ?? '' });
    return t;
  };
  const before = Number((await quantities(page))['bead.t']);
  const [x, y] = await middleOf(page, '.graph-handle');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y, { steps: 4 });
  const during = await expectBead();
  await page.mouse.up();
  expect(during).toBeGreaterThan(before);
  const mark = await page.locator('[data-mark="bead"]').getAttribute('transform');
  await page.locator('.graph-bead').focus();
  await page.keyboard.press('ArrowLeft');
  expect(await expectBead()).toBeLessThan(during);
  await still(page);
  const moved = await page.locator('[data-mark="bead"]').getAttribute('transform');
  expect(moved, 'the bead in the scene moves too').not.toBe(mark);
  await page.keyboard.press('Home');
  const first = await expectBead();
  await page.keyboard.press('End');
  expect(await expectBead()).toBeGreaterThan(first);
});

test('a symbol under the pointer or with the focus lights its others', async ({ page }) => {
  await openScene(page, START);
  const lit = (selector: string) => page.locator(`${selector}.lit, ${selector} .lit`);
  const everywhere = ['.scene-overlay', '.algebra math', '.controls'];
  await page.locator('.in-symbols [data-symbol="E"]').first().hover();
  for (const place of everywhere) await expect(lit(place).first()).toBeAttached();
  await expect(slider(page, 'E.z')).toHaveClass(/\blit\b/);
  await expect(slider(page, 'd.z')).not.toHaveClass(/\blit\b/);
  await page.mouse.move(2, 2);
  await expect(page.locator('.lit')).toHaveCount(0);
  await box(page, 'd.y').focus();
  for (const place of everywhere) await expect(lit(place).first()).toBeAttached();
  await expect(slider(page, 'd.x')).toHaveClass(/\blit\b/);
  await page.keyboard.press('ArrowUp');
  await settle(page);
  await expect(slider(page, 'd.x'), 'still lit after a change').toHaveClass(/\blit\b/);
  await expect(lit('.algebra math').first()).toBeAttached();
});
