import { html, type TemplateResult } from 'lit';
import type { MeasuredRow } from '../lab/session.ts';
import { digitSteps } from '../panels/digit-steps.ts';
import { ladderTable, SAYS } from '../panels/ladder-table.ts';
import { createNudges } from '../panels/nudges.ts';
import { QUESTION_WORDS, questionOf } from '../state/accuracy/frontier.ts';
import type { RayModel } from '../state/accuracy/ladder.ts';
import type { AccuracySettings } from '../state/accuracy/settings.ts';
import type { Dispatch } from '../state/actions.ts';
import type { AppState } from '../state/state.ts';
import { familyName } from './accuracy-heads.ts';

/** This ray through the ladder, where its digits go, and what one double changes. */
export function createRayView(dispatch: Dispatch) {
  const nudges = createNudges(dispatch);
  return (
    state: AppState,
    ray: RayModel,
    measured: readonly MeasuredRow[],
    { family, worth }: AccuracySettings,
  ): TemplateResult => {
    const question = questionOf(worth);
    const timings = new Map(
      measured.flatMap((row) => (row[question] ? [[row.id, row[question]] as const] : [])),
    );
    const timed = `“${familyName(family)}” rays, ${QUESTION_WORDS[question]}`;
    const model = { rows: ray.rows, where: ray.where, timings, timed, chosen: state.method };
    return html`<div class="acc-head">
        <h2>This ray</h2>
        <p>${ray.words}</p>
        <button type="button" class="button" @click=${() => dispatch({ type: 'open', state: { ...state, page: 'explore' } })}>Open in Explore</button>
      </div>
      ${ladderTable(model, (id) => dispatch({ type: 'method', id }))}
      <div class="acc-more">
        <details>
          <summary>Where did the digits go?</summary>
          ${digitSteps(ray.chosenTitle, ray.losses)}
        </details>
        <details>
          <summary>What does one double more or less change?</summary>
          ${nudges(state)}
        </details>
      </div>`;
  };
}

/** Which methods say something else than before, for those who cannot see the column. */
export function announceFlips(
  before: RayModel,
  after: RayModel,
  announce: (words: string) => void,
): void {
  const flipped = after.rows.filter((row, i) => row.found.class !== before.rows[i]?.found.class);
  if (flipped.length > 0) {
    announce(
      flipped.map(({ method, found }) => `${method.title}: ${SAYS[found.class]}`).join('; '),
    );
  }
}
