import { html, type TemplateResult } from 'lit';
import { display, displayAll, shortest } from '../text/format.ts';

/** A computed number on the page: shown in six digits, carried in full by data-value; a click shows every digit. */
export function value(quantity: string, x: number, digits = 6): TemplateResult {
  return html`<button
    type="button"
    class="value"
    data-quantity=${quantity}
    data-value=${shortest(x)}
    title=${`${displayAll(x)} (click for all digits)`}
    @click=${toggleDigits}
  ><span class="short">${display(x, digits)}</span><span class="long">${displayAll(x)}</span></button>`;
}

/** Which digits are shown is the page's own affair and dies with it. */
function toggleDigits(event: Event): void {
  (event.currentTarget as HTMLElement).classList.toggle('all');
}
