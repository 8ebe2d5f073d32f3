import { html, nothing, render, type TemplateResult } from 'lit';
import type { Dispatch } from '../../state/actions.ts';
import type { ExploreModel } from '../../state/derive.ts';
import type { ShownExample } from '../../state/example.ts';
import './example-question.css';

/** Below the scene: the example's question, and its answer on demand. */
export function exampleQuestion(
  host: HTMLElement,
  { example, state }: ExploreModel,
  dispatch: Dispatch,
): void {
  // While results are hidden, the card asks a question of its own.
  const shown = state.revealed === null ? example : null;
  host.toggleAttribute('hidden', shown === null);
  render(shown ? strip(shown, state.told, dispatch) : nothing, host);
}

function strip(
  { entry, changed }: ShownExample,
  told: boolean,
  dispatch: Dispatch,
): TemplateResult {
  if (changed) {
    const back = () => dispatch({ type: 'example', id: entry.id });
    return html`<p class="asks">Changed: the question was about another ray.</p>
      <p class="answer">
        <button type="button" class="ray-tool" @click=${back}>bring the example back</button>
      </p>`;
  }
  const tell = () => dispatch({ type: 'tell', on: !told });
  return html`<p class="asks">${entry.asks}</p>
    <div class="answer">
      <button type="button" class="ray-tool" aria-expanded=${told}
        aria-controls="example-answer" title="Show or hide the answer (a)" @click=${tell}
      >answer</button>
      <p id="example-answer">${told ? entry.answer : nothing}</p>
    </div>`;
}
