import { type BrowserContext, test as base, expect, type Page } from '@playwright/test';
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
  /** What a test provokes on purpose and may therefore appear on the console. */
  provoked: RegExp | null;
  /** Everything that went wrong so far; a test may look at it before its end. */
  complaints: string[];
}

interface Kept {
  /** The file, and what of its options a context cannot change. */
  key: string;
  page: Page | null;
}

async function prepare(
  context: BrowserContext,
  { ink, idle }: Pick<Strict, 'ink' | 'idle'>,
): Promise<void> {
  await context.addInitScript(countPending);
  await context.addInitScript(keepSaid);
  if (!ink) await context.addInitScript(withoutInk);
  if (!idle) await context.addInitScript(neverIdle);
}

/**
 * Every test fails on an error or warning on the console, an uncaught error, a dialog, and on any
 * request that leaves the page's own origin.
 */
export const test = base.extend<Strict, { kept: Kept }>({
  // Also where it is not used: tests with other fixtures of a worker get a worker and a browser of
  // their own, which takes longer than a visit.
  kept: [
    async ({ browser: _ }, use) => {
      const kept: Kept = { key: '', page: null };
      await use(kept);
      await kept.page?.context().close();
    },
    { scope: 'worker' },
  ],
  provoked: [null, { option: true }],
  ink: [false, { option: true }],
  idle: [false, { option: true }],
  context: async ({ context, ink, idle }, use) => {
    await prepare(context, { ink, idle });
    await use(context);
  },
  complaints: [
    async ({ context, baseURL, provoked }, use) => {
      const complaints: string[] = [];
      const complain = (text: string): void => {
        if (!DRIVER_REMARK.test(text) && !provoked?.test(text)) complaints.push(text);
      };
      context.on('console', (message) => {
        if (message.type() === 'error' || message.type() === 'warning') complain(message.text());
      });
      context.on('weberror', (error) => complain(String(error.error())));
      context.on('dialog', (dialog) => {
        complain(`dialog: ${dialog.message()}`);
        void dialog.dismiss();
      });
      context.on('request', (request) => {
        const own = [baseURL ?? '', 'data:', 'blob:', 'file:'];
        if (!own.some((start) => request.url().startsWith(start))) {
          complain(`request to ${request.url().slice(0, 200)}`);
        }
      });
      await use(complaints);
      for (const event of ['console', 'weberror', 'dialog', 'request'] as const) {
        await context.removeAllListeners(event);
      }
      expect(complaints, 'the console, errors, dialogs and foreign requests').toEqual([]);
    },
    { auto: true },
  ],
});

/**
 * As `test`, but the tests of a file have the same page, one after another: a visit takes more
 * time than most of what is done there. A link says anew what is shown; storage, media, mouse,
 * focus and routes are put back here. What is left is undo, a kept ray, hidden results, answers
 * that were given, numbers of shapes that were left, and a scene that was kept away: a test ends
 * what it began of these, and lets go of the keys that it holds. The file says
 * `test.describe.configure({ mode: 'default' })`.
 */
export const visit = test.extend({
  context: async ({ browser, kept, ink, idle, hasTouch, isMobile, permissions }, use, info) => {
    const key = JSON.stringify([info.file, ink, idle, hasTouch, isMobile, permissions]);
    if (kept.key !== key) {
      await kept.page?.context().close();
      kept.page = null;
      const context = await browser.newContext();
      await prepare(context, { ink, idle });
      kept.page = await context.newPage();
      kept.key = key;
    }
    await use((kept.page as Page).context());
  },
  page: async ({ context: _, kept, viewport }, use) => {
    const page = kept.page as Page;
    if (viewport) await page.setViewportSize(viewport);
    await use(page);
    await page.unrouteAll();
    await page.emulateMedia({ media: null, colorScheme: null, reducedMotion: null });
    await page.mouse.up();
    await page.mouse.move(0, 0);
    await page.evaluate(() => {
      (document.activeElement as HTMLElement | null)?.blur();
      scrollTo(0, 0);
      localStorage.clear();
      (window as unknown as { readonly said: string[] }).said.length = 0;
    });
  },
});
