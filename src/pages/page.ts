import type { Dispatch } from '../state/actions.ts';
import type { AppState, Settings } from '../state/state.ts';
import type { ExportItem } from './export-dialog.ts';

/**
 * Makes a page other than Explore. A page is an entry in PAGES (state/state.ts) and one in
 * SINGLE_PAGES (late-pages.ts); its code is a chunk of its own. Its link carries its settings:
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
  readonly announce: (words: string) => void;
}

export interface PageView {
  /** Takes any settings: what `read` would drop has its default. */
  render(state: AppState): void;
  /**
   * What of a link's settings is usable, and what was wrong with the rest, in words that quote it.
   */
  read(settings: Settings): Readable;
  /** What can be copied or saved from here, for the dialog 'File and export'. */
  exports(): readonly ExportItem[];
  /** A file that was opened or dropped and is no saved state: true if the page took it. */
  open?(text: string): boolean;
  /** One step on or back, for the keys of a clicker. */
  turn?(by: 1 | -1): void;
  /**
   * Another page is shown; the element stays as it is, out of the document, until this one is shown
   * again.
   */
  rest?(): void;
}

export interface Readable {
  readonly settings: Settings;
  readonly problems: readonly string[];
}
