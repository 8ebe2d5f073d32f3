import { html, nothing, svg, type TemplateResult } from 'lit';
import { BUSY } from '../lab/price.ts';
import { quartiles } from '../lab/stats.ts';
import { grouped, MEASURE_WORDS, type Measure } from '../state/picture/ledger.ts';
import type { Spread } from '../state/picture/times.ts';
import { type Cell, csv } from '../text/csv.ts';
import { display } from '../text/format.ts';
import { FEWEST, numberOf, type Priced, type Slope, slopeOf, WITHIN } from '../tracer/growth.ts';
import type { Cost } from '../tracer/types.ts';
import './picture-growth.css';

interface Series {
  readonly id: string;
  readonly title: string;
  readonly one: string;
  readonly how: string;
  readonly points: readonly {
    readonly x: number;
    readonly work: Cost | null;
    readonly time: Spread | null;
  }[];
}

interface GrowthShown {
  readonly series: readonly Series[];
  readonly repeat: number;
  readonly repeats: number;
  readonly runs: boolean;
  readonly share: number;
  readonly msLeft: number;
}

interface GrowthTools {
  /** Whether the picture stands, so that it can be measured. */
  readonly stands: boolean;
  measure(): void;
  stop(): void;
  again(): void;
  /** Takes the plots away. */
  close(): void;
}

/** What of a price is drawn: work by a measure, and the time if it is known. */
interface Lines {
  readonly work: readonly Priced[];
  readonly time: readonly Priced[];
}

/** How the price of the picture grows with one number after another, as small plots. */
export function growthPanel(
  shown: GrowthShown | null,
  by: Measure,
  tools: GrowthTools,
): TemplateResult {
  const measure = by === 'ms' ? 'questions' : by;
  return html`<section class="growth" aria-labelledby="growth-title">
    <div class="prices-head"><h2 id="growth-title">How the price grows</h2>
      <p class="prices-note">${
        shown ? 'both axes logarithmic, on one scale: 45° is linear' : nothing
      }</p></div>
    ${shown ? plots(shown, measure) : nothing}
    ${doing(shown, measure, tools)}
  </section>`;
}

function doing(
  shown: GrowthShown | null,
  measure: Exclude<Measure, 'ms'>,
  tools: GrowthTools,
): TemplateResult {
  const act = (words: string, run: () => void): TemplateResult =>
    html`<button type="button" class="textual" @click=${run}>${words}</button>`;
  if (!shown) {
    return html`<p class="growth-words">${
      tools.stands ? act('measure it', tools.measure) : 'To be measured when the picture stands'
    }: with pixels, rays a pixel, lights, bounces and shapes, first the work, then the time.</p>`;
  }
  const { runs, repeat, repeats, share, msLeft } = shown;
  if (runs) {
    const left = Number.isNaN(msLeft) ? '' : `, about ${grouped(Math.ceil(msLeft / 1000))} s left`;
    const what = repeat === 0 ? 'counting the work' : `times, repeat ${repeat} of ${repeats}`;
    return html`<p class="growth-words" data-growing><svg class="growth-bar"
      viewBox="0 0 72 6" width="72" height="6" aria-hidden="true"><rect class="all" width="72"
        height="6" /><rect width=${72 * share} height="6" /></svg> ${what}${left}
      ${act('stop', tools.stop)}</p>`;
  }
  const complete = share === 1;
  const isBusy = complete && busy(shown);
  return html`<p class="growth-words"><span class="line-key" aria-hidden="true"></span>
    ${MEASURE_WORDS[measure]}, the same on every machine${
      complete
        ? html`; <span class="line-key dashed" aria-hidden="true"></span> time here, lower quartile
          of ${repeats} repeats, all workers added up`
        : ''
    }. Linear: a + b·x is within ${percent(WITHIN)} of every point, or within its quartiles;
      logarithmic: a + b·log x is; constant: it varies by less; from ${FEWEST} points on.
      ${complete ? '' : 'Stopped. '}${
        isBusy ? html`<strong>The machine was busy</strong>, so times may be too long. ` : ''
      }${act('measure again', tools.again)}
    ${act('close', tools.close)}</p>`;
}

/** Whether the spread of most times is that of a busy machine. */
function busy({ series }: GrowthShown): boolean {
  const spreads = series.flatMap(({ points }) =>
    points.flatMap(({ time }) => (time ? [time.high / time.low - 1] : [])),
  );
  return quartiles(spreads).median > BUSY;
}

const percent = (part: number): string => `${display(100 * part, 2)} %`;

/** px of a decade, of the margins around a plot, and of its width for what ranges over least. */
const DECADE = 42;
const SIDE = 6;
const TOP = 9;
const LEAST_WIDTH = 92;

function plots({ series }: GrowthShown, measure: Exclude<Measure, 'ms'>): TemplateResult {
  const all = series.map((one) => ({ one, lines: linesOf(one, measure) }));
  const heights = all.flatMap(({ lines: { work, time } }) =>
    [work, time].flatMap((line) => line.map(({ y }) => decades(y, line[0]?.y ?? y))),
  );
  const low = Math.min(0, ...heights);
  const high = Math.max(1, ...heights);
  return html`<ul class="growth-plots">${all.map(({ one, lines }) =>
    plot(one, lines, measure, [low, high]),
  )}</ul>`;
}

const decades = (value: number, first: number): number =>
  value > 0 && first > 0 ? Math.log10(value / first) : 0;

function linesOf({ points }: Series, measure: Exclude<Measure, 'ms'>): Lines {
  return {
    work: points.flatMap(({ x, work }) => (work ? [{ x, y: work[measure] }] : [])),
    time: points.flatMap(({ x, time }) =>
      time ? [{ x, y: time.low, low: time.low, high: time.high }] : [],
    ),
  };
}

function plot(
  series: Series,
  { work, time }: Lines,
  measure: Exclude<Measure, 'ms'>,
  [low, high]: readonly [number, number],
): TemplateResult {
  const { id, title, how, points } = series;
  const [from, to] = [points[0]?.x ?? 1, points.at(-1)?.x ?? 1];
  const inner = DECADE * decades(to, from);
  const width = Math.max(LEAST_WIDTH, inner + 2 * SIDE);
  const height = DECADE * (high - low) + 2 * TOP;
  const px = (x: number): number => SIDE + DECADE * decades(x, from);
  const py = (up: number): number => TOP + DECADE * (high - up);
  const path = (line: readonly Priced[]): string =>
    line
      .map(({ x, y }, k) => `${k ? 'L' : 'M'}${px(x)} ${py(decades(y, line[0]?.y ?? y))}`)
      .join('');
  const whole = work.length === points.length;
  const words = whole ? growthWords(series, work) : '';
  const timed = time.length === points.length ? growthWords(series, time) : '';
  const timeName = timed && (named(time)?.growth ?? '');
  const unit = MEASURE_WORDS[measure];
  return html`<li class="growth-plot" data-series=${id} title=${how}>
    <svg width=${width} height=${height} viewBox="0 0 ${width} ${height}" role="img"
      aria-label=${`${title}: ${unit} ${words}${timed ? `; time ${timed}` : ''}`}>
      ${[...Array(Math.floor(high) + 1).keys()].map(
        (k) => svg`<line class="growth-grid" x1="0" x2=${width} y1=${py(k)} y2=${py(k)} />
          ${
            // The first point is at × 1: its number stands below the line.
            k === 0
              ? svg`<text class="growth-number" x=${width} y=${py(k) - 3}
                text-anchor="end">× 1</text>`
              : svg`<text class="growth-number" x="0" y=${py(k) - 3}>× ${10 ** k}</text>`
          }`,
      )}
      <path class="growth-line dashed" d=${path(time)} />
      <path class="growth-line" d=${path(work)} />
      ${work.map(
        ({ x, y }) => svg`<circle class="growth-dot" r="2.8" cx=${px(x)}
          cy=${py(decades(y, work[0]?.y ?? y))} data-x=${x}
          data-value=${y}><title>${labelOf(series, x)}: ${grouped(y)} ${unit}</title></circle>`,
      )}
    </svg>
    <h3>${title}</h3>
    <p data-quantity="growth.${id}" data-value=${whole ? (named(work)?.growth ?? '') : ''}>${
      words
    }</p>
    ${
      timed
        ? html`<p data-quantity="growth.${id}.time"
      data-value=${timeName}>time ${timeName === 'neither' ? timeName : timed}</p>`
        : nothing
    }
    <p class="growth-range">${grouped(numberOf(id, from))} to ${grouped(numberOf(id, to))}</p>
  </li>`;
}

const named = (line: readonly Priced[]): Slope | null => slopeOf(line);

/** A number that is varied, as it is counted: bounces without the camera ray. */
const labelOf = ({ id, title }: Pick<Series, 'id' | 'title'>, x: number): string =>
  `${grouped(numberOf(id, x))} ${title}`;

/** The name of a growth, and its most telling number. */
function growthWords(series: Series, line: readonly Priced[]): string {
  const slope = slopeOf(line);
  const [first, last] = [line[0]?.y ?? Number.NaN, line.at(-1)?.y ?? Number.NaN];
  if (!slope) return 'too little to name';
  const { growth, a, b, exponent } = slope;
  if (growth === 'constant') return 'constant';
  if (growth === 'linear') {
    // Without a share that is there from the start the line is at 45°.
    const proportional = Math.abs(a) <= WITHIN * first;
    return proportional
      ? `linear, slope ${exponent.toFixed(2)}`
      : `linear, ${signed(b / first)} ${series.one}`;
  }
  if (growth === 'logarithmic') {
    return `logarithmic, ${signed((b * Math.LN2) / first)} a doubling`;
  }
  const half = halfOf(line);
  return half === null
    ? `neither, × ${display(last / first, 2)}`
    : `neither, half of it by ${grouped(numberOf(series.id, half))}`;
}

const signed = (part: number): string =>
  `${part < 0 ? '−' : '+'} ${display(Math.abs(100 * part), 2)} %`;

/** The first number by which half of a growth is made, if it only grows; else null. */
function halfOf(line: readonly Priced[]): number | null {
  const ys = line.map(({ y }) => y);
  const [first, last] = [ys[0] ?? Number.NaN, ys.at(-1) ?? Number.NaN];
  if (ys.some((y, k) => y < (ys[k - 1] ?? y)) || !(last > first)) return null;
  return line.find(({ y }) => y >= (first + last) / 2)?.x ?? null;
}

/** What was found, for who listens; '' before. */
export function growthSaid({ series, runs, share }: GrowthShown, by: Measure): string {
  if (runs || share < 1) return '';
  const measure = by === 'ms' ? 'questions' : by;
  const found = series.map((one) => `${one.title} ${growthWords(one, linesOf(one, measure).work)}`);
  return `how the price grows: ${found.join('; ')}`;
}

/** The measured growths as CSV, a picture a line. */
export function growthCsv({ series }: GrowthShown): string {
  return csv([
    [
      'series',
      'number',
      'rays',
      'questions',
      'roots worked out',
      'roots found',
      'ms lower quartile',
    ].concat(['ms upper quartile']),
    ...series.flatMap(({ id, points }) =>
      points.flatMap(({ x, work, time }): (readonly Cell[])[] => {
        if (!work) return [];
        const { rays, questions, solves, roots } = work;
        return [[id, numberOf(id, x), rays, questions, solves, roots, time?.low, time?.high]];
      }),
    ),
  ]);
}
