import { html, nothing, render, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { Dispatch } from '../../state/actions.ts';
import type { ExploreModel } from '../../state/derive.ts';
import { hiddenReach, markOf, markStep } from '../../state/hidden-results.ts';
import { isAsk } from '../../state/prediction-ask.ts';
import {
  type Guess,
  judgementOf,
  optionsOf,
  QUESTIONS,
  questionOf,
} from '../../state/predictions.ts';
import { display } from '../../text/format.ts';
import './predict-card.css';

interface Committed {
  readonly question: ReturnType<typeof questionOf>;
  readonly guess: Guess;
  /** The shape and the ray that the guess is about, as a text. */
  readonly about: string;
}

const aboutOf = ({ shape, ray, state: { between, caps } }: ExploreModel): string =>
  JSON.stringify([shape, ray, between, caps]);

/** Scene and graph with the mark and its distance from the hit; null for those of the model. */
export type MarkedModels = Pick<ExploreModel, 'scene' | 'graph'> | null;

type PredictCard = (host: HTMLElement, model: ExploreModel) => MarkedModels;

/** Asks while the results are hidden; afterwards says how far off the answer was. */
export function createPredictCard(dispatch: Dispatch): PredictCard {
  let committed: Committed | null = null;
  return (host, model) => {
    const { state } = model;
    const hidden = !model.shown.hits;
    const about = aboutOf(model);
    if (hidden || committed?.about !== about) committed = null;
    const question = questionOf(state.ask, model.found.details.family === 'curved');
    const commit = (guess: Guess): void => {
      committed = { question, guess, about };
      // The mark stays beside the answer, on the ray and in the graph.
      if (typeof guess === 'number') dispatch({ type: 'bead', t: guess });
      dispatch({ type: 'reveal', lines: null });
    };
    const judgement = committed && judgementOf(committed.question, committed.guess, model);
    render(
      hidden
        ? asked(model, question, dispatch, commit)
        : committed && judgement
          ? judged(committed, judgement)
          : nothing,
      host,
    );
    return committed && judgement && marked(committed.guess, judgement.truth, model);
  };
}

function asked(
  model: ExploreModel,
  question: Committed['question'],
  dispatch: Dispatch,
  commit: (guess: Guess) => void,
): TemplateResult {
  const curved = model.found.details.family === 'curved';
  const t = markOf(model.state);
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
    <p class="predict-asks">${question.asks}${
      model.ended && question.id === 'points'
        ? ' All of the shape is meant, beyond its ends too.'
        : ''
    }</p>
    <p class="predict-answers">
      ${t === null ? nothing : mark(t, model, dispatch, commit)}
      ${optionsOf(question, model).map(
        ({ id, title }) =>
          html`<button type="button" class="guess" data-guess=${id}
            @click=${() => commit(id)}>${title}</button>`,
      )}
    </p>
  </section>`;
}

function mark(
  t: number,
  { shape, ray }: ExploreModel,
  dispatch: Dispatch,
  commit: (guess: Guess) => void,
): TemplateResult {
  const step = markStep(hiddenReach(shape, ray));
  const move = (event: Event): void => {
    const value = (event.target as HTMLInputElement).valueAsNumber;
    if (Number.isFinite(value)) dispatch({ type: 'bead', t: value });
  };
  return html`<label>mark at t = <input class="predict-t" type="number" step="any"
    .value=${live(String(t))} @change=${move} /></label>
    ${[-step, step].map((by) => {
      const moveBy = (): void => dispatch({ type: 'bead', t: Number((t + by).toPrecision(12)) });
      const label = `Move the mark by ${display(by)}`;
      return html`<button type="button" class="guess" aria-label=${label}
        @click=${moveBy}>${by < 0 ? '−' : '+'}</button>`;
    })}
    <button type="button" class="guess" data-guess="mark"
      @click=${() => commit(t)}>it is here</button>`;
}

/** The mark as it was put, with the way from it to the first hit, until the bead is moved on. */
function marked(guess: Guess, truth: Guess | null, model: ExploreModel): MarkedModels {
  const { scene, graph, state, ray } = model;
  if (typeof guess !== 'number' || state.bead !== guess || !scene || !graph) return null;
  const off = typeof truth === 'number' ? Math.abs(guess - truth) : 0;
  const text = `Δt = ${display(off, 3)}, length ${display(off * Math.hypot(...ray.direction), 3)}`;
  const gap = typeof truth === 'number' && off > 0 ? { from: guess, to: truth, text } : null;
  const mark = { title: 'your mark', isOpen: false, gap };
  return { scene: { ...scene, mark }, graph: { ...graph, mark } };
}

function judged(
  { question, guess }: Committed,
  { right, gap, mistake }: ReturnType<typeof judgementOf>,
): TemplateResult {
  const said = [...question.options, ...(question.capOptions ?? [])].find(
    ({ id }) => id === guess,
  )?.title;
  return html`<section class="predict" aria-label="Prediction">
    <p data-say><strong>${right ? 'Right.' : 'Not so.'}</strong>
      ${said ? `You said: ${said}. ` : ''}${gap}${mistake ? ` ${mistake}` : ''}</p>
  </section>`;
}
