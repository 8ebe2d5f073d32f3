import { html, render, type TemplateResult } from 'lit';
import './dialog.css';

interface Dialog {
  open(): void;
  close(): void;
  readonly isOpen: boolean;
  /** Renders the content again if the dialog is open. */
  refresh(): void;
}

/**
 * A modal dialog. Its content is created when it opens, so a closed dialog costs nothing. `key` is
 * called for each key press in it, wherever the focus is; `closed` whenever it has been closed.
 */
export function createDialog(
  title: string,
  content: () => TemplateResult,
  key: (event: KeyboardEvent) => void = () => {},
  closed: () => void = () => {},
): Dialog {
  const element = document.createElement('dialog');
  element.className = 'dialog';
  element.setAttribute('aria-label', title);
  document.body.append(element);
  element.addEventListener('keydown', key);
  element.addEventListener('close', closed);
  element.addEventListener('click', (event) => {
    // A click on the backdrop has the dialog itself as its target.
    if (event.target === element) element.close();
  });
  const draw = (): void => {
    render(
      html`<div class="dialog-body">
        <header class="dialog-head">
          <h2>${title}</h2>
          <button type="button" class="button" @click=${() => element.close()}>Close</button>
        </header>
        ${content()}
      </div>`,
      element,
    );
  };
  return {
    open() {
      if (element.open) return;
      draw();
      element.showModal();
    },
    close: () => element.close(),
    get isOpen() {
      return element.open;
    },
    refresh() {
      if (element.open) draw();
    },
  };
}
