import { nothing, render, type TemplateResult } from 'lit';
import './handout.css';

export interface Handout {
  readonly content: TemplateResult;
  /** Called once the content stands in `root`: for drawings, which fill an element. */
  readonly drawn: (root: HTMLElement) => void;
}

interface PaperPage {
  /** What the page puts on paper; null while it is not shown. */
  readonly handout: () => Handout | null;
  /** Loads what is missing; resolves to false if the person cancels. */
  readonly prepare: () => Promise<boolean>;
}

const pages: PaperPage[] = [];

/**
 * From now on the page prints what `handout` returns, in place of what the screen shows; while all
 * return null, paper has what the screen has. Paper is light in every theme.
 */
export function printsAs(
  handout: PaperPage['handout'],
  prepare: PaperPage['prepare'] = async () => true,
): void {
  if (pages.length === 0) watchPrinter();
  pages.push({ handout, prepare });
}

/** Prints, once everything is there. */
export async function printPage(): Promise<void> {
  const page = pages.find(({ handout }) => handout() !== null);
  if (!page || (await page.prepare())) window.print();
}

function watchPrinter(): void {
  const root = document.documentElement;
  const paper = document.createElement('div');
  paper.className = 'handout';
  let theme: string | undefined;
  window.addEventListener('beforeprint', () => {
    theme ??= root.dataset.theme;
    root.dataset.theme = 'light';
    const shown = pages.map(({ handout }) => handout()).find((one) => one !== null);
    if (!shown) return;
    document.body.append(paper);
    root.classList.add('prints-handout');
    render(shown.content, paper);
    shown.drawn(paper);
  });
  window.addEventListener('afterprint', () => {
    if (theme !== undefined) root.dataset.theme = theme;
    theme = undefined;
    root.classList.remove('prints-handout');
    render(nothing, paper);
    paper.remove();
  });
  // The browser's own command would print without `prepare`.
  window.addEventListener(
    'keydown',
    (event) => {
      const { key, ctrlKey, metaKey, altKey, shiftKey } = event;
      if (key.toLowerCase() !== 'p' || !(ctrlKey || metaKey) || altKey || shiftKey) return;
      event.preventDefault();
      void printPage();
    },
    true,
  );
}
