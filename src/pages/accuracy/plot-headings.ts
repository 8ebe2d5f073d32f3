import { html, nothing, type TemplateResult } from 'lit';
import type { Picked } from '../../charts/hardness-model.ts';
import type { Summary } from '../../lab/summary.ts';
import { DIAL_FAMILIES } from '../../lab/sweep.ts';
import { type Dial, FAMILIES, findFamily } from '../../math/families.ts';
import { type Choice, tabs } from '../../panels/choices.ts';
import { type Column, targetTitle } from '../../state/accuracy/column.ts';
import { titleOf } from '../../state/accuracy/frontier.ts';
import { dialTitle } from '../../state/accuracy/hardness.ts';
import { type AccuracySettings, ORDERS, TARGETS, WORTHS } from '../../state/accuracy/settings.ts';
import { display } from '../../text/format.ts';
import type { ExportItem } from '../export-dialog.ts';
import { extensionOf, saveButtons } from './exports.ts';
import { TIMED } from './family-name.ts';
import '../../ui/slider.ts';

type Set = (settings: Partial<AccuracySettings>) => void;

const short = (id: string, title: string): Choice => ({ id, title });
const SWEPT: readonly Choice[] = [
  short('far-origin', 'distance'),
  short('near-tangent', 'tangency'),
  short('near-axis', 'generator angle'),
  short('scale-world', 'scale'),
];
const others = (families: readonly Choice[], shown: readonly Choice[]): readonly Choice[] =>
  families.filter(({ id }) => !shown.some((one) => one.id === id));

/** The first sentence, and controls for target, worth and rays. */
export function answerHead(
  settings: AccuracySettings,
  { target, why }: Column,
  words: { readonly headline: string; readonly details: string },
  set: Set,
): TemplateResult {
  const { family, worth, order, dial } = settings;
  const own = findFamily(family)?.dial;
  const instead = why ? `Compared in ${targetTitle(target)}: ${why} ` : '';
  const targets = tabs('Kernels', TARGETS, target, (id) =>
    set({ target: id as AccuracySettings['target'] }),
  );
  const orders = tabs('Order of the rays', ORDERS, order, (id) =>
    set({ order: id as AccuracySettings['order'] }),
  );
  const rays = tabs(
    'Rays to measure',
    TIMED,
    family,
    (id) => set({ family: id, dial: null }),
    others(FAMILIES(), TIMED),
  );
  const upwards = tabs('Upwards', WORTHS, worth, (id) =>
    set({ worth: id as AccuracySettings['worth'] }),
  );
  return html`<div class="acc-answer">
      <h2 class="acc-sentence"><span ?data-say=${words.headline !== ''}>${
        words.headline || 'What does a right answer cost?'
      }</span></h2>
      <div class="acc-compare">
        ${targets}
        <span class="acc-order">order ${orders}</span>
      </div>
    </div>
    <p class="acc-details">${instead}${words.details}</p>
    <div class="acc-title">
      ${rays}
      <span class="acc-worth">${upwards}</span>
    </div>
    ${own ? dialRow(own, dial, set) : nothing}`;
}

const STEPS = 100;

function dialRow(dial: Dial, at: number | null, set: Set): TemplateResult {
  const { title, usual, range } = dial;
  const usually = usual[0] === usual[1] ? `${usual[0]}` : `${usual[0]} … ${usual[1]}`;
  const now = at === null ? usually : display(at, 3);
  return html`<label class="acc-dial">
    <span>${dialTitle(dial)}${/k/.test(title) ? ', k' : ''} = ${now}</span>
    <graze-slider .value=${at ?? (usual[0] + usual[1]) / 2}
      .least=${range[0]} .most=${range[1]} .step=${(range[1] - range[0]) / STEPS} .label=${title}
      @graze-value=${({ detail }: CustomEvent<number>) => set({ dial: detail })}></graze-slider>
    <button type="button" class="acc-link" ?hidden=${at === null}
      @click=${() => set({ dial: null })}>as usual</button>
  </label>`;
}

/** Buttons to save a plot. */
export const plotSaves = (saves: readonly ExportItem[]): TemplateResult =>
  html`<span class="acc-save">${saveButtons(saves, extensionOf)}</span>`;

export function hardnessHead({ hard }: AccuracySettings, set: Set): TemplateResult {
  return html`<div class="acc-title">
      <h2>How hard can it get</h2>
      ${tabs('Difficulty', SWEPT, hard, (id) => set({ hard: id }), others(DIAL_FAMILIES, SWEPT))}
    </div>`;
}

/** Why these rays are hard; and the picked point, with buttons for one of its rays. */
export function hardnessWords(
  { hard }: AccuracySettings,
  picked: Picked | null,
  quality: Summary | null,
  { open, take }: { readonly open: () => void; readonly take: () => void },
): TemplateResult {
  const hint = html`<p class="acc-hint">Choose a point to see one of its rays.</p>`;
  return html`<p class="acc-idea">${findFamily(hard)?.idea ?? ''}</p>
    ${picked && quality ? pickedWords(picked, quality, open, take) : hint}`;
}

function pickedWords(
  { id }: Picked,
  { wrong, undecided, rays, digits, leastDigits, worst }: Summary,
  open: () => void,
  take: () => void,
): TemplateResult {
  const ways = html`Its worst ray:
    <button type="button" class="acc-link" @click=${open}>open in Explore</button>
    <button type="button" class="acc-link" @click=${take}>make it “This ray”</button>`;
  return html`<p>
    <b>${titleOf(id)}</b>: ${wrong} of ${rays} verdicts wrong, ${undecided} undecided;
    digits ${display(digits, 3)} in 9 rays of 10, ${display(leastDigits, 3)} in the worst.
    ${worst ? ways : nothing}
  </p>`;
}
