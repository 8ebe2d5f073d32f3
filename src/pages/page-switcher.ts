import { html, render, type TemplateResult } from 'lit';
import type { AppState, PageId } from '../state/state.ts';
import { late, notLoaded } from '../ui/late.ts';
import { SINGLE_PAGES } from './late-pages.ts';
import type { MountPage, PageContext, PageView } from './page.ts';

/** Loading that takes longer than this is said. */
const PATIENCE_MS = 300;
/** After this long the request may be lost. */
const LONG_MS = 15_000;

/** The code of each page but Explore, loaded when the page is first shown. */
const LATE_PAGES: Readonly<Partial<Record<PageId, () => Promise<MountPage>>>> = {
  ...SINGLE_PAGES,
  lesson: () =>
    late(() => import('./lesson/lesson-page.ts')).then(({ mountLesson }) => mountLesson),
};

interface PageSwitcher {
  /** Shows the page of this state, and draws it. */
  show(state: AppState): void;
  /** Asks again for the page that is shown, if its code did not come. */
  again(): void;
  /** The page that lies there, if its code has arrived; Explore is not among them. */
  current(): PageView | null;
}

interface PageSwitcherTools extends PageContext {
  /** Draws Explore into the element that it got at first. */
  readonly explore: { mount(host: HTMLElement): void; render(state: AppState): void };
  /** A page's code has arrived; its settings have not been read yet. */
  readonly arrived: (view: PageView) => void;
}

/**
 * One page at a time is in the document. The others are kept as they were left, out of it, so that
 * coming back to a measurement or a picture finds it, and each quantity stands in the document
 * once.
 */
export function createPageSwitcher(main: HTMLElement, tools: PageSwitcherTools): PageSwitcher {
  const hosts = new Map<PageId, HTMLElement>();
  const views = new Map<PageId, PageView>();
  /** Pages whose code did not come, each with a way to ask for it again. */
  const failed = new Map<PageId, () => void>();
  let shown: PageId | null = null;

  const place = (page: PageId): void => {
    if (shown !== null) views.get(shown)?.rest?.();
    shown = page;
    const known = hosts.get(page);
    const host = known ?? document.createElement('div');
    hosts.set(page, host);
    main.replaceChildren(host);
    if (!known) mount(page, host);
    else failed.get(page)?.();
  };

  const mount = (page: PageId, host: HTMLElement): void => {
    const code = LATE_PAGES[page];
    if (code) load(page, code, host);
    else tools.explore.mount(host);
  };

  const load = (page: PageId, code: () => Promise<MountPage>, host: HTMLElement): void => {
    const notice = document.createElement('div');
    notice.className = 'page-waiting';
    host.replaceChildren(notice);
    const put = (words: TemplateResult): void => {
      render(words, notice);
    };
    const again = (): void => load(page, code, host);
    const timers = [
      setTimeout(() => put(html`<p role="status">loading…</p>`), PATIENCE_MS),
      setTimeout(() => put(notLoaded('This page has not come yet.', again)), LONG_MS),
    ];
    const settled = (): void => {
      for (const timer of timers) clearTimeout(timer);
    };
    failed.delete(page);
    code().then(
      (mountPage) => {
        settled();
        // What was asked for twice comes twice.
        if (views.has(page)) return;
        host.replaceChildren();
        const view = mountPage(host, tools);
        views.set(page, view);
        if (shown === page) tools.arrived(view);
        tools.changed();
      },
      () => {
        settled();
        failed.set(page, again);
        put(notLoaded('This page could not be loaded.', again));
      },
    );
  };

  return {
    show(state) {
      if (state.page !== shown) place(state.page);
      if (LATE_PAGES[state.page]) views.get(state.page)?.render(state);
      else tools.explore.render(state);
    },
    again: () => {
      if (shown !== null) failed.get(shown)?.();
    },
    current: () => (shown === null ? null : (views.get(shown) ?? null)),
  };
}
