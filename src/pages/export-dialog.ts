import { html, type TemplateResult } from 'lit';
import './export-dialog.css';

/** One export: something that can be copied or saved. */
export interface ExportItem {
  readonly id: string;
  readonly title: string;
  readonly file: string;
  readonly type: string;
  /** Text can be copied as well as saved; a picture is only saved. */
  readonly text: (() => string) | null;
  readonly blob: (() => Promise<Blob | null>) | null;
}

interface ExportActions {
  readonly copy: (item: ExportItem) => void;
  readonly saveItem: (item: ExportItem) => void;
  readonly save: () => void;
  readonly openFile: () => void;
  readonly print: () => void;
  readonly embed: () => void;
}

/** The content of the dialog: the state as a file, and the exports. */
export function exportContent(
  items: readonly ExportItem[],
  actions: ExportActions,
): TemplateResult {
  return html`<div class="exports">
    <p class="exports-state">
      <button type="button" class="button primary" @click=${actions.save}>Save state</button>
      <button type="button" class="button" @click=${actions.openFile}>Open a file</button>
      <button type="button" class="button" @click=${actions.print}>Print</button>
      <button type="button" class="button" @click=${actions.embed}>Embed in a page</button>
      <span>A saved state can also be dropped on the page.</span>
    </p>
    <table>
      <tbody>
        ${items.map(
          (item) => html`<tr data-export=${item.id}>
            <th scope="row">${item.title}</th>
            <td>${
              item.text
                ? html`<button type="button" class="button"
              aria-label=${`Copy ${item.title}`}
                @click=${() => actions.copy(item)}>Copy</button>`
                : ''
            }</td>
            <td><button type="button" class="button" aria-label=${`Save ${item.title}`}
              @click=${() => actions.saveItem(item)}>Save</button></td>
          </tr>`,
        )}
      </tbody>
    </table>
  </div>`;
}
