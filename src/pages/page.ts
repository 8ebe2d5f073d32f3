import type { Dispatch } from '../state/actions.ts';
import type { AppState, Settings } from '../state/state.ts';
import type { Announce } from '../ui/announcer.ts';
import type { ExportItem } from './export-dialog.ts';

/**
 * Makes a page other than Explore. A page is an entry in PAGES (state/state.ts) and one in
 * SINGLE_PAGES (lazy-pages.ts); its code is a chunk of its own. Its link carries its settings:
 * texts under keys, which the page reads and checks itself. It changes them by the action
 * 'settings'; null sets a key to its default, which is left out of the link. What is lost with the
 * page (hover, results of a measurement, a picture) it keeps in closures; it calls `changed` to be
 * drawn again.
 */
export type MountPage = (host: HTMLElement, context: PageContext) => PageView;

export interface PageContext {
  readonly dispatch: Dispatch;
  /** Asks for `render` in the next animation frame. */
  readonly changed: () => void;
  /** Words beside the header's buttons for a moment: what was just done. */
  readonly say: (words: string) => void;
  /** Words for screen readers, after a pause: the value first, the consequence second. */
  readonly announce: Announce;
}

export interface PageView {
  /** Draws the page. Settings that `read` would drop get their defaults. */
  render(state: AppState): void;
  /** The valid settings of a link, and messages that quote the others. */
  read(settings: Settings): Readable;
  /** The page's entries in the dialog 'File and export'. */
  exports(): readonly ExportItem[];
  /** Opens a file that is no saved state; true if the page could use it. */
  open?(text: string): boolean;
  /** How many of the questions were answered right, where the page asks. */
  score?(): { readonly right: number; readonly asked: number };
  /** Goes one step forward or back, for the keys of a clicker. */
  turn?(by: 1 | -1): void;
  /** Opens the presenter's window. */
  present?(): void;
  /** Called when another page is shown; the element is kept outside of the document. */
  rest?(): void;
}

export interface Readable {
  readonly settings: Settings;
  readonly problems: readonly string[];
}
