import { html, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import './choices.css';

export interface Choice {
  readonly id: string;
  readonly title: string;
}

/** A few choices as words, the chosen one underlined; the others, `more`, in a list. */
export function tabs(
  label: string,
  all: readonly Choice[],
  chosen: string,
  choose: (id: string) => void,
  more: readonly Choice[] = [],
): TemplateResult {
  const other = more.some(({ id }) => id === chosen);
  return html`<div class="tabs" role="group" aria-label=${label}>
    ${all.map(
      ({ id, title }) =>
        html`<button type="button" class="tab-choice" aria-pressed=${id === chosen}
          @click=${() => choose(id)}>${title}</button>`,
    )}
    ${
      more.length > 0
        ? html`<select class=${other ? 'tab-more chosen' : 'tab-more'}
          aria-label=${`${label}: more`}
            @change=${(event: Event) => choose((event.target as HTMLSelectElement).value)}>
            ${other ? '' : html`<option value="" .selected=${live(true)} disabled>more …</option>`}
            ${more.map(
              ({ id, title }) => html`<option value=${id}
              .selected=${live(id === chosen)}>${title}</option>`,
            )}
          </select>`
        : ''
    }
  </div>`;
}
