import { html, nothing, type TemplateResult } from 'lit';
import { display, displayAll, shortest } from '../text/format.ts';
import { spokenName } from '../text/spoken.ts';

interface Look {
  /**
   * Characters that there is space for: six digits become fewer rather than run into a neighbour.
   */
  readonly room?: number;
  readonly digits?: number;
  /** What stands there instead. */
  readonly text?: string | null;
  /**
   * The double has more digits than `text`, for a click; else it does not tell the number at all.
   */
  readonly keeps?: boolean;
}

/**
 * A computed number on the page: shown in six digits, carried in full by data-value; a click shows
 * every digit. What a method lost carries none.
 */
export function value(
  quantity: string,
  x: number,
  { room = Number.POSITIVE_INFINITY, digits = 6, text = null, keeps = text === null }: Look = {},
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

/** Which digits are shown is the page's own affair and dies with it. */
function toggleDigits(event: Event): void {
  (event.currentTarget as HTMLElement).classList.toggle('all');
}

/** So many significant digits, or as many as fit; never fewer than two. */
function displayWithin(x: number, room: number, most = 6): string {
  for (let digits = most; digits > 2; digits--) {
    const text = display(x, digits);
    if (text.length <= room) return text;
  }
  return display(x, 2);
}
