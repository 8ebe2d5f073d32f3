import { html, nothing, type TemplateResult } from 'lit';
import { findMethod } from '../math/shapes.ts';
import {
  BUDGET,
  type Budget,
  budgetWords,
  differenceWords,
  TRIED,
} from '../state/picture/budget.ts';
import { lessWords } from '../state/picture/comparison.ts';
import { grouped, msWords, percent } from '../state/picture/ledger.ts';
import type { Spread } from '../state/picture/times.ts';
import { type Cell, csv } from '../text/csv.ts';
import { display, shortest } from '../text/format.ts';
import { CLASSES } from '../tracer/budget.ts';
import type { TraceSettings } from '../tracer/types.ts';
import './picture-growth.css';

interface Candidate {
  readonly settings: TraceSettings;
  readonly step: 'whole' | 'effects' | 'bounces' | 'methods';
  readonly keeps: boolean;
  readonly seen: number;
  readonly over: number;
  readonly worst: number;
  readonly at: number;
  readonly counts: readonly number[];
  readonly questions: number;
  readonly time: Spread | null;
}

interface BudgetShown {
  readonly candidates: readonly Candidate[];
  readonly whole: Candidate | null;
  readonly tracing: Pick<Candidate, 'settings' | 'step'> | null;
  readonly timed: number;
  readonly runs: boolean;
  readonly chosen: Candidate | null;
  readonly width: number;
}

interface BudgetTools {
  /** Sets the text of the link; '' for none. */
  set(text: string): void;
  stop(): void;
  again(): void;
  /** Shows a picture beside the whole one. */
  show(settings: TraceSettings): void;
  pixel(x: number, y: number): void;
}

/** What the picture may differ by, the cheapest that keeps to it, and the proof. */
export function budgetPanel(
  budget: Budget | null,
  shown: BudgetShown | null,
  tools: BudgetTools,
): TemplateResult {
  return html`<section class="budget" aria-labelledby="budget-title">
    <div class="prices-head"><h2 id="budget-title">What a difference would save</h2></div>
    ${pickers(budget, tools)}
    ${budget && shown ? outcome(budget, shown, tools) : nothing}
  </section>`;
}

function pickers(budget: Budget | null, { set }: BudgetTools): TemplateResult {
  const [difference, part] = budget ? BUDGET.texts(budget) : ['', ''];
  const chosen = (event: Event): string => (event.target as HTMLSelectElement).value;
  const option = (value: string, words: string, current: string): TemplateResult =>
    html`<option value=${value} ?selected=${value === current}>${words}</option>`;
  return html`<p class="growth-words">The picture may differ from the whole one by
    <select aria-label="largest difference"
      @change=${(e: Event) => set(chosen(e) && BUDGET.write(chosen(e), part))}>
      ${option('', 'nothing yet', difference)}
      ${BUDGET.differences.map(({ value, words }) => option(value, `at most ${words}`, difference))}
    </select> <select aria-label="in how many pixels" ?disabled=${budget === null}
      @change=${(e: Event) => set(BUDGET.write(difference, chosen(e)))}>
      ${BUDGET.parts.map(({ value, words }) => option(value, words, part))}
    </select>${
      budget
        ? nothing
        : `: then ${TRIED.map(([, words]) => words).join('; then ')}. What breaks the budget is put
      back. Not every combination is tried, and rays to lights stay as many.`
    }</p>`;
}

function outcome(budget: Budget, shown: BudgetShown, tools: BudgetTools): TemplateResult {
  const { candidates, whole, tracing, runs, chosen, timed } = shown;
  const act = (words: string, run: () => void): TemplateResult =>
    html`<button type="button" class="textual" @click=${run}>${words}</button>`;
  const kept = candidates.filter(({ keeps }) => keeps).length;
  const busy = tracing
    ? html`tracing candidate ${candidates.length + 1}: ${nameOf(tracing)}; ${kept} of ${
        candidates.length
      } so far keep to it`
    : html`timing those that are left, ${percent(timed, 1)}`;
  const line = runs
    ? html`<p class="growth-words" data-budget-runs>${busy} ${act('stop', tools.stop)}</p>`
    : html`<p class="growth-words">${chosen ? nothing : 'Stopped. '}${act(
        'look again',
        tools.again,
      )}</p>`;
  return html`${chosen && whole ? result(budget, shown, chosen, whole, tools) : nothing}${line}${
    candidates.length > 0 ? traced(shown) : nothing
  }`;
}

function result(
  budget: Budget,
  shown: BudgetShown,
  chosen: Candidate,
  whole: Candidate,
  tools: BudgetTools,
): TemplateResult {
  const { candidates, width } = shown;
  const pixels = whole.seen;
  const by = methodOf(whole);
  const first = candidates.filter(({ step }) => step !== 'methods');
  const cheapest = first
    .filter(({ keeps }) => keeps)
    .reduce((best, one) => (one.questions < best.questions ? one : best), whole);
  const sentence = isSame(cheapest, whole)
    ? noneWords(first.length - 1, by)
    : html`Of ${grouped(first.length)} pictures by ${by} the cheapest that keeps to it is
        <strong data-quantity="budget.choice"
        data-value=${lessWords(cheapest.settings)}>${nameOf(cheapest)}</strong>. It asks
        <strong data-quantity="budget.share"
          data-value=${shortest(cheapest.questions / whole.questions)}>${percent(
            cheapest.questions,
            whole.questions,
          )}</strong> of the questions, ${grouped(cheapest.questions)} of ${grouped(
            whole.questions,
          )}.`;
  const { over, worst, at } = chosen;
  const { samples } = whole.settings;
  const rays = samples === 1 ? '1 ray a pixel' : `${samples} rays a pixel`;
  const place = at < 0 ? null : ([at % width, Math.floor(at / width)] as const);
  const which = isSame(chosen, cheapest) ? '' : `By ${methodOf(chosen)}: `;
  const proof = html`${which}All ${grouped(pixels)} pixels of both, with ${rays}, were compared
    before they were rounded to levels: <strong data-quantity="budget.over"
      data-value=${over}>${over === 0 ? 'none differs' : `${grouped(over)} differ`}</strong> by more
    than ${differenceWords(budget)}${
      budget.beyond > 0 ? `, ${grouped(Math.floor(budget.beyond * pixels))} may` : ''
    }${
      place
        ? html`; the worst by <span data-quantity="budget.worst"
          data-value=${shortest(worst)}>${display(worst, 3)} levels</span>, <button
            type="button" class="textual" @click=${() => tools.pixel(...place)}>pixel ${place.join(
              ', ',
            )}</button>`
        : nothing
    }.`;
  return html`<p class="budget-result">${sentence} ${timeWords(shown, chosen, whole)}</p>
    ${
      isSame(chosen, whole)
        ? nothing
        : html`<p class="growth-words">${proof} <button type="button" class="textual"
          @click=${() => tools.show(chosen.settings)}>show it beside the whole picture</button></p>
        ${classes(chosen)}`
    }`;
}

/** Why nothing is cheaper, where so many other pictures were traced. */
function noneWords(others: number, by: string): string {
  if (others === 0) return 'Only its camera rays ask questions: there is nothing to leave out.';
  const each = others === 1 ? 'the one other' : `each of the ${grouped(others)} other pictures`;
  return `Nothing cheaper was found: ${each} traced by ${by} differs by more or asks no less.`;
}

const isSame = (a: Candidate, b: Candidate): boolean => a.settings === b.settings;
const methodOf = ({ settings: { method } }: Pick<Candidate, 'settings'>): string =>
  findMethod(method)?.title ?? method;

/** Which methods keep to it too, and which of them took the least time. */
function timeWords(
  { candidates, runs, timed }: BudgetShown,
  chosen: Candidate,
  whole: Candidate,
): TemplateResult | string {
  if (runs && timed === 0) return '';
  const tried = candidates.filter(({ step }) => step === 'methods');
  const kept = tried.filter(({ keeps }) => keeps).length;
  const of = `${grouped(kept)} of ${grouped(tried.length)}`;
  const others = `${of} less accurate methods keep to it too`;
  if (runs) return `${others}; their time is being measured.`;
  if (!chosen.time || !whole.time) return `${others}.`;
  return html`${others}${
    kept > 0 ? html`; least time of those measured took <strong>${methodOf(chosen)}</strong>` : ''
  }: <span data-quantity="budget.ms" data-value=${shortest(
    chosen.time.low,
  )}>${msWords(chosen.time.low)} ms</span> of work here, the whole picture ${msWords(
    whole.time.low,
  )} ms.`;
}

/** What was found, for who listens; '' before. */
export function budgetSaid({ chosen, whole, runs }: BudgetShown): string {
  if (runs || !chosen || !whole) return '';
  if (isSame(chosen, whole)) return 'nothing cheaper was found that keeps to it';
  const share = percent(chosen.questions, whole.questions);
  return `cheapest that was found within it: ${nameOf(chosen)}, ${share} of the questions`;
}

/** How many pixels differ by how much. */
function classes({ counts, seen }: Candidate): TemplateResult {
  const rows = CLASSES.flatMap((end, k) => {
    const n = counts[k] ?? 0;
    return n > 0 ? [{ words: classWords(k), end, n }] : [];
  });
  return html`<table class="kinds budget-classes">
    <caption class="visually-hidden">pixels by their difference from the whole picture</caption>
    <thead><tr><th scope="col">difference</th><th scope="col">pixels</th><th
      scope="col">part</th></tr></thead>
    <tbody>${rows.map(
      ({ words, end, n }) => html`<tr><th scope="row">${words}</th><td
        data-quantity="budget.class" data-end=${end} data-value=${n}>${grouped(n)}</td><td
          >${percent(n, seen)}</td></tr>`,
    )}</tbody>
  </table>`;
}

/** CLASSES as half-open ranges, in levels or percent. */
function classWords(k: number): string {
  const [from, to] = [CLASSES[k - 1], CLASSES[k]];
  if (from === undefined) return 'the same';
  return `${sizeWords(from)} to ${sizeWords(to ?? 255)}`;
}

function sizeWords(levels: number): string {
  if (levels === 0) return '0';
  return levels <= 1 ? `${levels} of a level` : `${levels / 2.55} %`;
}

const nameOf = ({ settings, step }: Pick<Candidate, 'settings' | 'step'>): string =>
  step === 'whole' ? 'the whole picture' : lessWords(settings);

/** Everything that was tried, and why it was not taken. */
function traced({ candidates, whole, chosen }: BudgetShown): TemplateResult {
  const fate = ({ keeps, seen, over, worst, step }: Candidate): string => {
    if (step === 'whole') return 'what the others are compared with';
    if (keeps) return `keeps to it, ${grouped(over)} beyond, at most ${display(worst, 3)} levels`;
    return `broken after ${percent(seen, whole?.seen ?? seen)} of its pixels, by ${display(
      worst,
      3,
    )} levels`;
  };
  return html`<details class="budget-traced">
    <summary>${grouped(candidates.length)} pictures traced</summary>
    <ol>${candidates.map(
      (one) =>
        html`<li data-candidate=${one.step} data-keeps=${String(one.keeps)}>${
          one.settings === chosen?.settings ? html`<strong>${nameOf(one)}</strong>` : nameOf(one)
        }: ${fate(one)}${one.keeps ? `, ${grouped(one.questions)} questions` : ''}${
          one.time ? `, ${msWords(one.time.low)} ms` : ''
        }</li>`,
    )}</ol>
  </details>`;
}

/** What was traced as CSV, a picture a line. */
export function budgetCsv(budget: Budget, { candidates }: BudgetShown): string {
  return csv([
    [
      ...['picture', 'budget', 'keeps it', 'pixels compared', 'pixels beyond', 'worst levels'],
      ...['questions', 'ms lower quartile', 'ms upper quartile'],
    ],
    ...candidates.map((one): readonly Cell[] => [
      ...[nameOf(one), budgetWords(budget), one.keeps, one.seen, one.over, one.worst],
      ...[one.questions, one.time?.low, one.time?.high],
    ]),
  ]);
}
