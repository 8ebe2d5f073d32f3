import { SHAPES, type Shape, type Vec3 } from '../../src/math/index.ts';
import { expectInLink, pickShape, resetOf, typeInto } from './support/controls.ts';
import { linkOf } from './support/expected.ts';
import { open, quantities, settle } from './support/page.ts';
import { expectShown, initial } from './support/question.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

test('with unit d the results are those of d / |d|, and |d| is not shown', async ({ page }) => {
  await open(page, '#/explore?shape=cylinder&E=3,1,0.5&d=-3,0,-4&method=exact');
  const { shape } = initial('cylinder');
  const origin: Vec3 = [3, 1, 0.5];
  const length = page.locator('.length');
  await expect(length).toContainText('5');
  await page.getByRole('checkbox', { name: /unit/ }).check();
  await settle(page);
  await expectShown(page, { shape, ray: { origin, direction: [-0.6, 0, -0.8] } });
  await expect(length).toBeHidden();
  await expectInLink(page, { unit: '1', d: '-3,0,-4' });
  await page.getByRole('checkbox', { name: /unit/ }).uncheck();
  await settle(page);
  await expectShown(page, { shape, ray: { origin, direction: [-3, 0, -4] } });
  await expectInLink(page, { unit: null });
});

test('the ray stays when the shape changes, and each shape remembers its parameters', async ({
  page,
}) => {
  await open(page, '#/explore?shape=cylinder&E=4,1,0.5&d=-1,0.1,0&method=exact');
  await typeInto(page, 'r', '1.75');
  for (const { kind, title } of [...SHAPES].reverse()) {
    await pickShape(page, title);
    const shown = await quantities(page);
    expect(shown, title).toMatchObject({ 'E.x': '4', 'E.z': '0.5', 'd.x': '-1', 'd.y': '0.1' });
    const plays = await page
      .locator('graze-play')
      .evaluateAll((all) =>
        all.map((one) => [one.getAttribute('label'), one.querySelector('button')?.ariaLabel]),
      );
    expect(plays.length, title).toBeGreaterThan(6);
    for (const [label, said] of plays) expect(said, title).toBe(`Play ${label}`);
    await expectInLink(page, { shape: kind, E: '4,1,0.5', d: '-1,0.1,0' });
    if (kind === 'circle') expect(shown.r).toBe('2');
    if (kind === 'hyperboloid') await typeInto(page, 'r', '0.3');
  }
  await pickShape(page, 'cylinder');
  expect((await quantities(page)).r).toBe('1.75');
  await pickShape(page, 'hyperboloid');
  expect((await quantities(page)).r).toBe('0.3');
});

test('the buttons of the square turn its normal', async ({ page }) => {
  await open(page, linkOf(initial('square').shape, initial('square').ray, { method: 'exact' }));
  const { shape, ray } = initial('square');
  for (const axis of ['y', 'z', 'x'] as const) {
    await page.locator('.choices').getByRole('button', { name: axis }).click();
    await settle(page);
    await expectShown(page, { shape: { ...shape, axis } as Shape, ray });
    await expectInLink(page, { axis: axis === 'x' ? null : axis });
  }
  await page.locator('.choices').getByRole('button', { name: 'z' }).click();
  await resetOf(page, 'axis').click();
  await settle(page);
  await expectShown(page, { shape, ray });
});
