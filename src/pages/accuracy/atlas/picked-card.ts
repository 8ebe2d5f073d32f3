import { html, nothing, type TemplateResult } from 'lit';
import type { Question } from '../../../math/families.ts';
import type { AtlasMap } from '../../../state/accuracy/atlas.ts';

/** The chosen pixel. */
export interface Picked {
  readonly map: AtlasMap;
  /** Its numbers, the method's verdict and the right one. */
  readonly words: string;
  /** Its ray and shape as they would be typed; null where there are none. */
  readonly at: Question | null;
}

interface Actions {
  /** Makes it "This ray"; with the steps of its method open. */
  readonly take: (picked: Picked, withSteps: boolean) => void;
  readonly explore: (picked: Picked) => void;
  readonly tryProgram: (picked: Picked) => void;
  /** What the student's program said of the chosen ray; '' before it was asked. */
  readonly tried: string;
}

/** The chosen pixel is a ray: what can be done with it. */
export function pickedCard(picked: Picked | null, actions: Actions): TemplateResult {
  if (!picked) return html``;
  const { words, at } = picked;
  const button = (title: string, act: () => void): TemplateResult =>
    html`<button type="button" class="button" @click=${act}>${title}</button>`;
  return html`<div class="atlas-picked">
    <h3>Chosen ray</h3>
    <p class="atlas-numbers">${words}</p>
    ${
      at
        ? html`<p class="atlas-deeds">
          ${button('Make it “This ray”', () => actions.take(picked, false))}
          ${button('Where did its digits go?', () => actions.take(picked, true))}
          ${button('Open in Explore', () => actions.explore(picked))}
          ${button('Try your program on it', () => actions.tryProgram(picked))}
        </p>`
        : nothing
    }
    ${actions.tried ? html`<p data-say>${actions.tried}</p>` : nothing}
  </div>`;
}
