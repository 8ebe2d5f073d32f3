import type { Page } from '@playwright/test';
import { expect, test } from './support/test.ts';

/*
 * Tests have the same page, one after another, and none may see what another did: each of these
 * leaves something everywhere, and looks whether anything is there.
 */

/** All that a document can find of others, with the site's own page shown. */
async function found(page: Page): Promise<unknown> {
  await page.goto('./');
  await page.locator('[data-quantity="class"]').waitFor();
  const inside = await page.evaluate(async () => ({
    local: { ...localStorage },
    session: { ...sessionStorage },
    cookies: document.cookie,
    databases: (await indexedDB.databases()).map(({ name }) => name),
    caches: await caches.keys(),
    files: await (async () => {
      const names: string[] = [];
      const root = (await navigator.storage.getDirectory()) as unknown as {
        readonly keys: () => AsyncIterable<string>;
      };
      for await (const name of root.keys()) names.push(name);
      return names;
    })(),
    name: window.name,
    // The page that was empty, and this one.
    visited: history.length,
    granted: (await navigator.permissions.query({ name: 'geolocation' })).state,
    still: matchMedia('(prefers-reduced-motion: reduce)').matches,
    dark: matchMedia('(prefers-color-scheme: dark)').matches,
    print: matchMedia('print').matches,
    size: [innerWidth, innerHeight],
    touch: navigator.maxTouchPoints,
    script: 'left' in window,
    icon: await (await fetch('./icon.svg')).text().then((text) => text.startsWith('<svg')),
    time: Date.now() > 1.7e12,
  }));
  return { ...inside, pages: page.context().pages().length };
}

async function leaveAll(page: Page): Promise<void> {
  await page.context().grantPermissions(['geolocation']);
  await page.emulateMedia({ media: 'print', colorScheme: 'dark', reducedMotion: 'reduce' });
  await page.setViewportSize({ width: 500, height: 500 });
  await page.addInitScript(() => Object.assign(window, { left: true }));
  await page.route('**/icon.svg', (route) => route.fulfill({ body: 'another' }));
  await page.context().route('**/index.html', (route) => route.abort());
  await page.reload();
  const popup = page.waitForEvent('popup');
  await page.evaluate(async () => {
    localStorage.setItem('left', 'here');
    sessionStorage.setItem('left', 'here');
    // biome-ignore lint/suspicious/noDocumentCookie: it is what a page may leave.
    document.cookie = 'left=here; max-age=1000';
    window.name = 'left';
    history.pushState(null, '', '#/check');
    await new Promise((done) => {
      indexedDB.open('left').onsuccess = done;
    });
    await caches.open('left');
    const root = await navigator.storage.getDirectory();
    await root.getFileHandle('left', { create: true });
    open('./robots.txt');
  });
  await popup;
  await page.keyboard.down('Shift');
  await page.mouse.down();
}

const FRESH = {
  local: {},
  session: {},
  cookies: '',
  databases: [],
  caches: [],
  files: [],
  name: '',
  visited: 2,
  granted: 'prompt',
  still: false,
  dark: false,
  print: false,
  size: [1000, 800],
  touch: 0,
  script: false,
  icon: true,
  time: true,
  pages: 1,
};

test.describe.configure({ mode: 'default' });

for (const what of ['first', 'second', 'third']) {
  test(`the ${what} test finds nothing of another`, async ({ page }) => {
    expect(await found(page)).toEqual(FRESH);
    await leaveAll(page);
    expect(await found(page)).not.toEqual(FRESH);
    // What cannot be taken back closes the page.
    if (what === 'second') await page.clock.install({ time: 0 });
  });
}

test('keys and buttons that are held are let go of', async ({ page }) => {
  await page.goto('./');
  await page.evaluate(() => {
    const seen: unknown[] = [];
    Object.assign(window, { seen });
    addEventListener('mousemove', ({ shiftKey, buttons }) => seen.push(shiftKey, buttons));
  });
  await page.mouse.move(20, 20);
  await expect.poll(() => page.evaluate('seen')).toEqual([false, 0]);
});
