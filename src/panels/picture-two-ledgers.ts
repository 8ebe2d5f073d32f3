import { html, nothing, type TemplateResult } from 'lit';
import {
  grouped,
  type LedgerModel,
  MEASURE_WORDS,
  type Measure,
  msWords,
} from '../state/picture/ledger.ts';
import { display, shortest } from '../text/format.ts';
import './picture-ledger.css';

interface Row {
  readonly id: string;
  readonly title: string;
  /** Null for what does not run on that side, and for a time that was not measured. */
  readonly left: number | null;
  readonly right: number | null;
  readonly by: Measure;
}

const MS = 'ms' as const;

/** Both ledgers of a comparison by what the bars show, with their ratios, and the one cause. */
export function twoLedgers(
  left: LedgerModel,
  right: LedgerModel,
  words: { readonly left: string; readonly right: string; readonly cause: string },
): TemplateResult {
  const { by } = right;
  const rows = rowsOf(left, right, by);
  const row = ({ id, title, left: a, right: b, by: of }: Row): TemplateResult =>
    html`<tr data-row=${id}><th scope="row">${title}</th>${cell('left', a, of)}${cell(
      'right',
      b,
      of,
    )}${ratio(a, b)}</tr>`;
  return html`<table class="two-ledgers">
    <caption>${words.cause} By ${MEASURE_WORDS[by]}${by === 'ms' ? ', ms of all workers' : ''}:
    </caption>
    <thead><tr><th scope="col"><span class="visually-hidden">effect</span></th><th
      scope="col">left: ${words.left}</th><th scope="col">right: ${words.right}</th><th
        scope="col">left ÷ right</th></tr></thead>
    <tbody>${rows.map(row)}</tbody>
  </table>
  ${
    rows.some(({ by: of }) => of === 'ms')
      ? nothing
      : html`<p class="measure">Their times too, once <em>measure the time</em> has been chosen
          below.</p>`
  }`;
}

function rowsOf(left: LedgerModel, right: LedgerModel, by: Measure): readonly Row[] {
  const amount = (row: Pick<LedgerModel['camera'], 'cost' | 'time'> | undefined): number | null => {
    if (by === 'ms') return row?.time?.low ?? null;
    return row?.cost?.[by] ?? null;
  };
  const effects = [...right.simulated, ...right.idle].flatMap(({ id, title }): Row[] => {
    const of = ({ simulated }: LedgerModel) => simulated.find((row) => row.id === id);
    const [a, b] = [of(left), of(right)];
    return a || b ? [{ id, title, left: amount(a), right: amount(b), by }] : [];
  });
  const whole = ({ total, times }: LedgerModel): number | null =>
    by === 'ms' ? (times?.work.low ?? null) : total[by];
  const worked = ({ times }: LedgerModel): number | null => times?.work.low ?? null;
  const waited = ({ times }: LedgerModel): number | null => times?.waited.low ?? null;
  const areTimed = worked(left) !== null && worked(right) !== null;
  const camera = { left: amount(left.camera), right: amount(right.camera) };
  return [
    { id: 'camera', title: 'camera rays', ...camera, by },
    ...effects,
    { id: 'total', title: 'picture', left: whole(left), right: whole(right), by },
    ...(areTimed && by !== 'ms'
      ? [{ id: 'time', title: 'ms of work', left: worked(left), right: worked(right), by: MS }]
      : []),
    ...(areTimed
      ? [{ id: 'waited', title: 'ms waited', left: waited(left), right: waited(right), by: MS }]
      : []),
  ];
}

function cell(side: string, n: number | null, by: Measure): TemplateResult {
  if (n === null) return html`<td>–</td>`;
  return html`<td data-quantity=${side} data-value=${shortest(n)}>${
    by === 'ms' ? msWords(n) : grouped(n)
  }</td>`;
}

function ratio(a: number | null, b: number | null): TemplateResult {
  if (a === null || b === null || b === 0)
    return html`<td>${a === b && a === 0 ? '' : nothing}</td>`;
  return html`<td data-quantity="ratio" data-value=${shortest(a / b)}>${display(a / b, 3)}</td>`;
}
