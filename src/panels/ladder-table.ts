import { html, nothing, svg, type TemplateResult } from 'lit';
import { grouped, priceText } from '../lab/sentence.ts';
import type { Timing } from '../lab/session.ts';
import type { MethodRow, RootRow } from '../lab/this-ray.ts';
import { JUDGEMENTS } from '../lab/verdict.ts';
import type { Target } from '../math/batch.ts';
import type { Verdict } from '../math/index.ts';
import { SAYS } from '../state/accuracy/change-words.ts';
import { isEmulated } from '../state/accuracy/column.ts';
import { display, shortest } from '../text/format.ts';
import { digitCell, markedNumber } from './digit-bar.ts';
import { symbol } from './formula.ts';
import './ladder-table.css';

interface LadderModel {
  readonly rows: readonly MethodRow[];
  /** Where digits are lost, in a few words, by method. */
  readonly where: ReadonlyMap<string, string>;
  /** By target and method; empty until something is measured. */
  readonly timings: Readonly<Record<Target, ReadonlyMap<string, Timing>>>;
  /** Words on which rays and question were timed: “far away” rays, both roots. */
  readonly timed: string;
  readonly chosen: string;
}

/** The table of one ray by every method, a row for each. */
export function ladderTable(model: LadderModel, choose: (id: string) => void): TemplateResult {
  const head = (name: string, words: string, rows = 2): TemplateResult =>
    html`<th role="columnheader" scope="col" rowspan=${rows} class=${`head-${name}`}>${words}</th>`;
  return html`<table class="ladder" role="table" aria-label="This ray by every method">
    <caption
      class="ladder-timed">× textbook, in SIMD and in TypeScript: of ${model.timed}, above</caption>
    <thead role="rowgroup">
      <tr role="row">
        <th role="columnheader" scope="col" rowspan="2" class="name-head">method</th>
        ${head('verdict', 'verdict')}${head('roots', 'roots')}${head(
          'digits',
          'digits that are right',
        )}${head('error', 'error')}
        <th role="columnheader" scope="colgroup" colspan="2"
          class="head-timed">× textbook: ${model.timed}, above</th>
        ${head('where', 'where digits go')}
      </tr>
      <tr role="row">${head('simd', 'SIMD', 1)}${head('typescript', 'TypeScript', 1)}</tr>
    </thead>
    <tbody role="rowgroup">
      ${model.rows.map((row) => ladderRow(row, model, choose))}
    </tbody>
  </table>`;
}

function ladderRow(
  row: MethodRow,
  model: LadderModel,
  choose: (id: string) => void,
): TemplateResult {
  const { method } = row;
  const chosen = method.id === model.chosen;
  return html`<tr
    role="row"
    data-method=${method.id}
    class=${chosen ? 'is-chosen' : ''}
    @click=${() => choose(method.id)}
  >
    <th role="rowheader" scope="row" class="ladder-method">
      <label class="ladder-name">
        <input type="radio" name="ladder-method" .checked=${chosen}
          @change=${() => choose(method.id)} />
        <span class="title">${method.title}</span>
        <span class="hint">${method.hint ?? method.idea}</span>
      </label>
    </th>
    <td role="cell" class="ladder-verdict">${verdict(row)}</td>
    <td role="cell" class="roots">${roots(row)}</td>
    <td role="cell" class="digits">${digitCell(row.digits, 'digits')}</td>
    <td role="cell" class="errors">${errors(row.roots)}</td>
    ${price('simd', method.id, model)}${price('typescript', method.id, model)}
    <td role="cell" class="where">${model.where.get(method.id) ?? ''}</td>
  </tr>`;
}

/** A price as a multiple of the textbook's in the same column and in ns, or "emulated". */
function price(target: Target, id: string, { timings }: LadderModel): TemplateResult {
  const timing = timings[target].get(id);
  if (!timing) return html`<td role="cell" class=${`price ${target}`}>–</td>`;
  const { ns, times } = timing;
  const emulated = isEmulated(id, target) ? 'emulated, ' : '';
  return html`<td role="cell" class=${`price ${target}`}>
    ${number(`${target} ratio`, times.value, `${priceText(times)}×`)}
    <span class="hint">${emulated}${number(`${target} ns`, ns.value, `${priceText(ns)} ns`)}</span>
  </td>`;
}

const number = (quantity: string, x: number, text: string): TemplateResult =>
  html`<span data-quantity=${quantity} data-value=${shortest(x)}>${text}</span>`;

function verdict({ found, judgement }: MethodRow): TemplateResult {
  const right = judgement === 'right';
  return html`<span class=${right ? 'says' : 'says wrong'}>
      ${mark(found.class, judgement === 'undecided')}
      <span data-quantity="class" data-value=${found.class}>${SAYS[found.class]}</span>
    </span>
    <span class="hint" data-quantity="judgement"
      data-value=${judgement}>${JUDGEMENTS[judgement]}</span>`;
}

/** A disc for a hit, a cross for a miss, a dashed ring for an undecided verdict. */
function mark(verdict: Verdict, open: boolean): TemplateResult {
  const drawn = open
    ? svg`<circle r="5.6" class="is-open" />`
    : verdict === 'none'
      ? svg`<path d="M-5-5L5 5M-5 5L5-5" class="is-cross" />`
      : svg`<circle r="6" class="is-hit" />`;
  return html`<svg class="ladder-mark" viewBox="-8 -8 16 16" width="15" height="15"
    aria-hidden="true">${drawn}</svg>`;
}

function roots({ roots, judgement }: MethodRow): TemplateResult {
  if (roots.length === 0) {
    return html`<span class="no-root">${judgement === 'undecided' ? 'no claim' : 'no root'}</span>`;
  }
  return html`${roots.map(
    ({ t, marked }, i) => html`<span class="root">
      <span class="root-letter">${symbol(
        't',
        roots.length > 1 ? String(i + 1) : null,
        'sym',
        `t${i + 1}`,
      )}</span>
      <span data-quantity=${`t${i + 1}`} data-value=${shortest(t)}>${markedNumber(marked)}</span>
    </span>`,
  )}`;
}

/** Errors of the worse root: in ulps, and the distance of its point. */
function errors(roots: readonly RootRow[]): TemplateResult | typeof nothing {
  const ulps = roots.flatMap((root) => (root.ulps === null ? [] : [root.ulps]));
  const off = roots.flatMap(({ pointError }) => (pointError === null ? [] : [pointError]));
  if (ulps.length === 0) return nothing;
  const most = Math.max(...ulps);
  const farthest = Math.max(...off);
  return html`<span>${number('ulps', most, ulpsText(most))} ulp</span>
    <span class="hint">point off by ${number('pointError', farthest, display(farthest, 2))}</span>`;
}

const ulpsText = (ulps: number): string =>
  ulps < 100_000 ? grouped(Math.round(ulps)) : display(ulps, 2);
