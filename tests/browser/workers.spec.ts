import type { Page } from '@playwright/test';
import { expect, test } from './support/test.ts';

// What measures by itself is to die.
test.use({ idle: true });

/** Ends all workers as a lack of memory does: the page that started them is told nothing. */
async function mortal(page: Page): Promise<() => Promise<void>> {
  await page.addInitScript(() => {
    const workers: Worker[] = [];
    const Own = Worker;
    const kill = () => {
      for (const worker of workers) Own.prototype.terminate.call(worker);
    };
    class Watched extends Own {
      constructor(...given: ConstructorParameters<typeof Worker>) {
        super(...given);
        workers.push(this);
      }
    }
    Object.assign(window, { Worker: Watched, kill });
  });
  return () => page.evaluate(() => (window as unknown as { kill: () => void }).kill());
}

test('tracers that die are noticed; what was traced stays, and it can be traced again', async ({
  page,
}) => {
  const kill = await mortal(page);
  await page.goto('./#/picture?scene=hundred&method=exact&size=960x540');
  await page.locator('[data-trace="tracing"]').waitFor();
  await kill();
  await expect(page.locator('.picture-status')).toContainText('ended without a word');
  await page.getByRole('button', { name: 'Trace again' }).click();
  await page.locator('[data-trace="tracing"]').waitFor();
  await page.getByRole('button', { name: 'Cancel' }).click();
  // Workers that the page ends itself are no deaths.
  await expect(page.locator('.picture-status')).toContainText('cancelled');
});

test('a laboratory that dies is noticed, and keeps what it has counted', async ({ page }) => {
  const kill = await mortal(page);
  await page.goto('./#/accuracy?shape=cone');
  await page.locator('.measure-progress:not([value="0"])').waitFor();
  await kill();
  await expect(page.locator('.measure-words')).toContainText('ended without a word');
  await expect(page.getByRole('button', { name: /^Measure/ })).toBeVisible();
});
