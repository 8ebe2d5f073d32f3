import { html, type TemplateResult } from 'lit';
import { FIRST_AXES } from '../../../state/accuracy/atlas.ts';
import { READY_MAPS } from '../../../state/accuracy/ready-maps.ts';
import type { AccuracySettings } from '../../../state/accuracy/settings.ts';
import type { Dispatch } from '../../../state/actions.ts';

/** The way to the map of the present ray, and the maps that are ready. */
export function readyMaps(
  set: (settings: Partial<AccuracySettings>) => void,
  dispatch: Dispatch,
): TemplateResult {
  return html`<div class="acc-title">
      <h2>Where it is wrong</h2>
      <p>Every pixel of a map is a ray, down to one double a pixel.</p>
      <button type="button" class="button"
        @click=${() => set({ atlas: FIRST_AXES })}>Map around this ray</button>
    </div>
    <ul class="acc-maps">
      ${READY_MAPS.map(
        ({ id, title, sentence, link }) => html`<li>
          <button type="button" class="acc-link" data-map=${id}
            @click=${() => dispatch({ type: 'link', hash: link })}>${title}</button>
          <span>${sentence}</span>
        </li>`,
      )}
    </ul>`;
}
