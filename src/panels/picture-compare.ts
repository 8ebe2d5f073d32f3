import { html, nothing, type TemplateResult } from 'lit';
import type { Scene } from '../scene/types.ts';
import {
  causeWords,
  mainOptions,
  type SideOption,
  sideOptions,
} from '../state/picture/compare-words.ts';
import { AGAINST, type Against, sideWords } from '../state/picture/comparison.ts';
import { grouped, percent } from '../state/picture/ledger.ts';
import { display, shortest } from '../text/format.ts';
import type { Comparison } from '../tracer/compare.ts';
import type { TraceSettings } from '../tracer/types.ts';
import './picture-compare.css';

export interface CompareTools {
  /** Chooses what the left side differs in; '' ends the comparison. */
  left(value: string): void;
  /** 'method:…' or 'start:…' */
  right(value: string): void;
}

/** A picker above each side, which names what differs. */
export function sidePickers(
  scene: Scene,
  settings: TraceSettings,
  other: TraceSettings,
  against: Against,
  tools: CompareTools,
): TemplateResult {
  const current = AGAINST.write(against);
  return html`${side(
    'left',
    sideOptions(scene, settings, against),
    current,
    tools.left,
    [{ value: '', words: 'no comparison' }],
    sideWords(other, against),
  )}
  ${side(
    'right',
    mainOptions(settings),
    '=',
    tools.right,
    [{ value: '=', words: sideWords(settings, against) }],
    sideWords(settings, against),
  )}`;
}

function side(
  name: 'left' | 'right',
  options: readonly SideOption[],
  current: string,
  pick: (value: string) => void,
  more: readonly SideOption[],
  words: string,
): TemplateResult {
  const changed = (event: Event): void => {
    const { value } = event.target as HTMLSelectElement;
    if (value !== '=') pick(value);
  };
  return html`<select class="side side-${name}" aria-label=${`${name} side`} title=${words}
    @change=${changed}>
    ${[...more, ...options].map(
      ({ value, words: text }) =>
        html`<option value=${value} ?selected=${value === current}>${text}</option>`,
    )}
  </select>`;
}

interface ComparisonShown {
  /** Null until both pictures are finished. */
  readonly found: Comparison | null;
  readonly trustsLeft: boolean;
}

/** Words on how many pixels differ, why, and in which ways. */
export function comparisonWords(
  scene: Scene,
  settings: TraceSettings,
  against: Against,
  { found, trustsLeft }: ComparisonShown,
): TemplateResult {
  const cause = causeWords(scene, settings, against);
  return html`<p class="compare-sentence">${
    found
      ? html`<strong data-quantity="differing" data-value=${found.differing}
        title=${`${grouped(found.differing)} of ${grouped(found.pixels)} pixels`}
        >${
          found.differing === 0 ? 'None' : percent(found.differing, found.pixels)
        }</strong> of the pixels differ${
          found.differing > 0 ? html` (${grouped(found.differing)})` : nothing
        }. `
      : nothing
  }${cause}</p>
  <p class="compare-counts">${found ? counts(found, trustsLeft ? 'right' : 'left') : nothing}</p>`;
}

/** @param side the less accurate one; 'left' if both are equally accurate. */
function counts(
  { verdicts, holes, ghosts, others, mostDigits }: Comparison,
  side: 'left' | 'right',
): TemplateResult {
  const lost = Number.isNaN(mostDigits)
    ? nothing
    : html`; where both hit the same, <span data-quantity="digits"
      data-value=${shortest(mostDigits)}>${
        mostDigits === 0 ? 'no digit' : `at most ${display(mostDigits, 3)} digits`
      }</span> of t lost`;
  const count = (name: string, n: number): TemplateResult =>
    html`<span data-quantity=${name} data-value=${n}>${grouped(n)}</span>`;
  const kinds =
    verdicts > 0
      ? html`: on the ${side} ${count('holes', holes)} lose their hit, ${count(
          'ghosts',
          ghosts,
        )} hit where nothing is, ${count('others', others)} hit another surface`
      : nothing;
  return html`<span
    class="counts">${count(
      'verdicts',
      verdicts,
    )} other verdicts of camera rays${kinds}${lost}</span>`;
}
