import { html, nothing, type TemplateResult } from 'lit';
import type { Measured } from '../lab/session.ts';
import './measure-bar.css';

export interface MeasureModel {
  /** Null: nothing was measured yet. */
  readonly measured: Measured | null;
  readonly running: boolean;
  /** Why it ended early; '' if it did not. */
  readonly failed: string;
  readonly provenance: string;
}

export interface MeasureActions {
  measure(): void;
  cancel(): void;
}

/** Measure or cancel, how far it is, and where the numbers come from. */
export function measureBar(model: MeasureModel, actions: MeasureActions): TemplateResult {
  const { measured, running } = model;
  return html`<div class="measure-bar">
    ${
      running
        ? html`<button type="button" class="button" @click=${actions.cancel}>Cancel</button>
            <progress class="measure-progress" max="1" .value=${measured?.share ?? 0} aria-label="Measuring"></progress>
            <span class="measure-left">${leftText(measured)}</span>`
        : measured
          ? html`<button type="button" class="button primary" @click=${actions.measure}>Measure again</button>`
          : nothing
    }
    <p class="measure-words" role="status">${model.failed || (running ? '' : stateText(measured))}</p>
    <p class="provenance">${model.provenance}</p>
  </div>`;
}

function leftText(measured: Measured | null): string {
  if (!measured || measured.share === 0) return 'the first round';
  const { round, rounds, secondsLeft } = measured;
  const seconds = Math.max(1, Math.round(secondsLeft));
  return `round ${Math.min(round + 1, rounds)} of ${rounds}, about ${seconds} s left`;
}

function stateText(measured: Measured | null): string {
  if (!measured || measured.complete) return '';
  return measured.round > 0
    ? `Cancelled after ${measured.round} of ${measured.rounds} rounds.`
    : 'Cancelled before the first round was over: digits are counted, no time is measured.';
}
