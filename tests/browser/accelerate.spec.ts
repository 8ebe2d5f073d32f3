import type { Page } from '@playwright/test';
import { bundle } from '../accelerated/bundle.ts';
import { ALLOWED, filesOf, typeOf } from '../accelerated/page.ts';
import type { Told } from '../accelerated/program.ts';
import { expect, test } from './support/test.ts';

/*
 * A page that has the math module in a bundle, and its worker: allowed to run WebAssembly, and
 * under a content security policy that forbids it.
 */

// What Chromium says of an attempt that the policy forbids.
test.use({ provoked: /WebAssembly/ });

const FOLDER = 'accelerated/';
async function askPage(page: Page, program: string, policy: string): Promise<Told[]> {
  const files = filesOf(program);
  await page.route(`**/${FOLDER}*`, (route) => {
    const name = new URL(route.request().url()).pathname.split('/').pop() as string;
    return route.fulfill({
      body: files[name] ?? '',
      contentType: typeOf(name),
      headers: { 'content-security-policy': policy },
    });
  });
  await page.goto(`${FOLDER}index.html`);
  await page.waitForFunction(() => 'told' in window);
  return page.evaluate(() => (window as unknown as { told: Promise<Told[]> }).told);
}

test('a page and its worker are accelerated, and under a policy say why not', async ({ page }) => {
  const program = await bundle();
  const fast = { isFast: true, why: null, isSame: true, isFound: true, isInMemory: true };
  expect(await askPage(page, program, ALLOWED)).toEqual([fast, fast]);
  await page.unrouteAll();
  for (const told of await askPage(page, program, "script-src 'self'")) {
    expect(told).toEqual({ ...fast, isFast: false, isInMemory: false, why: told.why });
    expect(told.why).toMatch(/^WebAssembly is not allowed here: .+/);
  }
});
