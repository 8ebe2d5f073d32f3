import type { AppState, PageId } from '../state/state.ts';
import { LATER, type MountPage, type PageContext, type PageView } from './page.ts';

/** Loading that takes longer than this is said. */
const PATIENCE_MS = 300;

export interface Desk {
  /** Puts the page of this state on the desk, and draws it. */
  show(state: AppState): void;
  /** The page that lies there, if its code has arrived; Explore is not among them. */
  current(): PageView | null;
}

export interface DeskTools extends PageContext {
  /** Draws Explore into the element that it got at first. */
  readonly explore: { mount(host: HTMLElement): void; render(state: AppState): void };
  /** A page's code has arrived; its settings have not been read yet. */
  readonly arrived: (view: PageView) => void;
}

/**
 * One page at a time is in the document. The others are kept as they were left, out of it, so that coming back to a
 * measurement or a picture finds it, and each quantity stands in the document once.
 */
export function createDesk(main: HTMLElement, tools: DeskTools): Desk {
  const hosts = new Map<PageId, HTMLElement>();
  const views = new Map<PageId, PageView>();
  let shown: PageId | null = null;

  const place = (page: PageId): void => {
    if (shown !== null) views.get(shown)?.rest?.();
    shown = page;
    const known = hosts.get(page);
    const host = known ?? document.createElement('div');
    hosts.set(page, host);
    main.replaceChildren(host);
    if (!known) mount(page, host);
  };

  const mount = (page: PageId, host: HTMLElement): void => {
    const code = LATER[page];
    if (code) load(page, code, host);
    else tools.explore.mount(host);
  };

  const load = (page: PageId, code: () => Promise<MountPage>, host: HTMLElement): void => {
    const notice = document.createElement('p');
    notice.className = 'page-waiting';
    notice.setAttribute('role', 'status');
    host.append(notice);
    const waiting = setTimeout(() => {
      notice.textContent = 'loading…';
    }, PATIENCE_MS);
    code().then(
      (mountPage) => {
        clearTimeout(waiting);
        notice.remove();
        const view = mountPage(host, tools);
        views.set(page, view);
        if (shown === page) tools.arrived(view);
        tools.changed();
      },
      () => {
        clearTimeout(waiting);
        hosts.delete(page);
        notice.textContent = 'This page could not be loaded. Choose it again to try once more.';
      },
    );
  };

  return {
    show(state) {
      if (state.page !== shown) place(state.page);
      if (LATER[state.page]) views.get(state.page)?.render(state);
      else tools.explore.render(state);
    },
    current: () => (shown === null ? null : (views.get(shown) ?? null)),
  };
}
