import { html, nothing, type TemplateResult } from 'lit';
import type { Picked } from '../../charts/hardness-model.ts';
import type { MeasuredRow } from '../../lab/session.ts';
import type { Summary } from '../../lab/summary.ts';
import { DIAL_FAMILIES } from '../../lab/sweep.ts';
import { type Dial, FAMILIES, findFamily } from '../../math/families.ts';
import { type Choice, tabs } from '../../panels/choices.ts';
import { titleOf } from '../../state/accuracy/frontier.ts';
import { dialTitle } from '../../state/accuracy/hardness.ts';
import { type AccuracySettings, COSTS, WORTHS } from '../../state/accuracy/settings.ts';
import { display } from '../../text/format.ts';
import type { ExportItem } from '../export-dialog.ts';
import { extensionOf, saveButtons } from './exports.ts';
import '../../ui/slider.ts';

type Set = (settings: Partial<AccuracySettings>) => void;

const short = (id: string, title: string): Choice => ({ id, title });
const TIMED: readonly Choice[] = [
  short('typical', 'typical'),
  short('far-origin', 'far away'),
  short('near-tangent', 'near tangent'),
  short('near-surface', 'near surface'),
];
/** As the tab or the list has it. */
export const familyName = (id: string): string =>
  TIMED.find((one) => one.id === id)?.title ?? findFamily(id)?.title ?? id;

const SWEPT: readonly Choice[] = [
  short('far-origin', 'distance'),
  short('near-tangent', 'tangency'),
  short('near-axis', 'generator angle'),
  short('scale-world', 'scale'),
];
const others = (families: readonly Choice[], shown: readonly Choice[]): readonly Choice[] =>
  families.filter(({ id }) => !shown.some((one) => one.id === id));

/** What stands above the frontier: which rays, which axes, and the sentence. */
export function frontierHead(
  settings: AccuracySettings,
  sentence: string,
  saves: readonly ExportItem[],
  set: Set,
): TemplateResult {
  const { family, worth, cost, dial } = settings;
  const own = findFamily(family)?.dial;
  return html`<div class="acc-title">
      <h2>Digits against time</h2>
      ${tabs('Rays to measure', TIMED, family, (id) => set({ family: id, dial: null }), others(FAMILIES, TIMED))}
    </div>
    <div class="acc-options">
      ${tabs('Upwards', WORTHS, worth, (id) => set({ worth: id as AccuracySettings['worth'] }))}
      ${tabs('Time as', COSTS, cost, (id) => set({ cost: id as AccuracySettings['cost'] }))}
      <span class="acc-save">${saveButtons(saves, extensionOf)}</span>
    </div>
    ${own ? dialRow(own, dial, set) : nothing}
    <p class="acc-sentence" role="status">${sentence}</p>`;
}

const STEPS = 100;

function dialRow(dial: Dial, at: number | null, set: Set): TemplateResult {
  const { title, usual, range } = dial;
  const usually = usual[0] === usual[1] ? `${usual[0]}` : `${usual[0]} … ${usual[1]}`;
  const now = at === null ? usually : display(at, 3);
  return html`<label class="acc-dial">
    <span>${dialTitle(dial)}${/k/.test(title) ? ', k' : ''} = ${now}</span>
    <graze-slider .value=${at ?? (usual[0] + usual[1]) / 2} .least=${range[0]} .most=${range[1]} .step=${(range[1] - range[0]) / STEPS} .label=${title}
      @graze-value=${({ detail }: CustomEvent<number>) => set({ dial: detail })}></graze-slider>
    <button type="button" class="acc-link" ?hidden=${at === null} @click=${() => set({ dial: null })}>as usual</button>
  </label>`;
}

export function hardnessHead(
  { hard }: AccuracySettings,
  saves: readonly ExportItem[],
  set: Set,
): TemplateResult {
  return html`<div class="acc-title">
      <h2>How hard can it get</h2>
      ${tabs('Difficulty', SWEPT, hard, (id) => set({ hard: id }), others(DIAL_FAMILIES, SWEPT))}
    </div>
    <div class="acc-options">
      <p class="acc-idea">${findFamily(hard)?.idea ?? ''}</p>
      <span class="acc-save">${saveButtons(saves, extensionOf)}</span>
    </div>`;
}

/** Where the frontier will stand. */
export function emptyFrontier(
  rows: readonly MeasuredRow[],
  running: boolean,
  measure: () => void,
): TemplateResult {
  const words = running
    ? 'Measuring: the first round is under way.'
    : rows.some(({ roots }) => roots)
      ? 'No ray of this family has a root to have digits: look at the wrong verdicts instead.'
      : 'Not measured yet.';
  return html`<div class="plot-empty">
    <p>${words}</p>
    ${running || rows.length > 0 ? nothing : html`<button type="button" class="button primary" @click=${measure}>Measure</button>`}
  </div>`;
}

/** The point that was picked, in numbers, and the ways to one of its rays, with its method. */
export function pickedWords(
  picked: Picked | null,
  quality: Summary | null,
  { open, take }: { readonly open: () => void; readonly take: () => void },
): TemplateResult {
  if (!picked || !quality)
    return html`<p class="acc-hint">Choose a point to see one of its rays.</p>`;
  const { wrong, undecided, rays, digits, leastDigits } = quality;
  return html`<p>
    <b>${titleOf(picked.id)}</b>: ${wrong} of ${rays} verdicts wrong, ${undecided} undecided; digits ${display(digits, 3)} in 9 rays of 10, ${display(leastDigits, 3)} in the worst.
    ${quality.worst ? html`Its worst ray: <button type="button" class="acc-link" @click=${open}>open in Explore</button> <button type="button" class="acc-link" @click=${take}>make it “This ray”</button>` : nothing}
  </p>`;
}
