import { html, nothing, type TemplateResult } from 'lit';
import type { Measured } from '../lab/session.ts';
import { display } from '../text/format.ts';
import './measure-bar.css';

/** Clock step in ms from which the bar explains why measuring takes long. */
const COARSE_MS = 0.5;

interface MeasureModel {
  /** Result of the running or last measurement; null before there is any. */
  readonly measured: Measured | null;
  readonly running: boolean;
  /** Why it ended early; '' if it did not. */
  readonly failed: string;
  /** Words on the reference prices that are shown before a measurement; '' after one. */
  readonly reference: string;
}

interface MeasureActions {
  measure(): void;
  cancel(): void;
}

/** Button to measure or cancel, the progress, and the source of the prices shown. */
export function measureBar(model: MeasureModel, actions: MeasureActions): TemplateResult {
  const { measured, running, failed, reference } = model;
  return html`<div class="measure-bar">
    ${
      running
        ? html`<button type="button" class="button" @click=${actions.cancel}>Cancel</button>
            <progress class="measure-progress" max="1" .value=${measured?.share ?? 0}
              aria-label="Measuring"></progress>
            <span class="measure-left">${leftText(measured)}</span>`
        : html`<button type="button" class="button"
          @click=${actions.measure}>${
            measured && measured.round > 0 ? 'Measure longer' : 'Measure'
          }</button>`
    }
    <p class="measure-words" data-say>${failed || (running ? '' : stateText(measured))}</p>
    ${reference ? html`<p class="measure-reference">${reference}</p>` : nothing}
  </div>`;
}

function leftText(measured: Measured | null): string {
  if (!measured) return 'counting verdicts';
  if (measured.share === 0) return 'the first round';
  const { round, rounds, secondsLeft, clockStep } = measured;
  const seconds = Math.max(1, Math.round(secondsLeft));
  // A sample takes at least `steps` steps of the clock.
  const why =
    clockStep >= COARSE_MS
      ? `: the timer here steps by ${display(clockStep, 2)} ms, so samples are long`
      : '';
  return `round ${Math.min(round + 1, rounds)} of ${rounds}, about ${seconds} s left${why}`;
}

function stateText(measured: Measured | null): string {
  if (!measured) return '';
  if (measured.complete) return 'Measured on this device.';
  return measured.round > 0
    ? `Cancelled after ${measured.round} of ${measured.rounds} rounds.`
    : 'Cancelled before the first round was over: digits are counted, no time is measured.';
}
