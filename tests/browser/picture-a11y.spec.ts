import { byTurns } from '../unit/many.ts';
import { violations, violationsInThemes } from './support/axe.ts';
import { settle } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

const STATES = [
  'scene=cone-on-mirror&pixel=48,25',
  'scene=self-intersection&against=start:none&pixel=30,30',
  'scene=far&against=method:textbook32&show=errors',
  'scene=soft-light&on=reflection&off=shadow',
];
/** The first scene, whose forms are looked at, below a problem. */
const BROKEN = 'scene=~broken';

for (const [n, width] of [1280, 390].entries()) {
  test(`axe finds nothing on the Picture page: ${width} px`, async ({ page }) => {
    await page.setViewportSize({ width, height: 800 });
    for (const state of [...byTurns(STATES, n), BROKEN]) {
      await page.goto(`./#/picture?size=96x54&method=certified&${state}`);
      await settle(page);
      await expect(page.locator('.picture')).toHaveAttribute('data-trace', 'finished');
      await expect(page.locator('.progress')).toHaveCount(0);
      await settle(page);
      // A narrow screen has no colours of its own.
      const found = await (width > 390 ? violationsInThemes(page) : violations(page));
      expect.soft(found, state).toEqual([]);
    }
    await page.getByRole('tab', { name: 'Scene' }).click();
    for (const part of ['glass cone', 'lamp', 'camera', 'background']) {
      await page.locator('.part-name', { hasText: part }).first().click();
      await settle(page);
      // The form of a shape has every kind of field.
      const found = width > 390 && part === 'glass cone' ? violationsInThemes : violations;
      expect.soft(await found(page, '.side-panel'), `the form of the ${part}`).toEqual([]);
    }
  });
}
