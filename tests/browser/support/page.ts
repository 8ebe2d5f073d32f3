import type { Locator, Page } from '@playwright/test';
import { frames, timersDone } from './pending.ts';
import { atEnd, expect } from './test.ts';

export const SCENE_CHUNK = /\/scene-[^/]*\.js$/;
/** The browser's own words when the scene is kept away. */
export const NO_SCENE = /^Failed to load resource: net::ERR_(?:FAILED|BLOCKED_BY_CLIENT)$/;

/**
 * Leaves the picture out where it is not what a test is about: software rendering would take most
 * of its time. By the browser's own list and not by a route, with which it keeps no files.
 */
export async function withoutScene(page: Page): Promise<void> {
  if (page.context().browser()?.browserType().name() !== 'chromium') {
    await page.route(SCENE_CHUNK, (route) => route.abort());
    return;
  }
  const browser = await page.context().newCDPSession(page);
  await browser.send('Network.enable');
  await browser.send('Network.setBlockedURLs', { urls: ['*/assets/scene-*.js'] });
  atEnd(page, () => browser.detach());
}

/** What went wrong, in words: below the header, and beside what was given. */
export const problems = (page: Page): Locator =>
  page.locator('[data-say="problem"]').filter({ visible: true });

export type Shown = Record<string, string>;

/**
 * Until what was asked for stands on the page: the state is drawn in the next animation frame, and
 * when the numbers of an example have arrived; a command whose code has not come yet waits for it.
 */
export async function settle(page: Page): Promise<void> {
  const is = (state: string) => page.locator(`main[data-${state}]`).waitFor({ state: 'detached' });
  await is('waiting');
  await frames(page, 2);
  await is('moving');
}

/** Until the page has written its own form of the link, which it does by a timer after a change. */
export async function linkWritten(page: Page): Promise<void> {
  await settle(page);
  await timersDone(page);
}

/**
 * Opens a link: loads the page the first time, later writes the new hash into the address as a
 * person would. The event is sent at once, so that a list of links does not have to wait for the
 * browser's own.
 */
export async function open(page: Page, hash: string): Promise<void> {
  if (page.url() === 'about:blank') {
    await page.goto(`./${hash}`);
    // Beside an open derivation it is there, but hidden.
    await page.locator('[data-quantity="class"]').waitFor({ state: 'attached' });
    await page.evaluate(() => document.fonts.ready.then(() => null));
    // The graph's code comes after the page's own, and it is drawn when its size is known.
    await page.waitForFunction(() => {
      const graph = document.querySelector('.graph');
      const isSeen = graph?.checkVisibility() && graph.clientHeight > 0;
      return graph && (!isSeen || graph.querySelector('svg, .graph-concealed'));
    });
  } else {
    await page.evaluate((next) => {
      location.hash = next;
      dispatchEvent(new HashChangeEvent('hashchange'));
    }, hash);
  }
  await settle(page);
}

/** Every quantity on the page with its full value. Throws if one stands there twice. */
export async function quantities(page: Page): Promise<Shown> {
  const pairs = await page.evaluate(() =>
    [...document.querySelectorAll('[data-quantity]')].map((element) => [
      element.getAttribute('data-quantity') ?? '',
      element.getAttribute('data-value') ?? '(no data-value)',
    ]),
  );
  const names = pairs.map(([name]) => name);
  const twice = names.filter((name, i) => names.indexOf(name) !== i);
  expect(twice, 'quantities that stand on the page more than once').toEqual([]);
  return Object.fromEntries(pairs) as Shown;
}

/** What a person can read on the page, in tooltips, and through a screen reader. */
export async function readable(page: Page): Promise<string> {
  return page.evaluate(() => {
    const spoken = ['title', 'aria-label', 'aria-valuetext', 'aria-valuenow', 'aria-valuemin'];
    const attributes = [...document.querySelectorAll('body *')].flatMap((element) =>
      spoken.map((name) => element.getAttribute(name) ?? ''),
    );
    return [document.body.innerText, ...attributes].join('\n');
  });
}

export async function hashOf(page: Page): Promise<string> {
  return page.evaluate(() => location.hash);
}

/** Until the page has said this beside its header's buttons, also if it is gone again by now. */
export async function expectSaid(page: Page, wanted: string | RegExp): Promise<void> {
  const said = () =>
    page.evaluate(() => (window as unknown as { readonly said: readonly string[] }).said.at(-1));
  await expect
    .poll(said)
    .toEqual(typeof wanted === 'string' ? wanted : expect.stringMatching(wanted));
}
