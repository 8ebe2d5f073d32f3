import { slider } from './support/controls.ts';
import { hashOf, linkWritten, open, quantities, settle } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

/** Key presses that all arrive before the page is drawn again. */
async function pressAtOnce(element: ReturnType<typeof slider>, key: string, times: number) {
  await element.focus();
  await element.evaluate(
    (target, [name, n]) => {
      for (let i = 0; i < n; i++) {
        target.dispatchEvent(
          new KeyboardEvent('keydown', { key: name, bubbles: true, cancelable: true }),
        );
      }
    },
    [key, times] as const,
  );
}

test('no key is lost, however fast they come: slider, box and bead', async ({ page }) => {
  await open(page, '#/explore?shape=cone&method=exact&t=1');
  await pressAtOnce(slider(page, 'E.x'), 'ArrowRight', 12);
  await settle(page);
  expect((await quantities(page))['E.x']).toBe('4.2');
  await pressAtOnce(page.locator('input.number[data-symbol="c"]'), 'ArrowUp', 5);
  await settle(page);
  expect((await quantities(page)).c).toBe('0.6');
  const before = Number((await quantities(page))['bead.t']);
  await pressAtOnce(page.locator('.graph-bead'), 'ArrowRight', 1);
  await settle(page);
  const step = Number((await quantities(page))['bead.t']) - before;
  await pressAtOnce(page.locator('.graph-bead'), 'ArrowRight', 6);
  await settle(page);
  expect(Number((await quantities(page))['bead.t'])).toBeCloseTo(before + 7 * step, 9);
});

test('and none of those that turn the scene', async ({ page }) => {
  await open(page, '#/explore?shape=cone&method=exact&view=10,20,1');
  await page.locator('canvas').waitFor();
  await pressAtOnce(page.locator('.scene-root'), 'ArrowRight', 9);
  await linkWritten(page);
  expect(await hashOf(page)).toContain('view=55,20,1');
});
