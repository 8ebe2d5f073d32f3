import { html, nothing, type TemplateResult } from 'lit';
import { grouped, msWords, percent } from '../state/picture/ledger.ts';
import type { Progress } from '../tracer/types.ts';
import './picture-status.css';

/** A progress bar while a picture is traced; then its time and the number of workers. */
export function pictureStatus(
  progress: Progress | null,
  what: string,
  middle: TemplateResult,
  left: Progress | null,
): TemplateResult {
  const runs = progress?.state === 'loading' || progress?.state === 'tracing';
  return html`${runs ? progressBar(progress, what) : html`<div class="progress-rest"></div>`}
    <div class="status-line">
      <span class="status-side">${
        left?.state === 'finished' ? html`${msWords(left.msSpent)} ms` : nothing
      }</span>
      <div class="status-middle">${middle}</div>
      <span class="status-side">${runs ? nothing : outcome(progress, left !== null)}</span>
    </div>`;
}

function progressBar({ done, total, step, msLeft, state }: Progress, what: string): TemplateResult {
  const share = total > 0 ? done / total : 0;
  const blocks = step > 1 ? `blocks of ${step} × ${step}` : 'pixel by pixel';
  const left = Number.isNaN(msLeft) ? '' : `, about ${timeWords(msLeft)} left`;
  const words =
    state === 'loading'
      ? 'loading what this scene needs…'
      : `${blocks}, ${percent(done, total)}${left}`;
  return html`<div class="progress">
    <svg class="progress-bar" viewBox="0 0 1000 6" preserveAspectRatio="none" role="progressbar"
      aria-label=${what} aria-valuemin="0" aria-valuemax="100"
        aria-valuenow=${Math.round(100 * share)}><rect width=${1000 * share} height="6" /></svg>
    <span class="progress-words">${what}: ${words}</span>
  </div>`;
}

function outcome(progress: Progress | null, brief: boolean): TemplateResult | string {
  if (!progress) return '';
  if (progress.state === 'failed') return html`<strong>failed</strong>: ${progress.message}`;
  if (progress.state === 'cancelled')
    return `cancelled at ${percent(progress.done, progress.total)}`;
  return brief ? `${msWords(progress.msSpent)} ms` : took(progress);
}

function took({ msSpent, workers }: Progress): TemplateResult {
  const by = workers === 1 ? 'one worker' : `${grouped(workers)} workers`;
  return html`<span title=${`from start to end, by ${by}`}>${msWords(msSpent)} ms, ${by}</span>`;
}

function timeWords(ms: number): string {
  return ms < 950 ? 'a second' : `${grouped(Math.round(ms / 1000))} s`;
}
