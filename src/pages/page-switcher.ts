import { html, render, type TemplateResult } from 'lit';
import type { AppState, PageId } from '../state/state.ts';
import { lazy, notLoaded } from '../ui/lazy.ts';
import { SINGLE_PAGES } from './lazy-pages.ts';
import type { MountPage, PageContext, PageView } from './page.ts';

/** ms after which the page says that it is being loaded. */
const PATIENCE_MS = 300;
/** ms after which the request may be lost. */
const LONG_MS = 15_000;

/** The code of each page but Explore, loaded when the page is first shown. */
const LAZY_PAGES: Readonly<Partial<Record<PageId, () => Promise<MountPage>>>> = {
  ...SINGLE_PAGES,
  lesson: () =>
    lazy(() => import('./lesson/lesson-page.ts')).then(({ mountLesson }) => mountLesson),
};

interface PageSwitcher {
  /** Shows the page of this state, and draws it. */
  show(state: AppState): void;
  /** Loads the code of the shown page again, if that failed. */
  again(): void;
  /** The shown page if its code is loaded; null for Explore. */
  current(): PageView | null;
  /** The shown page as soon as its code has come, which is loaded again if that failed. */
  arrival(): Promise<PageView | null>;
}

interface PageSwitcherTools extends PageContext {
  /** Mounts Explore into an element, and draws it there. */
  readonly explore: { mount(host: HTMLElement): void; render(state: AppState): void };
  /** Called when a page's code is loaded, before its settings are read. */
  readonly arrived: (view: PageView) => void;
}

/**
 * Keeps one page in the document, and the others outside of it as they were left: a measurement or
 * a picture is still there on return, and each quantity is in the document only once.
 */
export function createPageSwitcher(main: HTMLElement, tools: PageSwitcherTools): PageSwitcher {
  const hosts = new Map<PageId, HTMLElement>();
  const views = new Map<PageId, PageView>();
  /** Pages whose code could not be loaded, each with a function that tries again. */
  const failed = new Map<PageId, () => void>();
  const arrivals = new Map<PageId, Promise<MountPage>>();
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
    const code = LAZY_PAGES[page];
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
      setTimeout(() => put(html`<p data-say>loading…</p>`), PATIENCE_MS),
      setTimeout(() => put(notLoaded('This page has not come yet.', again)), LONG_MS),
    ];
    const settled = (): void => {
      for (const timer of timers) clearTimeout(timer);
    };
    failed.delete(page);
    const coming = code();
    coming.then(
      (mountPage) => {
        settled();
        // Code that was requested twice arrives twice.
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
    arrivals.set(page, coming);
  };

  const again = (): void => {
    if (shown !== null) failed.get(shown)?.();
  };

  return {
    show(state) {
      if (state.page !== shown) place(state.page);
      if (LAZY_PAGES[state.page]) views.get(state.page)?.render(state);
      else tools.explore.render(state);
    },
    again,
    async arrival() {
      again();
      const page = shown;
      if (page === null) return null;
      await arrivals.get(page);
      return (page === shown && views.get(page)) || null;
    },
    current: () => (shown === null ? null : (views.get(shown) ?? null)),
  };
}
