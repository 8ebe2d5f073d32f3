import { html, nothing, svg, type TemplateResult } from 'lit';
import { digitCount, type Marked, MOST_DIGITS, PLACES } from '../lab/digits.ts';
import { shortest } from '../text/format.ts';
import { superscript } from '../text/scripts.ts';
import './digit-bar.css';

/** A number with its right digits bold and the others faded, and words for screen readers. */
export function markedNumber({ right, wrong, exponent }: Marked): TemplateResult {
  return html`<span class="marked">${right ? html`<b>${right}</b>` : ''}${
    wrong ? html`<span class="wrong-digits">${wrong}</span>` : ''
  }${
    exponent === null
      ? ''
      : html`<span
    class="power"> · 10${superscript(exponent)}</span>`
  }</span>`;
}

/** Sixteen cells, as many of them filled as digits are right. */
function digitBar(count: number): TemplateResult {
  const cells = Array.from(
    { length: PLACES },
    (_, i) =>
      svg`<rect class=${i < count ? 'one-digit full' : 'one-digit'} x=${9 * i} width="7"
        height="14"></rect>`,
  );
  return html`<svg class="digit-bar" viewBox="0 0 142 14" aria-hidden="true">${cells}</svg>`;
}

/** The count of right digits and the bar; a dash for null. `quantity`: value of `data-quantity`. */
export function digitCell(digits: number | null, quantity: string | null): TemplateResult {
  if (digits === null || Number.isNaN(digits)) {
    return html`<span class="digit-cell"><span class="count">–</span>${digitBar(0)}</span>`;
  }
  const count = digitCount(digits);
  return html`<span class="digit-cell">
    <b class="count" data-quantity=${quantity ?? nothing}
      data-value=${shortest(Math.min(digits, MOST_DIGITS))}>${count}</b>
    ${digitBar(count)}
  </span>`;
}
