import type { Locator, Page, Route } from '@playwright/test';
import { type Command, commandsOf } from '../../src/pages/commands.ts';
import { PAGES } from '../../src/state/state.ts';
import { share } from '../unit/many.ts';
import { linkWritten, open, quantities, withoutScene } from './support/page.ts';
import { withoutPause } from './support/pending.ts';
import { expect, test } from './support/test.ts';

/* What failed to load is fetched again when it is asked for again. */

test.use({ provoked: /Failed to load resource|Failed to fetch dynamically imported module/ });

/** Keeps files away while `is` is true. */
async function away(page: Page, files: RegExp): Promise<{ is: boolean }> {
  const kept = { is: true };
  await page.route(files, (route) => (kept.is ? route.abort() : route.continue()));
  return kept;
}

const tab = (page: Page, name: string) => page.getByRole('link', { name, exact: true });

test('a page, its style sheet, its picture and its graph', async ({ page }) => {
  const code = await away(page, /\/check-[^/]*\.js$/);
  const style = await away(page, /\/check-[^/]*\.css$/);
  const scene = await away(page, /\/scene-[^/]*\.js$/);
  const graph = await away(page, /\/charts-[^/]*\.js$/);
  await page.goto('./#/explore');
  const [ofScene, ofGraph] = ['.scene-host', '.graph-host'].map((host) =>
    page.locator(`${host} .view-waiting`),
  ) as [Locator, Locator];
  await expect(ofScene).toContainText('The picture could not be loaded');
  await expect(ofGraph).toContainText('The plot could not be loaded');
  expect(await quantities(page)).toMatchObject({ class: /./ });
  await tab(page, 'Check').click();
  const notice = page.locator('.page-waiting');
  await expect(notice).toContainText('could not be loaded');
  await expect(notice.getByRole('button', { name: 'Reload Graze' })).toBeVisible();
  // The same tab: its address does not change.
  code.is = false;
  await tab(page, 'Check').click();
  await expect(notice).toContainText('could not be loaded');
  style.is = false;
  await notice.getByRole('button', { name: 'Try again' }).click();
  await expect(page.getByRole('heading', { name: /Question 1/ })).toBeVisible();
  await expect(page.locator('.check')).toHaveCSS('display', 'grid');
  await tab(page, 'Explore').click();
  scene.is = false;
  await ofScene.getByRole('button', { name: 'Try again' }).click();
  await expect(page.locator('canvas')).toBeVisible();
  graph.is = false;
  await ofGraph.getByRole('button', { name: 'Try again' }).click();
  await expect(page.locator('.graph-bead')).toBeVisible();
});

test('what can be taken away', async ({ page }) => {
  await withoutScene(page);
  const exports = await away(page, /\/exports-[^/]*\.js$/);
  await open(page, '#/explore');
  await page.getByRole('button', { name: 'File and export' }).click();
  const dialog = page.locator('dialog[open]');
  await expect(dialog).toContainText('did not come');
  exports.is = false;
  await dialog.getByRole('button', { name: 'Try again' }).click();
  await expect(dialog.getByRole('button', { name: 'Copy the derivation as LaTeX' })).toBeVisible();
});

test('without its program the page has words', async ({ page }) => {
  await away(page, /\/first-[^/]*\.js$/);
  await page.goto('./');
  await expect(page.locator('#app')).toHaveText(/reload the page/);
  await expect(page.locator('.starting')).toBeVisible();
});

/** What has been said at once, and on Explore by the voice too. */
function keepTold(): void {
  const told: string[] = [];
  Object.assign(window, { told });
  new MutationObserver(() => {
    // Of other pages the voice tells that they have come.
    const where = location.hash.startsWith('#/explore') ? '.announcer, .said' : '.said';
    for (const { textContent } of document.querySelectorAll(where))
      if (textContent && textContent !== told.at(-1)) told.push(textContent);
  }).observe(document, { subtree: true, childList: true, characterData: true });
}

/** Keeps back all code but the first, until it is let come. */
async function heldBack(page: Page): Promise<() => Promise<void>> {
  const waiting: Route[] = [];
  let isHeld = true;
  await page.unrouteAll();
  await page.route(/\/assets\/(?!first-|rolldown-runtime-)[^/]*\.js$/, (route) => {
    if (!isHeld) return route.continue();
    waiting.push(route);
    return;
  });
  return async () => {
    isHeld = false;
    await Promise.all(waiting.map((route) => route.continue()));
  };
}

const WHERE: Readonly<Record<string, string>> = {
  explore: '?shape=cone&E=4,1,0.5&d=-1,0,0',
  lesson: '/ray?step=2',
};

/** All commands; what they do is the page's. */
const COMMANDS = commandsOf({ dispatch() {}, get() {} } as never, {} as never);

const press = (page: Page, { keys }: Command) =>
  page.keyboard.press((keys[0] ?? '').replace('Ctrl', 'Control').replace(/^\?$/, 'Shift+?'));

/** Presses a command's key before any late code has come; what comes of it then. */
async function answerTo(page: Page, at: string, command: Command): Promise<string> {
  await page.goto('about:blank');
  const come = await heldBack(page);
  await page.goto(`./#/${at}${WHERE[at] ?? ''}`);
  await page.locator('header nav').waitFor();
  await linkWritten(page);
  const hash = await page.evaluate(() => location.hash);
  const browser = Promise.race([
    page.waitForEvent('filechooser').then(() => 'a file is asked for'),
    page.waitForEvent('popup').then((popup) => popup.close().then(() => 'another window')),
  ]);
  browser.catch(() => {});
  await press(page, command);
  await come();
  const seen = page.waitForFunction(
    (before) => {
      const { told } = window as unknown as { readonly told: string[] };
      const dialog = document.querySelector('dialog[open]')?.getAttribute('aria-label');
      const link = location.hash === before ? '' : location.hash;
      return told.join('|') || dialog || link;
    },
    hash,
    { timeout: 30_000 },
  );
  return Promise.race([seen.then((found) => found.jsonValue()), browser]);
}

for (const { id: at } of PAGES) {
  test(`${at}: a key that is pressed before its code has come is answered`, async ({ page }) => {
    await page.addInitScript(withoutPause);
    await page.addInitScript(keepTold);
    // What each page does itself is asked of each, what is the same on several only of one.
    const asked = COMMANDS.filter(
      ({ id, pages = ['explore'] }) => id === 'export' || pages[0] === at,
    );
    for (const command of at === 'explore' ? share(asked) : asked) {
      const answer = await answerTo(page, at, command).catch(() => '');
      expect(answer, `${command.id} on ${at}`).not.toBe('');
    }
  });
}
