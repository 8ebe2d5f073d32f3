import { html, nothing, render, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { Dispatch } from '../../state/actions.ts';
import { isAsk } from '../../state/ask.ts';
import type { ExploreModel } from '../../state/derive.ts';
import { type Guess, judgementOf, QUESTIONS, questionOf } from './predictions.ts';
import './predict-card.css';

interface Committed {
  readonly question: ReturnType<typeof questionOf>;
  readonly guess: Guess;
  /** The shape and the ray that the guess is about. */
  readonly shape: ExploreModel['shape'];
  readonly ray: ExploreModel['ray'];
}

/** Initial t of the mark: the tip of d. */
const START = 1;

type PredictCard = (host: HTMLElement, model: ExploreModel) => void;

/** Asks while the results are hidden; afterwards says how far off the answer was. */
export function createPredictCard(dispatch: Dispatch): PredictCard {
  let committed: Committed | null = null;
  return (host, model) => {
    const { shape, ray, state } = model;
    const hidden = !model.shown.hits;
    if (hidden || committed?.shape !== shape || committed.ray !== ray) committed = null;
    const question = questionOf(state.ask, model.found.details.family === 'curved');
    const commit = (guess: Guess): void => {
      committed = { question, guess, shape, ray };
      // The mark stays visible as the bead, on the ray and in the graph.
      if (typeof guess === 'number') dispatch({ type: 'bead', t: guess });
      dispatch({ type: 'reveal', lines: null });
    };
    render(
      hidden
        ? asked(model, question, dispatch, commit)
        : committed
          ? judged(committed, model)
          : nothing,
      host,
    );
  };
}

function asked(
  { state, found }: ExploreModel,
  question: Committed['question'],
  dispatch: Dispatch,
  commit: (guess: Guess) => void,
): TemplateResult {
  const curved = found.details.family === 'curved';
  const choose = (event: Event): void => {
    const { value } = event.target as HTMLSelectElement;
    if (isAsk(value)) dispatch({ type: 'ask', ask: value });
  };
  return html`<section class="predict" aria-label="Prediction">
    <p class="predict-head">
      <label>Predict <select @change=${choose}>
        ${QUESTIONS.filter(({ fits }) => fits(curved)).map(
          ({ id, title }) =>
            html`<option value=${id} .selected=${live(id === question.id)}>${title}</option>`,
        )}
      </select></label>
    </p>
    <p class="predict-asks">${question.asks}</p>
    <p class="predict-answers">
      ${question.marked ? mark(state.bead ?? START, dispatch, commit) : nothing}
      ${question.options.map(
        ({ id, title }) =>
          html`<button type="button" class="guess" data-guess=${id}
            @click=${() => commit(id)}>${title}</button>`,
      )}
    </p>
  </section>`;
}

function mark(t: number, dispatch: Dispatch, commit: (guess: Guess) => void): TemplateResult {
  const move = (event: Event): void => {
    const value = (event.target as HTMLInputElement).valueAsNumber;
    if (!Number.isFinite(value)) return;
    dispatch({ type: 'ask', ask: 'where' });
    dispatch({ type: 'bead', t: value });
  };
  return html`<label>mark at t = <input class="predict-t" type="number" step="any"
    .value=${live(String(t))} @change=${move} /></label>
    ${[-0.1, 0.1].map((by) => {
      const moveBy = (): void => {
        dispatch({ type: 'ask', ask: 'where' });
        dispatch({ type: 'bead', t: Number((t + by).toPrecision(12)) });
      };
      return html`<button type="button" class="guess" aria-label=${`Move the mark by ${by}`}
        @click=${moveBy}>${by < 0 ? '−' : '+'}</button>`;
    })}
    <button type="button" class="guess" data-guess="mark"
      @click=${() => commit(t)}>it is here</button>`;
}

function judged({ question, guess }: Committed, model: ExploreModel): TemplateResult {
  const { right, gap, mistake } = judgementOf(question, guess, model);
  const said = question.options.find(({ id }) => id === guess)?.title;
  return html`<section class="predict" aria-label="Prediction">
    <p role="status"><strong>${right ? 'Right.' : 'Not so.'}</strong>
      ${said ? `You said: ${said}. ` : ''}${gap}${mistake ? ` ${mistake}` : ''}</p>
  </section>`;
}
