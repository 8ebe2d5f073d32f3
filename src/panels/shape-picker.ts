import { html } from 'lit';
import { guard } from 'lit/directives/guard.js';
import { SHAPES } from '../math/index.ts';
import type { Dispatch } from '../state/actions.ts';
import type { ExploreModel } from '../state/derive.ts';
import './shape-picker.css';

/** The row of shape buttons; choosing one keeps the ray. */
export function shapePicker({ state }: ExploreModel, dispatch: Dispatch): unknown {
  return guard(
    [state.kind],
    () => html`<div class="shapes" role="group" aria-label="Shape">
    ${SHAPES.map(
      ({ kind, title, icon }) => html`<button
        type="button"
        class="shape-choice"
        aria-pressed=${kind === state.kind}
        @click=${() => dispatch({ type: 'shape', kind })}
      ><svg viewBox="0 0 24 24" width="26" height="26" aria-hidden="true"><path
        d=${icon} /></svg><span>${title}</span></button>`,
    )}
  </div>`,
  );
}
