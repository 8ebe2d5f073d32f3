import { html, type TemplateResult } from 'lit';
import type { Dispatch } from '../state/actions.ts';
import type { ExploreModel } from '../state/derive.ts';
import type { ShownExample } from '../state/example.ts';
import type { PageId } from '../state/state.ts';
import { copyText } from '../ui/clipboard.ts';
import { createDialog } from '../ui/dialog.ts';
import { download } from '../ui/files.ts';
import { notLoaded } from '../ui/late.ts';
import type { Command, PageActions } from './commands.ts';
import { derivationWalk, stepByKey, stepsOf } from './derivation-walk.ts';
import { type ExportItem, exportContent } from './export-dialog.ts';
import { galleryContent, type Thumbnail } from './gallery.ts';
import { helpContent } from './help.ts';

export interface DialogParts {
  readonly commands: readonly Command[];
  /** Draws small pictures, once the scene's code is there. */
  readonly thumbnail: () => Thumbnail | null;
  readonly example: () => ShownExample | null;
  /** Whether the results are hidden: then no card tells them. */
  readonly hidden: () => boolean;
  readonly page: () => PageId;
  /** What Explore shows now. */
  readonly explored: () => ExploreModel;
  readonly exports: () => Promise<readonly ExportItem[]>;
  readonly dispatch: Dispatch;
  readonly tools: PageActions;
  readonly say: (words: string) => void;
  readonly keys: { get(): boolean; set(on: boolean): void };
}

export type Dialogs = Readonly<Record<'gallery' | 'derivation' | 'help' | 'export', () => void>>;

/** The dialogs of the page, each opened by its command. */
export function createDialogs(parts: DialogParts): Dialogs {
  const gallery = createDialog('Examples', () =>
    galleryContent(parts.example(), pick, parts.thumbnail(), parts.hidden(), () => gallery.close()),
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
    gallery: gallery.open,
    derivation: walkDialog(parts),
    help: help.open,
    export: exportDialog(parts),
  };
}

/** Opens where it was left, as long as there are so many steps. */
function walkDialog({ explored }: DialogParts): () => void {
  let at = 0;
  let last = 0;
  const go = (to: number): void => {
    at = Math.max(0, Math.min(to, last));
    dialog.refresh();
    // On a narrow screen the walk is longer than its dialog.
    document.querySelector('.walk-step.present')?.scrollIntoView({ block: 'nearest' });
  };
  const content = (): TemplateResult => {
    const model = explored();
    const steps = stepsOf(model);
    last = steps.length - 1;
    at = Math.min(at, last);
    return derivationWalk(model, { steps, at, go });
  };
  const dialog = createDialog('The derivation, step by step', content, (event) => {
    const to = stepByKey(event, at, last);
    if (to === null) return;
    event.preventDefault();
    go(to);
  });
  return dialog.open;
}

function exportDialog({ exports, tools, say }: DialogParts): () => void {
  let items: readonly ExportItem[] | 'loading' | 'failed' = 'loading';
  const content = (): TemplateResult => {
    if (items === 'loading') return html`<p role="status">loading…</p>`;
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
    print: close(() => window.print()),
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
