import { html, nothing, svg, type TemplateResult } from 'lit';
import type { Freedom } from '../../lesson/freedom.ts';
import { symbol } from '../../panels/formula.ts';
import { classOf } from '../../panels/symbols.ts';
import { display, shortest } from '../../text/format.ts';
import '../../ui/slider.ts';

/** Mark on the slider's track: the guess, and the true value once it is shown. */
export interface SliderMark {
  readonly at: number;
  readonly truth: number | null;
}

interface SliderParts {
  readonly freedom: Freedom;
  readonly value: number;
  readonly mark: SliderMark | null;
  readonly send: (value: number) => void;
  /** Whether the slider moves the mark of a guess and not the number itself. */
  readonly guessing: boolean;
}

const TICKS = 4;

/** The slider of a step: its symbol, a track with numbers under it, the value. */
export function sliderView({ freedom, value, mark, send, guessing }: SliderParts): TemplateResult {
  const { name, symbol: letter, title, range, step } = freedom;
  const axis = name.split('.')[1] ?? null;
  const cls = classOf(letter, axis === null ? 'scalar' : 'vector');
  const label = guessing ? `your guess of ${name}` : `${name}, ${title}`;
  return html`<div class="lesson-slider ${cls}"
    data-symbol=${name}
    @graze-value=${(event: CustomEvent<number>) => send(event.detail)}>
    <span class="letter">${symbol(letter, axis, cls, name)}</span>
    <span class="track">
      ${mark ? gap(mark, range) : nothing}
      <graze-slider
        .value=${value}
        .least=${range[0]}
        .most=${range[1]}
        .step=${step}
        .label=${label}
        .symbol=${name}
      ></graze-slider>
      ${ticks(range, mark)}
    </span>
    <span class="live ${cls}"
      data-quantity=${guessing ? nothing : name}
      data-value=${guessing ? nothing : shortest(value)}>${display(value)}</span>
  </div>`;
}

type Range = readonly [number, number];

const share = (x: number, [least, most]: Range): number =>
  (100 * (Math.min(Math.max(x, least), most) - least)) / (most - least);

/** Numbers under the track, and the mark at its value. */
function ticks(range: Range, mark: SliderMark | null): TemplateResult {
  const all = Array.from(
    { length: TICKS + 1 },
    (_, i) => range[0] + ((range[1] - range[0]) * i) / TICKS,
  );
  return html`<svg class="lesson-ticks" height="30" aria-hidden="true">
    ${all.map(
      (x) => svg`<line x1="${share(x, range)}%" x2="${share(x, range)}%" y1="0" y2="7" />
        <text x="${share(x, range)}%" y="25">${display(x, 3)}</text>`,
    )}
    ${
      mark
        ? svg`<svg x="${share(mark.at, range)}%" y="1"
      overflow="visible"><path class="mark" d="M0 0L6 10H-6Z" /></svg>`
        : nothing
    }
  </svg>`;
}

/** The distance from the guess to the true value. */
function gap({ at, truth }: SliderMark, range: Range): TemplateResult | typeof nothing {
  if (truth === null || at === truth) return nothing;
  const [a, b] = [share(at, range), share(truth, range)];
  const ends = [a, b].map((x) => svg`<line x1="${x}%" x2="${x}%" y1="18" y2="26" />`);
  return html`<svg class="lesson-gap" height="28" aria-hidden="true">
    ${svg`<line x1="${a}%" x2="${b}%" y1="22" y2="22" />`}${ends}
    ${svg`<text x="${(a + b) / 2}%" y="14">${display(Math.abs(at - truth), 3)}</text>`}
  </svg>`;
}
