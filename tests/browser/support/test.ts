import {
  type Browser,
  test as base,
  type ConsoleMessage,
  type Dialog,
  type Disposable,
  expect,
  type Page,
  type Request,
  type WebError,
} from '@playwright/test';
import { countPending, keepSaid } from './pending.ts';

export { expect };

/** The software GL driver's remark on its own speed when a test takes a screenshot. */
const DRIVER_REMARK =
  /^\[\.WebGL-0x[0-9a-f]+\] ?GL Driver Message \(OpenGL, Performance, \w+, High\): GPU stall/;

/**
 * Software rendering takes most of a test's time. Where nobody looks at the pixels, the scene does
 * all but fill triangles: it is loaded, lays out, counts its frames and moves its handles.
 */
function withoutInk(): void {
  const { prototype } = WebGL2RenderingContext;
  for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced'])
    Object.defineProperty(prototype, name, { value: () => undefined });
}

/**
 * Accuracy measures by itself once the browser has nothing else to do, which is seconds of work:
 * where nobody looks at what it measures the browser is never idle.
 */
function neverIdle(): void {
  Object.assign(window, { requestIdleCallback: () => 0 });
}

interface Strict {
  /** Whether the canvas of the scene is filled. */
  ink: boolean;
  /** Whether the browser is idle at times, so that Accuracy measures by itself. */
  idle: boolean;
  /** Whether the host sends headers that give the page a process of its own. */
  isolated: boolean;
  /** What a test provokes on purpose and may therefore appear on the console. */
  provoked: RegExp | null;
  /** Everything that went wrong so far; a test may look at it before its end. */
  complaints: string[];
}

/** What a context cannot change once it is there. */
interface Fixed {
  readonly baseURL: string | undefined;
  readonly hasTouch: boolean;
  readonly isMobile: boolean;
}

/** A page that tests have, one after another. */
interface Kept {
  readonly page: Page;
  readonly origin: string;
  /** Whose it is; empty where nothing is on it. */
  visit: string;
  /** What runs before the scripts of each document, as long as this visit lasts. */
  readonly scripts: Disposable[];
  /** Whether something has been done to it that cannot be taken back. */
  isSpoiled: boolean;
}

/**
 * The pages of a worker. In a page that is kept the browser has the site's files, and what it
 * made of the scripts: a load takes half of the processor time that it takes in a new context. To
 * the next visit a page is as new: `tests/browser/kept.spec.ts` holds it.
 */
class Visits {
  readonly #browser: Browser;
  readonly #kept = new Map<string, Kept>();

  constructor(browser: Browser) {
    this.#browser = browser;
  }

  /** The page for this visit; `begin` is called when it is new to it. */
  async arrive(fixed: Fixed, visit: string, begin: (kept: Kept) => Promise<void>): Promise<Kept> {
    const key = JSON.stringify(fixed);
    for (const [other, kept] of this.#kept) {
      if (other === key && kept.visit === visit) continue;
      // Beside a second context the browser starts a process for each load.
      if (other !== key) kept.isSpoiled = true;
      if (!(await leave(kept))) this.#kept.delete(other);
    }
    const kept = this.#kept.get(key) ?? (await this.#open(fixed));
    this.#kept.set(key, kept);
    if (kept.visit !== visit) await begin(kept);
    kept.visit = visit;
    return kept;
  }

  async #open({ baseURL = '' }: Fixed): Promise<Kept> {
    const context = await this.#browser.newContext();
    await context.addInitScript(countPending);
    await context.addInitScript(keepSaid);
    const page = await context.newPage();
    const { origin } = new URL(baseURL);
    // Only of Chromium is known how to make a page as new.
    const isSpoiled = this.#browser.browserType().name() !== 'chromium';
    const kept: Kept = { page, origin, visit: '', scripts: [], isSpoiled };
    const spoil = (): void => {
      kept.isSpoiled = true;
    };
    page.on('close', spoil);
    page.on('crash', spoil);
    // Another origin has storage of its own.
    context.on('request', (request) => {
      const url = request.url();
      if (!/^(?:data|blob):/.test(url) && !url.startsWith(`${origin}/`)) spoil();
    });
    const { addInitScript } = page;
    page.addInitScript = async (...given: Parameters<typeof addInitScript>) => {
      const script = await addInitScript.apply(page, given);
      kept.scripts.push(script);
      return script;
    };
    const { clock } = page;
    const { install } = clock;
    clock.install = (...given: Parameters<typeof install>) => {
      spoil();
      return install.apply(clock, given);
    };
    return kept;
  }

  async close(): Promise<void> {
    for (const { page } of this.#kept.values()) await page.context().close();
  }
}

const ends = new WeakMap<Page, (() => Promise<void>)[]>();

/** What is to be done at the end of this page's test. */
export function atEnd(page: Page, undo: () => Promise<void>): void {
  ends.set(page, [...(ends.get(page) ?? []), undo]);
}

/** Puts back all that a visit may have changed; false if its page had to be closed. */
async function leave({ page, origin, scripts, isSpoiled }: Kept): Promise<boolean> {
  const context = page.context();
  if (isSpoiled) {
    await context.close();
    return false;
  }
  for (const other of context.pages()) if (other !== page) await other.close();
  await page.unrouteAll();
  await context.unrouteAll();
  for (const script of scripts.splice(0)) await script.dispose();
  if (page.url() !== 'about:blank') {
    await page.evaluate(() => {
      sessionStorage.clear();
      window.name = '';
    });
  }
  await page.goto('about:blank');
  await context.clearCookies();
  await context.clearPermissions();
  const browser = await context.newCDPSession(page);
  await browser.send('Storage.clearDataForOrigin', { origin, storageTypes: 'all' });
  await browser.send('Page.resetNavigationHistory');
  await browser.detach();
  for (const key of ['Shift', 'Control', 'Alt', 'Meta']) await page.keyboard.up(key);
  await atRest(page);
  return true;
}

/** What a test sets beside its page. */
async function atRest(page: Page): Promise<void> {
  await page.emulateMedia({ media: null, colorScheme: null, reducedMotion: null });
  await page.mouse.up();
  await page.mouse.move(0, 0);
}

/**
 * Every test fails on an error or warning on the console, an uncaught error, a dialog, and on any
 * request that leaves the page's own origin.
 */
export const test = base.extend<Strict & { whose: string; kept: Kept }, { visits: Visits }>({
  visits: [
    async ({ browser }, use) => {
      const visits = new Visits(browser);
      await use(visits);
      await visits.close();
    },
    { scope: 'worker' },
  ],
  provoked: [null, { option: true }],
  ink: [false, { option: true }],
  idle: [false, { option: true }],
  isolated: [Boolean(process.env.LONG), { option: true }],
  baseURL: async ({ baseURL, isolated }, use) => {
    await use(isolated ? process.env.E2E_ISOLATED : baseURL);
  },
  // biome-ignore lint/correctness/noEmptyPattern: Playwright reads from it which fixtures are used.
  whose: async ({}, use, { testId, repeatEachIndex }) => use(`${testId} ${repeatEachIndex}`),
  kept: async (
    { visits, whose, baseURL, hasTouch, isMobile, ink, idle, permissions, viewport },
    use,
  ) => {
    const visit = JSON.stringify([whose, ink, idle, permissions]);
    const kept = await visits.arrive({ baseURL, hasTouch, isMobile }, visit, async (begun) => {
      const context = begun.page.context();
      if (permissions) await context.grantPermissions(permissions);
      if (!ink) begun.scripts.push(await context.addInitScript(withoutInk));
      if (!idle) begun.scripts.push(await context.addInitScript(neverIdle));
    });
    if (viewport) await kept.page.setViewportSize(viewport);
    await use(kept);
  },
  context: async ({ kept }, use) => use(kept.page.context()),
  page: async ({ kept: { page } }, use) => {
    await use(page);
    if (!page.isClosed()) for (const undo of ends.get(page) ?? []) await undo();
    ends.delete(page);
  },
  complaints: [
    async ({ context, baseURL, provoked }, use) => {
      const complaints: string[] = [];
      const complain = (text: string): void => {
        if (!DRIVER_REMARK.test(text) && !provoked?.test(text)) complaints.push(text);
      };
      const onConsole = (message: ConsoleMessage): void => {
        if (message.type() === 'error' || message.type() === 'warning') complain(message.text());
      };
      const onError = (error: WebError): void => complain(String(error.error()));
      const onDialog = (dialog: Dialog): void => {
        complain(`dialog: ${dialog.message()}`);
        void dialog.dismiss();
      };
      const onRequest = (request: Request): void => {
        const own = [baseURL ?? '', 'data:', 'blob:', 'file:'];
        if (!own.some((start) => request.url().startsWith(start))) {
          complain(`request to ${request.url().slice(0, 200)}`);
        }
      };
      context.on('console', onConsole);
      context.on('weberror', onError);
      context.on('dialog', onDialog);
      context.on('request', onRequest);
      await use(complaints);
      context.off('console', onConsole);
      context.off('weberror', onError);
      context.off('dialog', onDialog);
      context.off('request', onRequest);
      expect(complaints, 'the console, errors, dialogs and foreign requests').toEqual([]);
    },
    { auto: true },
  ],
});

/**
 * As `test`, but the tests of a file have the same visit, one after another: a load takes more
 * time than most of what is done there. A link says anew what is shown; storage, media, mouse,
 * focus and routes are put back here. What is left is undo, a kept ray, hidden results, answers
 * that were given, numbers of shapes that were left, and a scene that was kept away: a test ends
 * what it began of these, and lets go of the keys that it holds. The file says
 * `test.describe.configure({ mode: 'default' })`.
 */
export const visit = test.extend({
  // biome-ignore lint/correctness/noEmptyPattern: Playwright reads from it which fixtures are used.
  whose: async ({}, use, { file }) => use(file),
  page: async ({ page }, use) => {
    await use(page);
    await page.unrouteAll();
    await atRest(page);
    await page.evaluate(() => {
      (document.activeElement as HTMLElement | null)?.blur();
      scrollTo(0, 0);
      localStorage.clear();
      (window as unknown as { readonly said: string[] }).said.length = 0;
    });
  },
});
