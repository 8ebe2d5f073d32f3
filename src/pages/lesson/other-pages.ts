import { html, render } from 'lit';
import type { Dispatch } from '../../state/actions.ts';
import type { AppState, PageId } from '../../state/state.ts';
import { notLoaded } from '../../ui/lazy.ts';
import { SINGLE_PAGES } from '../lazy-pages.ts';
import type { PageContext, PageView } from '../page.ts';
import './other-pages.css';

/**
 * The other pages as steps of a lesson: each is mounted once, with the lesson's own dispatch, and
 * one at a time is in the document.
 */
export function createOtherPages(host: HTMLElement, context: PageContext, dispatch: Dispatch) {
  const hosts = new Map<PageId, HTMLElement>();
  const views = new Map<PageId, PageView>();
  let shown: PageId | null = null;

  const load = (page: PageId, place: HTMLElement): void => {
    const code = SINGLE_PAGES[page];
    render(html`<p data-say>loading…</p>`, place);
    code?.().then(
      (mountPage) => {
        render(html``, place);
        const own = document.createElement('div');
        place.replaceChildren(own);
        views.set(page, mountPage(own, { ...context, dispatch }));
        context.changed();
      },
      () =>
        render(
          notLoaded('This page could not be loaded.', () => load(page, place)),
          place,
        ),
    );
  };

  const rest = (): void => {
    if (shown !== null) views.get(shown)?.rest?.();
  };

  return {
    /** Shows the whole page, or one part of it alone. */
    render(state: AppState, part: string | null): void {
      if (shown !== state.page) {
        rest();
        shown = state.page;
        let place = hosts.get(state.page);
        if (!place) {
          place = document.createElement('div');
          hosts.set(state.page, place);
          load(state.page, place);
        }
        host.replaceChildren(place);
      }
      views.get(state.page)?.render(state);
      for (const element of host.querySelectorAll<HTMLElement>('[data-part]')) {
        const isShown = part === null || element.dataset.part?.split(' ').includes(part);
        element.toggleAttribute('data-elsewhere', !isShown);
      }
    },
    /** Removes the page, when a step shows Explore. */
    leave(): void {
      rest();
      shown = null;
      host.replaceChildren();
    },
    exports: () => (shown === null ? [] : (views.get(shown)?.exports() ?? [])),
  };
}
