import type { Page } from '@playwright/test';

/** What the page has asked the browser to call soon, and how often it has asked for a frame. */
interface Pending {
  readonly timers: Set<number>;
  readonly frames: Set<number>;
  asked: number;
  /** The browser's own, which is not counted. */
  readonly frame: typeof requestAnimationFrame;
}

/** Keeps `window.pending`, so that a test can wait for the page and not for a time. */
export function countPending(): void {
  const LONG_MS = 250;
  const { setTimeout, clearTimeout, requestAnimationFrame, cancelAnimationFrame } = window;
  const pending: Pending = {
    timers: new Set(),
    frames: new Set(),
    asked: 0,
    frame: (draw) => requestAnimationFrame(draw),
  };
  Object.assign(window, {
    pending,
    setTimeout: (run: TimerHandler, ms = 0, ...given: unknown[]): number => {
      if (typeof run !== 'function') return setTimeout(run, ms, ...given);
      const id = setTimeout(() => {
        pending.timers.delete(id);
        run(...given);
      }, ms);
      if (ms < LONG_MS) pending.timers.add(id);
      return id;
    },
    clearTimeout: (id?: number): void => {
      pending.timers.delete(id ?? 0);
      clearTimeout(id);
    },
    requestAnimationFrame: (draw: FrameRequestCallback): number => {
      const id = requestAnimationFrame((now) => {
        pending.frames.delete(id);
        draw(now);
      });
      pending.frames.add(id);
      pending.asked += 1;
      return id;
    },
    cancelAnimationFrame: (id: number): void => {
      pending.frames.delete(id);
      cancelAnimationFrame(id);
    },
  });
}

/** Keeps in `window.said` what has stood beside the header's buttons: it goes away by itself. */
export function keepSaid(): void {
  const said: string[] = [];
  Object.assign(window, { said });
  let before = '';
  new MutationObserver(() => {
    const now = document.querySelector('.said')?.textContent ?? '';
    if (now !== before && now) said.push(now);
    before = now;
  }).observe(document, { subtree: true, childList: true, characterData: true });
}

/** The pause before the voice speaks is no part of a test. */
export function withoutPause(): void {
  const { setTimeout } = window;
  const soon = (run: TimerHandler, ms?: number, ...given: unknown[]) =>
    setTimeout(run, ms === 500 ? 0 : ms, ...given);
  Object.assign(window, { setTimeout: soon });
}

interface Counted {
  readonly pending: Pending;
}

/**
 * Until the short timers that the page has now have run: the link is written by one, a moment
 * after a change. While something plays there is always a next one, which is not waited for.
 */
export async function timersDone(page: Page): Promise<void> {
  await page.evaluate(async () => {
    const { timers, frame } = (window as unknown as Counted).pending;
    const now = [...timers];
    while (now.some((id) => timers.has(id))) await new Promise<number>((done) => frame(done));
  });
}

/** Until the page asks for no frame: nothing moves any more. */
export async function framesDone(page: Page): Promise<void> {
  await page.waitForFunction(() => (window as unknown as Counted).pending.frames.size === 0);
}

/** Lets the browser draw this many frames, whether the page asks for them or not. */
export async function frames(page: Page, count: number): Promise<void> {
  await page.evaluate(async (count) => {
    const { frame } = (window as unknown as Counted).pending;
    for (let i = 0; i < count; i++) await new Promise<number>((done) => frame(done));
  }, count);
}

/** How often the page has asked for a frame. */
export async function framesAsked(page: Page): Promise<number> {
  return page.evaluate(() => (window as unknown as Counted).pending.asked);
}
