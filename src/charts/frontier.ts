import { scaleLinear, scaleLog } from 'd3-scale';
import { html, render, svg, type TemplateResult } from 'lit';
import { frontier } from '../lab/pareto.ts';
import type { FrontierMark, FrontierModel } from '../state/accuracy/frontier.ts';
import type { Mounted } from '../ui/mounted.ts';
import { costTicks } from './cost-ticks.ts';
import { lineBoxes, markOf, stepLine } from './frontier-marks.ts';
import { watchMetrics } from './graph-metrics.ts';
import { type Box, labelMarks } from './mark-labels.ts';
import { axes, type Field, fieldBox, fieldOf, labelSize, nameAt, px } from './plot.ts';

/** The plot of worth against cost: a mark for each method, and the step line of the frontier. */
export function mountFrontier(
  host: HTMLElement,
  choose: (id: string) => void,
): Mounted<FrontierModel> {
  let model: FrontierModel | null = null;
  host.classList.add('plot');
  const watch = watchMetrics(host, draw);

  function draw(): void {
    const metrics = watch.metrics();
    if (model && metrics) render(plot(model, fieldOf(metrics, 0, SCALES), choose), watch.slot);
  }

  return {
    render(next) {
      model = next;
      draw();
    },
    dispose() {
      watch.dispose();
      host.classList.remove('plot');
    },
  };
}

/** Scales of the cost axis: multiples of the textbook, and ns. */
const SCALES = 2;
/** Factor in cost between the outer marks and the ends of the axis. */
const MARGIN = 1.5;

/** A mark with its position in px. */
interface PlacedMark {
  readonly mark: FrontierMark;
  readonly x: number;
  readonly y: number;
}

const NOTE = 'further up and to the left is better';

function plot(model: FrontierModel, field: Field, choose: (id: string) => void): TemplateResult {
  const { marks, worthTicks, chosen, unit, gridByUnit } = model;
  const { x, y } = scalesOf(model, field);
  const spots = marks.map((mark) => ({ mark, x: x(mark.cost.value), y: y(mark.worth) }));
  const front = frontier(
    spots
      .filter(({ mark }) => !mark.isApart)
      .map((spot) => ({ ...spot, cost: spot.mark.cost.value, worth: spot.mark.worth })),
  );
  const best = new Set(front.map(({ mark }) => mark.id));
  const line = front.map((spot) => ({ cost: spot.x, worth: spot.y }));
  // The chosen method, then those on the frontier: labels that come first get the best places.
  const rank = ({ mark }: PlacedMark): number =>
    mark.id === chosen ? 0 : best.has(mark.id) ? 1 : 2;
  const ordered = [...spots].sort((p, q) => rank(p) - rank(q) || p.x - q.x);
  const note = noteBox(model.worthTitle, field);
  const ratios = costTicks(x, 1, field);
  const times = unit === null ? [] : costTicks(x, unit, field);
  return html`<svg class="plot-svg" width=${field.width} height=${field.height} role="group"
    aria-label=${`${model.worthTitle} against ${model.costTitle}`}>
    ${axes(
      field,
      { ticks: ratios, title: `${model.costTitle} →`, grid: gridByUnit ? times : ratios },
      {
        ticks: worthTicks.map(({ value, label }) => ({ at: y(value), label })),
        title: model.worthTitle,
      },
    )}
    ${times.map(
      ({ at, label }) => svg`<text class="plot-tick" text-anchor="middle" x=${px(at)}
      y=${px(field.bottom + 2.8 * field.em)}>${label}</text>`,
    )}
    ${stepLine(line, field)}
    <text class="plot-name quiet" x=${px(note.left)} y=${px(note.top + field.em)}>${NOTE}</text>
    ${spots.map(({ mark, y: cy }) => {
      const [x1, x2] = [px(x(mark.cost.low)), px(x(mark.cost.most))];
      return svg`<line class="plot-whisker" x1=${x1} x2=${x2} y1=${px(cy)} y2=${px(cy)}></line>`;
    })}
    ${names(ordered, chosen, field, [note, ...lineBoxes(line, field)])}
    ${[...ordered].reverse().map(({ mark, x: cx, y: cy }) => {
      const isChosen = mark.id === chosen;
      return markOf(mark, cx, cy, best.has(mark.id), isChosen, field.mark, choose);
    })}
  </svg>`;
}

/** Ends of the axis, rounded so that small changes of prices do not move it. */
function endsOf(costs: readonly number[]): readonly [number, number] {
  const low = Math.log2(Math.min(...costs) / MARGIN);
  const high = Math.log2(Math.max(...costs) * MARGIN);
  return [2 ** Math.floor(low), 2 ** Math.ceil(high)];
}

function scalesOf({ marks, worthTicks }: FrontierModel, { left, right, top, bottom, em }: Field) {
  const costs = marks.flatMap(({ cost }) => [cost.value, cost.low, cost.most]);
  const worths = worthTicks.map(({ value }) => value);
  return {
    x: scaleLog(endsOf(costs), [left, right]),
    y: scaleLinear([Math.min(...worths), Math.max(...worths)], [bottom - 0.9 * em, top + 0.5 * em]),
  };
}

/** Box of the note: at the right end of the axis' title, or on a line of its own below it. */
function noteBox(title: string, field: Field): Box {
  const size = labelSize(NOTE, field.em);
  const left = field.right - size.width;
  const fits = labelSize(title, field.em).width < left;
  return { left, top: fits ? -0.1 * field.em : 1.2 * field.em, ...size };
}

/** Ratio of a bold label's width to that of a plain one. */
const BOLD = 1.06;

function names(
  spots: readonly PlacedMark[],
  chosen: string,
  field: Field,
  taken: readonly Box[],
): TemplateResult[] {
  const wishes = spots.map(({ mark, x, y }) => ({
    x,
    y,
    radius: (mark.id === chosen ? 11 : 6) * field.mark,
    ...labelSize(`${mark.name}${mark.note}`, field.em * (mark.id === chosen ? BOLD : 1)),
  }));
  const places = labelMarks(wishes, fieldBox(field), taken);
  return spots.flatMap((spot, i) => {
    const place = places[i];
    const { id, name, note, isFaint } = spot.mark;
    const cls = id === chosen ? 'is-chosen' : isFaint ? 'quiet' : '';
    const text = svg`${name}<tspan class="plot-note">${note}</tspan>`;
    return place ? [nameAt(text, place, spot, field.em, cls)] : [];
  });
}
