import { html, type TemplateResult } from 'lit';
import type { Measured } from '../../lab/session.ts';
import type { Target } from '../../math/batch.ts';
import { digitSteps } from '../../panels/digit-steps.ts';
import { ladderTable } from '../../panels/ladder-table.ts';
import { nudges } from '../../panels/nudges.ts';
import { changeWords, flips } from '../../state/accuracy/change-words.ts';
import { QUESTION_WORDS, questionOf } from '../../state/accuracy/frontier.ts';
import type { RayModel } from '../../state/accuracy/ladder.ts';
import type { AccuracySettings } from '../../state/accuracy/settings.ts';
import type { Dispatch } from '../../state/actions.ts';
import type { AppState } from '../../state/state.ts';
import { displayAll } from '../../text/format.ts';
import { familyName } from './family-name.ts';

/** One ray by every method, where its digits are lost, and what a step of one ulp changes. */
export function createRayView(dispatch: Dispatch, announce: (words: string) => void) {
  const answer = createAnswer(announce);
  let isOpen = false;

  function draw(
    state: AppState,
    ray: RayModel,
    found: Measured | null,
    { family, worth }: AccuracySettings,
  ): TemplateResult {
    const answered = answer.wordsFor(ray, state.method);
    const question = questionOf(worth);
    const timingsIn = (target: Target) =>
      new Map(
        found?.columns[target].flatMap((row) =>
          row[question] ? [[row.id, row[question]] as const] : [],
        ),
      );
    const timings = { simd: timingsIn('simd'), typescript: timingsIn('typescript') };
    const timed = `“${familyName(family)}” rays, ${QUESTION_WORDS[question]}`;
    const model = { rows: ray.rows, where: ray.where, timings, timed, chosen: state.method };
    return html`<div class="acc-title">
        <h2>This ray</h2>
        <p>${ray.words}</p>
        <button type="button" class="button"
          @click=${() => dispatch({ type: 'page', page: 'explore' })}>Open in Explore</button>
      </div>
      ${ladderTable(model, (id) => dispatch({ type: 'method', id }))}
      <div class="acc-more">
        <details .open=${isOpen} @toggle=${(event: Event) => {
          isOpen = (event.currentTarget as HTMLDetailsElement).open;
        }}>
          <summary>Where did the digits go?</summary>
          ${digitSteps(ray.chosenTitle, ray.losses)}
        </details>
        <details>
          <summary>What does one double more or less change?</summary>
          ${nudges(state, dispatch, answer.moved)}
          <p class="nudge-answer">${answered || NOT_MOVED}</p>
        </details>
      </div>`;
  }

  return {
    draw,
    /** Whether "Where did the digits go?" is open when it is drawn next; false leaves it. */
    open(steps: boolean): void {
      if (steps) isOpen = true;
    },
  };
}

/** The section in place of the ray's table while its results are hidden on Explore. */
export const hiddenRay = (dispatch: Dispatch): TemplateResult =>
  html`<div class="acc-title">
      <h2>This ray</h2>
      <p>Results are hidden on Explore, to be predicted. What each method says of this ray would
        tell them.</p>
      <button type="button" class="button"
        @click=${() => dispatch({ type: 'page', page: 'explore' })}>Predict in Explore</button>
      <button type="button" class="button" data-show-hidden
        @click=${() => dispatch({ type: 'reveal', lines: null })}>Show them</button>
    </div>`;

const NOT_MOVED = 'Move an input by one double: what that changes is said here.';

/**
 * Keeps which inputs were moved since the page was drawn. The next drawing makes words of what that
 * changed, announces them, and shows them until the ray changes again.
 */
function createAnswer(announce: (words: string) => void) {
  const moved = new Map<string, { readonly from: number; to: number }>();
  let last: RayModel | null = null;
  let words = '';
  return {
    moved(name: string, from: number, to: number): void {
      moved.set(name, { from: moved.get(name)?.from ?? from, to });
    },
    wordsFor(ray: RayModel, chosen: string): string {
      if (last && last !== ray) {
        const inputs = [...moved].map(
          ([name, { from, to }]) => `${name} = ${displayAll(from)} → ${displayAll(to)}`,
        );
        words = inputs.length > 0 ? `${inputs.join(', ')}: ${changeWords(last, ray, chosen)}.` : '';
        moved.clear();
        const said = words || flips(last, ray);
        if (said) announce(said);
      }
      last = ray;
      return words;
    },
  };
}
