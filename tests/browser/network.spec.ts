import { SHAPES } from '../../src/math/index.ts';
import { pickShape, slider } from './support/controls.ts';
import { open, settle } from './support/page.ts';
import { expect, test } from './support/test.ts';

test.use({ viewport: { width: 940, height: 700 } });

test('a tour asks its own origin only, and offends neither console nor policy', async ({
  page,
  baseURL,
}) => {
  const asked: string[] = [];
  const answers: number[] = [];
  page.on('request', (request) => {
    if (!/^(data|blob):/.test(request.url())) asked.push(request.url());
  });
  page.on('response', (response) => answers.push(response.status()));
  await page.addInitScript(() => {
    const offences: string[] = [];
    Object.assign(globalThis, { offences });
    document.addEventListener('securitypolicyviolation', (event) => {
      offences.push(`${event.violatedDirective} ${event.blockedURI}`);
    });
  });
  await open(page, '#/explore?shape=cone');
  await page.locator('canvas').waitFor();
  for (const { title } of SHAPES) {
    await pickShape(page, title);
    await slider(page, 'E.y').press('ArrowRight');
  }
  for (const view of ['top', 'front', 'side', 'along ray', 'iso']) {
    await page.locator('.scene-views button', { hasText: view }).dispatchEvent('click');
    await settle(page);
  }
  for (let i = 0; i < 4; i++) await page.getByRole('button', { name: /^Theme/ }).click();
  await page.locator('.value').first().click();
  await settle(page);
  expect(asked.length).toBeGreaterThan(3);
  expect(asked.filter((url) => !url.startsWith(baseURL ?? 'none'))).toEqual([]);
  expect(answers.filter((status) => status >= 400)).toEqual([]);
  const offences = await page.evaluate(
    () => (globalThis as unknown as { offences: string[] }).offences,
  );
  expect(offences).toEqual([]);
});

test.describe('the policy', () => {
  test.use({ provoked: /Content Security Policy/ });
  test('forbids what is not the page itself, and is not only written down', async ({ page }) => {
    await open(page, '#/explore');
    const policy = page.locator('meta[http-equiv="Content-Security-Policy"]');
    await expect(policy).toHaveAttribute('content', /default-src 'none'/);
    await expect(policy).toHaveAttribute('content', /script-src 'self'(;|$)/);
    await expect(policy).toHaveAttribute('content', /connect-src 'self'(;|$)/);
    await expect(policy).not.toHaveAttribute('content', /unsafe/);
    const ran = await page.evaluate(() => {
      const script = document.createElement('script');
      script.textContent = 'globalThis.broken = 1';
      document.body.append(script);
      return 'broken' in globalThis;
    });
    expect(ran).toBe(false);
  });
});
