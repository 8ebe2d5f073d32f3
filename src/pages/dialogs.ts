import { html, type TemplateResult } from 'lit';
import type { Dispatch } from '../state/actions.ts';
import type { ShownExample } from '../state/example.ts';
import type { AppState, PageId } from '../state/state.ts';
import { copyText } from '../ui/clipboard.ts';
import { createDialog } from '../ui/dialog.ts';
import { download } from '../ui/files.ts';
import { lazy, notLoaded } from '../ui/lazy.ts';
import type { Command, PageActions } from './commands.ts';
import { createEmbedDialog } from './embed/embed-dialog.ts';
import { type ExportItem, exportContent } from './export-dialog.ts';
import { galleryContent, type Thumbnail } from './gallery.ts';
import { printPage } from './handout/print.ts';
import { helpContent } from './help.ts';

export interface DialogParts {
  readonly commands: readonly Command[];
  readonly example: () => ShownExample | null;
  /** Whether results are hidden, so that the gallery must not show them. */
  readonly hidden: () => boolean;
  readonly page: () => PageId;
  readonly state: () => AppState;
  readonly exports: () => Promise<readonly ExportItem[]>;
  readonly dispatch: Dispatch;
  readonly tools: PageActions;
  readonly say: (words: string) => void;
  readonly keys: { get(): boolean; set(on: boolean): void };
}

export type Dialogs = Readonly<Record<'gallery' | 'help' | 'export', () => void>>;

/** The dialogs of the page, each opened by its command. */
export function createDialogs(parts: DialogParts): Dialogs {
  let thumbnail: Thumbnail | null = null;
  // Without small pictures the examples still have their names and questions.
  const drawn = (): void => {
    lazy(() => import('../canvas/thumbnail.ts')).then(
      (code) => {
        thumbnail = code.drawThumbnail;
        gallery.refresh();
      },
      () => {},
    );
  };
  const gallery = createDialog('Examples', () =>
    galleryContent(
      parts.example(),
      pick,
      thumbnail,
      parts.hidden(),
      () => gallery.close(),
      () => {
        gallery.close();
        parts.tools.present();
      },
    ),
  );
  const pick = (id: string): void => {
    parts.dispatch({ type: 'example', id });
    gallery.close();
  };
  const help = createDialog('Help', () =>
    helpContent(parts.commands, parts.page(), {
      singleKeys: parts.keys.get(),
      choose: parts.keys.set,
    }),
  );
  return {
    gallery() {
      gallery.open();
      if (!thumbnail) drawn();
    },
    help: help.open,
    export: exportDialog(parts),
  };
}

function exportDialog({ exports, tools, say, state }: DialogParts): () => void {
  const openEmbed = createEmbedDialog(state, say);
  let items: readonly ExportItem[] | 'loading' | 'failed' = 'loading';
  const content = (): TemplateResult => {
    if (items === 'loading') return html`<p data-say>loading…</p>`;
    if (items === 'failed') return notLoaded('What can be copied or saved did not come.', load);
    return exportContent(items, { copy, saveItem, ...actions });
  };
  const dialog = createDialog('File and export', content);
  const put = (next: typeof items): void => {
    items = next;
    dialog.refresh();
  };
  const load = (): void => {
    put('loading');
    exports().then(put, () => put('failed'));
  };
  const close = (act: () => void) => () => {
    dialog.close();
    act();
  };
  const actions = {
    save: close(tools.save),
    openFile: close(tools.openFile),
    print: close(() => void printPage()),
    embed: close(openEmbed),
  };
  const copy = async ({ title, text }: ExportItem): Promise<void> => {
    const copied = text !== null && (await copyText(text()));
    dialog.close();
    say(copied ? `copied: ${title}` : 'it could not be copied: save it instead');
  };
  const saveItem = async ({ file, type, text, blob, title }: ExportItem): Promise<void> => {
    const content = text ? text() : await blob?.();
    dialog.close();
    if (content) download(file, content, type);
    say(content ? `saved: ${title}` : 'there is no picture to save');
  };
  return () => {
    dialog.open();
    load();
  };
}
