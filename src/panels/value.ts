import { html, nothing, type TemplateResult } from 'lit';
import { display, displayAll, shortest } from '../text/format.ts';
import { spokenName } from '../text/spoken.ts';

interface ValueOptions {
  /** Largest number of characters; digits are dropped to fit. */
  readonly room?: number;
  readonly digits?: number;
  /** Text to show instead of the number. */
  readonly text?: string | null;
  /** Whether a click on `text` may show the double; false if the double is not the number. */
  readonly keeps?: boolean;
}

/**
 * A computed number on the page: six digits, all of them in `data-value` and after a click. NaN has
 * no `data-value`.
 */
export function value(
  quantity: string,
  x: number,
  {
    room = Number.POSITIVE_INFINITY,
    digits = 6,
    text = null,
    keeps = text === null,
  }: ValueOptions = {},
): TemplateResult {
  const short = text ?? displayWithin(x, room, digits);
  const has = !Number.isNaN(x);
  const long = keeps ? displayAll(x) : (text ?? displayAll(x));
  return html`<button
    type="button"
    class=${short.length > room ? 'value tight' : 'value'}
    data-quantity=${has ? quantity : nothing}
    data-value=${has ? shortest(x) : nothing}
    aria-label=${`${spokenName(quantity)} ${short}`}
    title=${`${long} (click for all digits)`}
    @click=${toggleDigits}
  ><span class="short">${short}</span><span class="long">${long}</span></button>`;
}

/** Shows all digits or six; not part of the state. */
function toggleDigits(event: Event): void {
  (event.currentTarget as HTMLElement).classList.toggle('all');
}

/** The number in `most` digits or as many as fit into `room` characters, two at least. */
function displayWithin(x: number, room: number, most = 6): string {
  for (let digits = most; digits > 2; digits--) {
    const text = display(x, digits);
    if (text.length <= room) return text;
  }
  return display(x, 2);
}
