import { html, nothing, svg, type TemplateResult } from 'lit';
import { type Heat, placeOf } from '../state/picture/heat.ts';
import { grouped, percent } from '../state/picture/ledger.ts';
import { display } from '../text/format.ts';
import { type Comparison, OTHER_VERDICT } from '../tracer/compare.ts';
import './picture-map.css';

/** What the map beside the picture shows. */
export type MapShow = 'questions' | 'roots' | 'rays' | 'errors';

export type MapWords =
  | { readonly show: 'errors'; readonly comparison: Comparison }
  | {
      readonly show: Exclude<MapShow, 'errors'>;
      readonly values: Uint32Array;
      readonly heat: Heat;
    };

const TITLES: Readonly<Record<MapShow, string>> = {
  questions: 'What each pixel cost',
  roots: 'What each pixel cost',
  rays: 'What each pixel cost',
  errors: 'Where the pictures differ',
};

/** The title and the tabs above the map. */
export function mapHead(
  show: MapShow,
  comparing: boolean,
  choose: (what: MapShow) => void,
): TemplateResult {
  const all: readonly MapShow[] = comparing
    ? ['questions', 'roots', 'rays', 'errors']
    : ['questions', 'roots', 'rays'];
  const key = (event: KeyboardEvent): void => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const next = (all.indexOf(show) + step + all.length) % all.length;
    choose(all[next] ?? show);
    const list = event.currentTarget as HTMLElement;
    list.querySelectorAll<HTMLElement>('[role="tab"]')[next]?.focus();
  };
  return html`<h2>${TITLES[show]}</h2>
    <div class="map-tabs" role="tablist" aria-label="what the map shows" @keydown=${key}>${all.map(
      (what) => html`<button type="button" role="tab" aria-selected=${what === show}
        tabindex=${what === show ? 0 : -1} @click=${() => choose(what)}>${what}</button>`,
    )}</div>`;
}

/** In place of a map whose picture is not whole. */
export const NOT_TRACED = 'not traced yet';

/** The scale under the map, the number of a pixel on it, and one sentence. */
export function mapScale(
  words: MapWords | null,
  pixel: readonly [number, number] | null,
  width: number,
): TemplateResult | typeof nothing {
  if (!words) return html`<p class="map-pixel">${NOT_TRACED}</p>`;
  const at = pixel && pixel[1] * width + pixel[0];
  return words.show === 'errors'
    ? errorScale(words.comparison, pixel, at)
    : heatScale(words.show, words.values, words.heat, pixel, at);
}

const W = 244;

function heatScale(
  unit: string,
  values: Uint32Array,
  heat: Heat,
  pixel: readonly [number, number] | null,
  at: number | null,
): TemplateResult {
  const value = at === null ? null : (values[at] ?? 0);
  const x = (n: number): number => 1 + placeOf(heat, n) * (W - 2);
  const written = apart(heat.ticks, x);
  const near = (n: number): boolean => value !== null && Math.abs(x(n) - x(value)) < 26;
  return html`<div class="map-line">
      <svg class="map-scale" viewBox="0 0 ${W} 34" width=${W} height="34" aria-hidden="true">
        <defs><linearGradient id="map-ink"><stop offset="0" class="map-least" /><stop
          offset="1" class="map-most" /></linearGradient></defs>
        <rect x="0.5" y="0.5" width=${W - 1} height="9" fill="url(#map-ink)" class="map-box" />
        ${heat.ticks.map(
          (n) =>
            svg`<line class="map-tick" x1=${x(n)} x2=${x(n)} y1="10" y2="14" />${
              near(n) || !written.has(n) ? nothing : tick(n, x(n))
            }`,
        )}
        ${
          value === null || value === 0
            ? nothing
            : svg`<path class="map-mark" d="M${x(value)} 11 l-6 9 h12 z" /><text
              class="map-value" x=${clamped(x(value))} y="33" text-anchor="middle">${grouped(
                value,
              )}</text>`
        }
      </svg>
      <p class="map-words"><span>A tenth of the pixels has <strong data-quantity="tenth"
        data-value=${heat.tenth}>${percent(heat.tenth, 1)}</strong> of the ${unit}.</span>
        <span class="map-sum"><span data-quantity="sum" data-value=${heat.sum}>${grouped(
          heat.sum,
        )}</span> in all, ${display(heat.mean, 3)} a pixel; the more ink the more,
          by logarithm</span></p>
    </div>
    <p class="map-pixel">${
      pixel && value !== null
        ? html`pixel ${pixel.join(', ')}: <strong data-quantity="pixel.${unit}"
          data-value=${value}>${grouped(value)} ${unit}</strong>${timesMean(value, heat)}`
        : 'Point at a pixel to read its number.'
    }</p>`;
}

const clamped = (x: number): number => Math.min(Math.max(x, 16), W - 16);

const anchorOf = (x: number): 'start' | 'middle' | 'end' =>
  x < 8 ? 'start' : x > W - 8 ? 'end' : 'middle';

const tick = (n: number, x: number) =>
  svg`<text class="map-number" x=${x} y="25" text-anchor=${anchorOf(x)}>${grouped(n)}</text>`;

/** Width in px of a digit of the scale's numbers, at most. */
const DIGIT = 7;
/** Part of a number's width that is left of where it is anchored. */
const LEFT = { start: 0, middle: 0.5, end: 1 } as const;

/** Those of these numbers, ascending, that touch no other at their place: both ends are kept. */
export function apart(numbers: readonly number[], x: (n: number) => number): Set<number> {
  const span = (n: number): readonly [number, number] => {
    const width = grouped(n).length * DIGIT;
    const from = x(n) - LEFT[anchorOf(x(n))] * width;
    return [from, from + width];
  };
  const kept: number[] = [];
  const ends = [numbers.at(-1), numbers[0]].filter((n) => n !== undefined);
  for (const n of [...ends, ...numbers.slice(1, -1)]) {
    const [from, to] = span(n);
    const touches = kept.some((other) => {
      const [otherFrom, otherTo] = span(other);
      return from < otherTo + DIGIT / 2 && otherFrom < to + DIGIT / 2;
    });
    if (!touches || ends.includes(n)) kept.push(n);
  }
  return new Set(kept);
}

function timesMean(value: number, { mean }: Heat): string {
  const times = value / mean;
  if (!(times >= 1.1)) return times > 0.9 ? ', the mean' : `, ${display(times, 2)} of the mean`;
  return `, ${display(times, 2)} times the mean`;
}

function errorScale(
  { digits, levels, map }: Comparison,
  pixel: readonly [number, number] | null,
  at: number | null,
): TemplateResult {
  const swatch = (shade: string, words: string): TemplateResult =>
    html`<li><span class="swatch ${shade}" aria-hidden="true"></span>${words}</li>`;
  return html`<ul class="map-key">
      ${swatch('surface', 'another surface, or none')}${swatch('colour', 'another colour')}
      <li><span class="swatch digits" aria-hidden="true"></span>1 to 16 digits of t lost</li>
      ${swatch('same', 'the same bits')}
    </ul>
    <p class="map-pixel">${
      pixel && at !== null
        ? html`pixel ${pixel.join(', ')}: ${pixelError(map[at], levels[at] ?? 0, digits[at] ?? 0)}`
        : 'Point at a pixel to read its number.'
    }</p>`;
}

function pixelError(kind: number | undefined, level: number, lost: number): TemplateResult {
  const colour =
    level === 0
      ? 'the same colour'
      : html`<strong data-quantity="pixel.levels"
          data-value=${level}>${level} of 255 levels</strong> apart`;
  if (kind === OTHER_VERDICT) return html`another surface, ${colour}`;
  const t = Number.isNaN(lost)
    ? 'nothing is hit'
    : lost === 0
      ? 'no digit of t lost'
      : `${display(lost, 2)} digits of t lost`;
  return html`${colour}, ${t}`;
}
