import { html, nothing, type TemplateResult } from 'lit';
import type { EffectId } from '../scene/effects/index.ts';
import { SIMPLIFICATIONS } from '../scene/simplifications.ts';
import {
  grouped,
  type KindRow,
  type LedgerModel,
  type LedgerRow,
  msWords,
  percent,
} from '../state/picture/ledger.ts';
import { shortest } from '../text/format.ts';
import type { Cost, Progress } from '../tracer/types.ts';
import './picture-ledger.css';

interface LedgerTools {
  force(id: EffectId, how: 'on' | 'off' | 'no'): void;
  /** Traces the picture once more without each effect, to count the pixels that it changes. */
  measure(): void;
  /** Number of pictures that `measure` would trace; 0 if all pixels are counted. */
  readonly unmeasured: number;
  readonly isMeasuring: boolean;
}

const SAMPLE_WORDS: Readonly<Record<number, string>> = {
  1: 'one through every pixel',
  4: 'four through every pixel',
  9: 'nine through every pixel',
  16: 'sixteen through every pixel',
};

/**
 * What was simulated, why, and what it cost; then what was not, and why. `took`: time of the
 * finished picture; null before.
 */
export function ledger(
  model: LedgerModel,
  took: Pick<Progress, 'msSpent' | 'workers'> | null,
  tools: LedgerTools,
): TemplateResult {
  const { camera, simulated, idle, total, pixels } = model;
  return html`<table class="ledger">
      <thead>
        <tr><th scope="col"><span class="visually-hidden">effect</span></th><th
          scope="col">rays</th><th scope="col">solves</th><th scope="col">ms</th><th
            scope="col">pixels it changes</th></tr>
      </thead>
      <tbody class="entry" data-effect="camera">
        <tr>
          <th scope="row">camera rays</th>
          ${costCells(camera.cost)}
          <td>all</td>
        </tr>
        ${under(SAMPLE_WORDS[model.samples] ?? '', nothing, camera)}
      </tbody>
      ${simulated.map((row) => simulatedRow(row, pixels, tools))}
      <tbody class="entry total" data-effect="total">
        <tr>
          <th scope="row">picture</th>
          ${costCells(total.rays > 0 ? total : null)}
          <td></td>
        </tr>
      </tbody>
    </table>
    <p class="ledger-kinds">${kinds(model)}</p>
    ${model.total.rays > 0 ? countWords(model, took) : nothing}
    ${measureLine(tools)}
    <h3 class="ledger-title">Not simulated</h3>
    <ul class="idle">
      ${idle.map((row) => idleRow(row, pixels, tools))}
    </ul>`;
}

/** The list of simplifications in every picture. */
export function simplifications(): TemplateResult {
  return html`<h3 class="ledger-title">Left out or simplified, in every picture</h3>
    <ul class="idle">
      ${SIMPLIFICATIONS.map(
        ({ title, how, reason }) => html`<li class="idle-row" data-simplification=${title}>
          ${DASH}<span class="idle-name">${title}</span>
          <span class="idle-reason">${how}: ${reason}</span>
        </li>`,
      )}
    </ul>`;
}

function simulatedRow(row: LedgerRow, pixels: number, tools: LedgerTools): TemplateResult {
  const forcedOn = row.forced === 'on';
  const reason = forcedOn
    ? html`<strong>forced on</strong>; ${needWords(row)}: ${row.reason}`
    : row.reason;
  const toggle = forcedOn
    ? button(row, 'no', RELEASE, tools)
    : button(row, 'off', 'force off', tools);
  return html`<tbody class="entry" data-effect=${row.id}>
    <tr>
      <th scope="row">${row.title}${needed(row)}</th>
      ${costCells(row.cost)}
      <td>${changed(row, pixels)}</td>
    </tr>
    ${under(reason, toggle, row)}
  </tbody>`;
}

/** The reason of a row, and the bar of its share of the time. */
function under(
  reason: TemplateResult | string,
  toggle: TemplateResult | typeof nothing,
  { cost, share, from }: Pick<LedgerRow, 'cost' | 'share' | 'from'>,
): TemplateResult {
  const words = cost ? `${percent(share, 1)} of the time` : '';
  return html`<tr class="why"><td colspan="5">
      <span class="reason-line"><span>${reason}</span>${toggle}</span>
      <svg class="bar" viewBox="0 0 1000 8" preserveAspectRatio="none" role="img"
        aria-label=${words || 'not traced yet'} data-quantity="share"
          data-value=${shortest(share)}><title>${words}</title><rect class="part" x=${1000 * from}
            y="0" width=${1000 * share} height="8" /></svg>
    </td></tr>`;
}

function costCells(cost: Cost | null): TemplateResult {
  if (!cost) return html`<td></td><td></td><td></td>`;
  return html`<td data-quantity="rays" data-value=${cost.rays}>${grouped(cost.rays)}</td>
    <td data-quantity="solves" data-value=${cost.solves}>${grouped(cost.solves)}</td>
    <td data-quantity="ms" data-value=${shortest(cost.ms)}>${msWords(cost.ms)}</td>`;
}

const needWords = ({ needed, leftOut }: LedgerRow): string =>
  needed ? 'needed' : leftOut ? 'left out' : 'not needed';

function needed(row: LedgerRow): TemplateResult {
  return html`<span class="visually-hidden" data-quantity="needed"
    data-value=${String(row.needed)}>, ${needWords(row)}</span>`;
}

/** Words on what the columns count, and why times add up to more than the elapsed time. */
function countWords(
  { total: { questions, solves, ms } }: LedgerModel,
  took: Pick<Progress, 'msSpent' | 'workers'> | null,
): TemplateResult {
  const clock = took
    ? html`; from start to end it took ${msWords(took.msSpent)} ms, with ${
        took.workers === 1 ? 'one worker' : `${grouped(took.workers)} workers`
      }`
    : nothing;
  return html`<p class="ledger-kinds">A surface was asked about a ray <span
    data-quantity="questions"
      data-value=${questions}>${grouped(questions)}</span
      > times. Solves: how often a root was worked out for that, found or not (${grouped(solves)}):
      often none is needed to say that a line misses a shape, and finite heights need the second
      one.
    ms: the work of all workers added up (${msWords(ms)})${clock}.</p>`;
}

function changed({ pixels }: LedgerRow, all: number): TemplateResult | string {
  if (pixels === null) return '';
  const title = `${grouped(pixels)} of ${grouped(all)} pixels`;
  const words = pixels === 0 ? 'none' : percent(pixels, all);
  return html`<span data-quantity="pixels" data-value=${pixels} title=${title}>${words}</span>`;
}

/** Label of the button that lets the scene decide on an effect again. */
const RELEASE = 'as called for';
const DASH = html`<span class="idle-dash" aria-hidden="true"></span>`;

function idleRow(row: LedgerRow, pixels: number, tools: LedgerTools): TemplateResult {
  const off = row.forced === 'off';
  const lost = row.pixels === null ? nothing : html`; ${changed(row, pixels)} of the pixels differ`;
  return html`<li class="idle-row" data-effect=${row.id}>
    ${DASH}<span class="idle-name">${row.title}${needed(row)}<span class="visually-hidden"
      data-quantity="rays" data-value="0">, 0 rays</span></span>
    <span class="idle-reason">${
      off
        ? html`<strong>forced off</strong>; needed: ${row.reason}${lost}`
        : row.leftOut
          ? html`<strong>left out</strong>: ${row.reason}`
          : row.reason
    }</span>
    ${off ? button(row, 'no', RELEASE, tools) : button(row, 'on', 'force on', tools)}
  </li>`;
}

function button(
  { id, title }: LedgerRow,
  how: 'on' | 'off' | 'no',
  words: string,
  tools: LedgerTools,
): TemplateResult {
  return html`<button type="button" class="textual" aria-label=${`${title}: ${words}`}
    @click=${() => tools.force(id, how)}>${words}</button>`;
}

function kinds({ kinds: of, saved, cut, total }: LedgerModel): TemplateResult | typeof nothing {
  if (total.rays === 0) return nothing;
  return html`Rays: ${of.map((row, i) => html`${i > 0 ? ' · ' : ''}${kindWords(row)}`)};
    <span data-quantity="rays.saved"
      data-value=${saved}
      >${grouped(saved)} not fired, since they could bring less than half a level of 255</span>${
        cut > 0 ? html`, ${grouped(cut)} not fired after the last bounce` : nothing
      }`;
}

/** Number of rays of a kind, and of each effect if several fire them. */
function kindWords({ kind, rays, parts }: KindRow): TemplateResult {
  const several = parts.length > 1;
  const words = parts.map((part) => `${grouped(part.rays)} ${part.words}`).join(', ');
  return html`<span data-quantity="rays.${kind}"
    data-value=${rays}>${grouped(rays)} ${kind}</span>${several ? ` (${words})` : ''}`;
}

function measureLine({ measure, unmeasured, isMeasuring }: LedgerTools): TemplateResult {
  if (isMeasuring)
    return html`<p class="measure" role="status">counting the pixels that each effect changes…</p>`;
  if (unmeasured === 0) return html`<p class="measure"></p>`;
  return html`<p class="measure"><button type="button" class="textual"
    @click=${measure}>count the pixels that each changes</button>, by tracing once without it</p>`;
}
