import { html, nothing, svg, type TemplateResult } from 'lit';
import type { EffectId } from '../scene/effects/index.ts';
import { type Shows, SIMPLIFICATIONS } from '../scene/simplifications.ts';
import type { Scene } from '../scene/types.ts';
import type { BuildUp } from '../state/picture/build-up.ts';
import {
  grouped,
  type KindRow,
  type LedgerModel,
  type LedgerRow,
  MEASURE_WORDS,
  MEASURES,
  type Measure,
  msWords,
  percent,
} from '../state/picture/ledger.ts';
import type { Spread, Times } from '../state/picture/times.ts';
import { shortest } from '../text/format.ts';
import type { Cost, Progress } from '../tracer/types.ts';
import './picture-ledger.css';

interface LedgerTools {
  force(id: EffectId, how: 'on' | 'off' | 'no'): void;
  /** Simulates one effect more, or one less. */
  build(by: 1 | -1): void;
  /** Chooses what the bars show. */
  by(measure: Measure): void;
  /** Traces the picture once more without each effect, to count the pixels that it changes. */
  measure(): void;
  /** Number of pictures that `measure` would trace; 0 if all pixels are counted. */
  readonly unmeasured: number;
  readonly isMeasuring: boolean;
  /** Traces the picture, and others that the ledger has, again and again to measure the time. */
  time(): void;
  stopTiming(): void;
  /** Null while no time is measured. */
  readonly timing: Timing | null;
  /** Whether the picture stands, so that its time can be measured. */
  readonly stands: boolean;
}

interface Timing {
  readonly repeat: number;
  readonly repeats: number;
  readonly msLeft: number;
}

interface LedgerHead {
  /** Null before the picture is finished. */
  readonly took: Pick<Progress, 'msSpent' | 'workers'> | null;
  /** Which picture it is: "752 × 424, 1 ray a pixel". */
  readonly resolution: string;
}

const SAMPLE_WORDS: Readonly<Record<number, string>> = {
  1: 'one through every pixel',
  4: 'four through every pixel',
  9: 'nine through every pixel',
  16: 'sixteen through every pixel',
};

/** What was simulated, why, and what it cost; then what was not, and why. */
export function ledger(
  model: LedgerModel,
  { took, resolution }: LedgerHead,
  tools: LedgerTools,
): TemplateResult {
  const { camera, simulated, idle, total, pixels, by, times } = model;
  const choice = picker(by, times !== null, tools);
  const row = (r: LedgerRow): TemplateResult => simulatedRow(r, by, pixels, tools);
  return html`${buildUp(model.built, tools)}<table class="ledger"
      ?data-timed=${times !== null}>
      <thead>
        <tr><th scope="col" data-quantity="resolution"
          data-value=${resolution}>${resolution}</th><th scope="col" class="bars">${choice}</th><th
          scope="col">rays</th><th scope="col">questions</th><th scope="col">roots</th><th
            scope="col">ms</th></tr>
      </thead>
      <tbody class="entry" data-effect="camera">
        <tr>
          <th scope="row">camera rays</th>
          ${bar(camera, by)} ${costCells(camera.cost, camera.time)}
        </tr>
        ${under(SAMPLE_WORDS[model.samples] ?? '', nothing)}
      </tbody>
      ${simulated.map(row)}
      <tbody class="entry total" data-effect="total">
        <tr>
          <th scope="row">picture</th>
          <td class="bars"></td>
          ${costCells(total.rays > 0 ? total : null, times?.work ?? null)}
        </tr>
      </tbody>
    </table>
    ${timeWords(model, took, tools)}
    ${kinds(model)}
    ${measureLine(tools)}
    ${
      idle.length === 0
        ? nothing
        : html`<h3 class="ledger-title">Not simulated</h3>
          <ul class="idle">${idle.map((one) => idleRow(one, pixels, tools))}</ul>`
    }`;
}

/** Adds one effect after another, or takes them away; a dot for each. */
function buildUp({ all, shown }: BuildUp, { build }: LedgerTools): TemplateResult | typeof nothing {
  if (all === 0) return nothing;
  const dots = Array.from(
    { length: all },
    (_, k) =>
      svg`<circle class=${k < shown ? 'in' : 'out'} cx=${9 + 18 * k} cy="9" r=${
        k === shown - 1 ? 6 : 3.6
      } />`,
  );
  const words = shown === 0 ? 'camera rays alone' : `${shown} of ${all} effects`;
  const step = (by: 1 | -1, label: string, sign: string): TemplateResult =>
    html`<button type="button" class="build-step" aria-label=${label} title=${label}
      @click=${() => build(by)}>${sign}</button>`;
  return html`<div class="build-up" role="group" aria-label="build up">build up
    ${step(-1, 'take the last effect away', '‹')}<svg viewBox="0 0 ${18 * all} 18"
      width=${18 * all} height="18" role="img" aria-label=${words} data-quantity="built"
      data-value=${shown}>${dots}</svg>${step(
        1,
        shown === all ? 'begin with camera rays alone' : 'add the next effect',
        '›',
      )} <span class="build-words">${words}</span></div>`;
}

function picker(by: Measure, timed: boolean, tools: LedgerTools): TemplateResult {
  return html`<label>bars by <select
    @change=${(e: Event) => tools.by((e.target as HTMLSelectElement).value as Measure)}>
    ${MEASURES.map(
      (measure) => html`<option value=${measure} ?selected=${measure === by}
      ?disabled=${measure === 'ms' && !timed}>${MEASURE_WORDS[measure]}</option>`,
    )}
  </select></label>`;
}

const SHOWS_WORDS: Readonly<Record<Shows, string>> = {
  yes: 'would show here',
  perhaps: 'may show here',
  no: 'not here',
};

/** The list of simplifications in every picture, and whether they would show in this one. */
export function simplifications(scene: Scene): TemplateResult {
  return html`<h3 class="ledger-title">Left out or simplified, in every picture</h3>
    <ul class="idle">
      ${SIMPLIFICATIONS.map(
        ({ title, how, reason, shows }) => html`<li class="idle-row" data-simplification=${title}>
          ${DASH}<span class="idle-name">${title}</span>
          <span class="idle-reason">${how}: ${reason}</span>
          <span class="idle-shows" data-quantity="shows.${title}"
            data-value=${shows(scene)}>${SHOWS_WORDS[shows(scene)]}</span>
        </li>`,
      )}
    </ul>`;
}

function simulatedRow(
  row: LedgerRow,
  by: Measure,
  pixels: number,
  tools: LedgerTools,
): TemplateResult {
  const forcedOn = row.forced === 'on';
  const reason = forcedOn
    ? html`<strong>forced on</strong>; ${needWords(row)}: ${row.reason}`
    : row.reason;
  const toggle = forcedOn
    ? button(row, 'no', RELEASE, tools)
    : button(row, 'off', 'force off', tools);
  const changes =
    row.pixels === null ? nothing : html`; changes ${changed(row, pixels)} of the pixels`;
  const price = forcedOn ? unforcedWords(row) : nothing;
  return html`<tbody class="entry" data-effect=${row.id}>
    <tr>
      <th scope="row">${row.title}${needed(row)}</th>
      ${bar(row, by)} ${costCells(row.cost, row.time)}
    </tr>
    ${under(html`${reason}${changes}${price}`, toggle)}
  </tbody>`;
}

/** What the picture costs without forcing. */
const unforcedWords = ({ unforced }: LedgerRow): TemplateResult | typeof nothing =>
  unforced
    ? html`; as called for the picture takes <span data-quantity="unforced"
      data-value=${shortest(unforced.work.low)}>${msWords(unforced.work.low)} ms</span> of work`
    : nothing;

/** The reason of a row. */
function under(
  reason: TemplateResult | string,
  toggle: TemplateResult | typeof nothing,
): TemplateResult {
  return html`<tr class="reason-row"><td colspan="6"><span
    class="reason-line"><span>${reason}</span>${toggle}</span></td></tr>`;
}

/** The bar of a row's share, placed where its share begins. */
function bar({ cost, share, from }: Shared, by: Measure): TemplateResult {
  const of = by === 'ms' ? 'of the time' : `of the ${MEASURE_WORDS[by]}`;
  const words = cost ? `${percent(share, 1)} ${of}` : '';
  return html`<td class="bars"><svg class="bar" viewBox="0 0 1000 8" preserveAspectRatio="none"
    role="img" aria-label=${words || 'not traced yet'} data-quantity="share"
    data-value=${shortest(share)}><title>${words}</title><rect class="part" x=${1000 * from}
      y="0" width=${1000 * share} height="8" /></svg></td>`;
}

type Shared = Pick<LedgerRow, 'cost' | 'share' | 'from'>;

function costCells(cost: Cost | null, time: Spread | null): TemplateResult {
  if (!cost) return html`<td></td><td></td><td></td><td></td>`;
  const cell = (key: 'rays' | 'questions' | 'roots'): TemplateResult =>
    html`<td data-quantity=${key} data-value=${cost[key]}>${grouped(cost[key])}</td>`;
  return html`${cell('rays')}${cell('questions')}${cell('roots')}${
    time
      ? html`<td data-quantity="ms" data-value=${shortest(time.low)}>${msWords(time.low)}
      <span class="to" data-quantity="ms.most" data-value=${shortest(time.high)}>to ${msWords(
        time.high,
      )}</span></td>`
      : html`<td class="unmeasured">–</td>`
  }`;
}

const needWords = ({ needed, leftOut }: LedgerRow): string =>
  needed ? 'needed' : leftOut ? 'left out' : 'not needed';

function needed(row: LedgerRow): TemplateResult {
  return html`<span class="visually-hidden" data-quantity="needed"
    data-value=${String(row.needed)}>, ${needWords(row)}</span>`;
}

/** What was waited for, what of it was work, and how to measure that. */
function timeWords(
  { times, total }: LedgerModel,
  took: LedgerHead['took'],
  tools: LedgerTools,
): TemplateResult | typeof nothing {
  if (total.rays === 0) return nothing;
  const { timing, stands } = tools;
  const act = (words: string): TemplateResult =>
    html`<button type="button" class="textual" @click=${tools.time}>${words}</button>`;
  if (timing) {
    const { repeat, repeats, msLeft } = timing;
    const left = Number.isNaN(msLeft) ? '' : `, about ${secondsWords(msLeft)} left`;
    const which = repeat === 0 ? 'warming up' : `repeat ${repeat} of ${repeats}`;
    return html`<p class="ledger-time" data-timing><span data-say>measuring the time</span>:
      ${which}${left}
      <button type="button" class="textual" @click=${tools.stopTiming}>stop</button></p>`;
  }
  if (times)
    return html`<p class="ledger-time" data-say>${measured(times)} ${act('measure again')}</p>`;
  if (!took || !stands) return html`<p class="ledger-time"></p>`;
  return html`<p class="ledger-time">${act('measure the time')}: again and again, by warm
    workers. This once it took <span data-quantity="took"
      data-value=${shortest(took.msSpent)}>${msWords(took.msSpent)} ms</span>.</p>`;
}

/** "Work of 2 workers ÷ 2 + rest = what you waited", with numbers. */
function measured({ typical, repeats, spread, busy, waited }: Times): TemplateResult {
  const { work, workers, rest } = typical;
  const number = (name: string, ms: number): TemplateResult =>
    html`<span data-quantity="time.${name}" data-value=${shortest(ms)}>${msWords(ms)} ms</span>`;
  const sum =
    workers === 1
      ? html`The worker’s ${number('work', work)}`
      : html`The work of <span data-quantity="time.workers"
        data-value=${workers}>${workers}</span> workers, ${number('work', work)}, ÷ ${workers}`;
  const tail = busy
    ? html` <strong>The machine was busy</strong>: one repeat in four took at least ${Math.round(
        100 * spread,
      )} % longer, so times may be too long.`
    : nothing;
  return html`${sum} + ${number('rest', rest)} start and end =
    <strong>${number('waited', typical.waited)}</strong>, what you waited. Lower quartile of
    ${repeats} repeats (<span class="to">upper: ${msWords(waited.high)} ms</span>); each row’s own
    quartiles stand in it, of all workers added up.${tail}`;
}

const secondsWords = (ms: number): string =>
  ms < 1500 ? 'a second' : `${grouped(Math.round(ms / 1000))} s`;

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
        ? html`<strong>forced off</strong>; needed: ${row.reason}${lost}${unforcedWords(row)}`
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

/** The work by kind of ray, and what the numbers count. */
function kinds({ kinds: of, saved, cut, total }: LedgerModel): TemplateResult | typeof nothing {
  if (total.rays === 0) return nothing;
  return html`<table class="kinds">
      <caption class="visually-hidden">the same by kind of ray</caption>
      <thead class="visually-hidden"><tr><th scope="col">kind</th><th scope="col">fired</th><th
        scope="col">rays</th><th scope="col">questions</th><th scope="col">roots</th></tr></thead>
      <tbody>${of.filter(({ rays }) => rays > 0).map(kindRow)}</tbody>
    </table>
    <p class="ledger-kinds">A question asks a surface about a ray; a root is one that counts, ahead
      of the start and between the heights. For that <span data-quantity="solves"
        data-value=${total.solves}>${grouped(total.solves)}</span> roots were worked out, found or
      not: often none is needed to say that a line misses a shape, and finite heights need the
      second one. <span data-quantity="rays.saved"
        data-value=${saved}>${grouped(saved)} rays</span> were not
      fired, since they could bring less than half a level of 255${
        cut > 0 ? html`, ${grouped(cut)} not after the last bounce` : nothing
      }. All of this is the same on every machine.</p>`;
}

/** Work of a kind, and the rays of each effect if several fire them. */
function kindRow({ kind, rays, questions, roots, parts }: KindRow): TemplateResult {
  const words = parts.map((part) => `${grouped(part.rays)} ${part.words}`).join(', ');
  const cell = (name: string, n: number): TemplateResult =>
    html`<td data-quantity="${name}.${kind}" data-value=${n}>${grouped(n)}</td>`;
  return html`<tr><th scope="row">${kind}</th><td class="kind-parts">${
    parts.length > 1 ? words : nothing
  }</td>${cell('rays', rays)}${cell('questions', questions)}${cell('roots', roots)}<td></td></tr>`;
}

function measureLine({ measure, unmeasured, isMeasuring }: LedgerTools): TemplateResult {
  if (isMeasuring)
    return html`<p class="measure" data-say>counting the pixels that each effect changes…</p>`;
  if (unmeasured === 0) return html`<p class="measure"></p>`;
  return html`<p class="measure"><button type="button" class="textual"
    @click=${measure}>count the pixels that each changes</button>, by tracing once without it</p>`;
}
