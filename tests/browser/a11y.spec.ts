import { SHAPES } from '../../src/math/index.ts';
import { BUT_CONTRAST, violations, violationsInThemes } from './support/axe.ts';
import { box, pickShape, slider, typeInto } from './support/controls.ts';
import { open, problems } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

const SIZES = [
  { width: 1280, height: 720 },
  { width: 390, height: 844 },
] as const;

for (const viewport of SIZES) {
  test.describe(`${viewport.width} px`, () => {
    test.use({ viewport });
    test('axe finds nothing for any shape, a refused text, a broken link', async ({ page }) => {
      await open(page, '#/explore?shape=cone&zoom=1');
      await page.locator('canvas').waitFor();
      expect.soft(await violations(page, 'html', BUT_CONTRAST), 'a broken link').toEqual([]);
      await page.getByRole('button', { name: 'Dismiss' }).click();
      for (const { kind, title } of SHAPES) {
        await pickShape(page, title);
        // A shape brings numbers of its own, but no colour.
        expect.soft(await violations(page, 'html', BUT_CONTRAST), kind).toEqual([]);
      }
      // In every theme one that has a rim and, with a refused text, one that has a discriminant.
      await pickShape(page, 'circle');
      expect.soft(await violationsInThemes(page), 'circle').toEqual([]);
      await open(page, '#/explore?shape=cone&zoom=1');
      await typeInto(page, 'c', 'abc');
      await expect(problems(page).nth(1)).toBeVisible();
      expect.soft(await violationsInThemes(page), 'a refused text').toEqual([]);
    });
  });
}

test('everything that can be operated has a name; the page has a language and a heading', async ({
  page,
}) => {
  await open(page, '#/explore?shape=square&method=exact');
  await page.locator('canvas').waitFor();
  const operable = page.locator('a, button, input, select, [tabindex="0"], [role="slider"]');
  const shown = await operable.filter({ visible: true }).all();
  for (const element of shown) await expect(element).toHaveAccessibleName(/\S/);
  await expect(slider(page, 'E.x')).toHaveAccessibleName(/E\.x/);
  await expect(box(page, 'L')).toHaveAccessibleName(/side/);
  await expect(page.locator('.graph-bead')).toHaveAttribute('aria-valuetext', /^t .*f /);
  await expect(page.locator('html')).toHaveAttribute('lang', 'en');
  await expect(page).toHaveTitle(/Graze/);
  await expect(page.getByRole('heading', { level: 1 })).toHaveCount(1);
  await expect(page.getByRole('heading', { name: /ray/i })).not.toHaveCount(0);
  await expect(page.getByRole('main')).toHaveCount(1);
});
