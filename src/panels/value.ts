import { html, type TemplateResult } from 'lit';
import { display, displayAll, shortest } from '../text/format.ts';

/**
 * A computed number on the page: shown in six digits, carried in full by data-value; a click shows every digit.
 * `room` is the number of characters there is space for; six digits become fewer rather than run into a neighbour.
 */
export function value(
  quantity: string,
  x: number,
  room = Number.POSITIVE_INFINITY,
): TemplateResult {
  const short = displayWithin(x, room);
  return html`<button
    type="button"
    class=${short.length > room ? 'value tight' : 'value'}
    data-quantity=${quantity}
    data-value=${shortest(x)}
    title=${`${displayAll(x)} (click for all digits)`}
    @click=${toggleDigits}
  ><span class="short">${short}</span><span class="long">${displayAll(x)}</span></button>`;
}

/** Which digits are shown is the page's own affair and dies with it. */
function toggleDigits(event: Event): void {
  (event.currentTarget as HTMLElement).classList.toggle('all');
}

/** Six significant digits, or as many as fit; never fewer than two. */
export function displayWithin(x: number, room: number): string {
  for (let digits = 6; digits > 2; digits--) {
    const text = display(x, digits);
    if (text.length <= room) return text;
  }
  return display(x, 2);
}
