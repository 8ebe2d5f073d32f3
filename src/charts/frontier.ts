import { scaleLinear, scaleLog } from 'd3-scale';
import { html, render, svg, type TemplateResult } from 'lit';
import { frontier } from '../lab/pareto.ts';
import { grouped } from '../lab/sentence.ts';
import type { Mounted } from '../ui/mounted.ts';
import { lineBoxes, markOf, stepLine } from './frontier-marks.ts';
import type { FrontierMark, FrontierModel } from './frontier-model.ts';
import { watchMetrics } from './graph-metrics.ts';
import { type Box, labelMarks } from './mark-labels.ts';
import {
  axes,
  type Field,
  fieldBox,
  fieldOf,
  labelSize,
  nameAt,
  type PlotTick,
  px,
} from './plot.ts';

/** Worth against cost, one mark a method, and the step line of those that nothing beats. */
export function mountFrontier(
  host: HTMLElement,
  choose: (id: string) => void,
): Mounted<FrontierModel> {
  let model: FrontierModel | null = null;
  host.classList.add('plot');
  const watch = watchMetrics(host, draw);

  function draw(): void {
    const metrics = watch.metrics();
    if (model && metrics) render(plot(model, fieldOf(metrics), choose), watch.slot);
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

/** Marks stay clear of the ends of the axis by this factor. */
const MARGIN = 1.5;

/** A mark and where it stands, in px. */
interface Spot {
  readonly mark: FrontierMark;
  readonly x: number;
  readonly y: number;
}

const NOTE = 'further up and to the left is better';

function plot(model: FrontierModel, field: Field, choose: (id: string) => void): TemplateResult {
  const { marks, worthTicks, chosen } = model;
  const { x, y } = scalesOf(model, field);
  const spots = marks.map((mark) => ({ mark, x: x(mark.cost.value), y: y(mark.worth) }));
  const front = frontier(
    spots.map((spot) => ({ ...spot, cost: spot.mark.cost.value, worth: spot.mark.worth })),
  );
  const best = new Set(front.map(({ mark }) => mark.id));
  const line = front.map((spot) => ({ cost: spot.x, worth: spot.y }));
  // The chosen one first, then what is on the frontier: they have the best places for their names.
  const rank = ({ mark }: Spot): number => (mark.id === chosen ? 0 : best.has(mark.id) ? 1 : 2);
  const ordered = [...spots].sort((p, q) => rank(p) - rank(q) || p.x - q.x);
  const note = noteBox(model.worthTitle, field);
  return html`<svg class="plot-svg" width=${field.width} height=${field.height} role="group" aria-label=${`${model.worthTitle} against ${model.costTitle}`}>
    ${axes(
      field,
      {
        ticks: costTicks(x),
        minor: x.ticks().map((value) => x(value)),
        title: `${model.costTitle} →`,
      },
      {
        ticks: worthTicks.map(({ value, label }) => ({ at: y(value), label })),
        title: model.worthTitle,
      },
    )}
    ${stepLine(line, field)}
    <text class="plot-name quiet" x=${px(note.left)} y=${px(note.top + field.em)}>${NOTE}</text>
    ${spots.map(({ mark, y: cy }) => svg`<line class="plot-whisker" x1=${px(x(mark.cost.least))} x2=${px(x(mark.cost.most))} y1=${px(cy)} y2=${px(cy)}></line>`)}
    ${names(ordered, chosen, field, [note, ...lineBoxes(line, field)])}
    ${[...ordered].reverse().map(({ mark, x: cx, y: cy }) => markOf(mark, cx, cy, best.has(mark.id), mark.id === chosen, field.mark, choose))}
  </svg>`;
}

function scalesOf({ marks, worthTicks }: FrontierModel, { left, right, top, bottom, em }: Field) {
  const costs = marks.flatMap(({ cost }) => [cost.value, cost.least, cost.most]);
  const worths = worthTicks.map(({ value }) => value);
  return {
    x: scaleLog([Math.min(...costs) / MARGIN, Math.max(...costs) * MARGIN], [left, right]),
    y: scaleLinear([Math.min(...worths), Math.max(...worths)], [bottom - 0.9 * em, top + 0.5 * em]),
  };
}

/**
 * At the right end of the axis' title, or in a line of its own below it: above all that leads to a
 * mark.
 */
function noteBox(title: string, field: Field): Box {
  const size = labelSize(NOTE, field.em);
  const left = field.right - size.width;
  const fits = labelSize(title, field.em).width < left;
  return { left, top: fits ? -0.1 * field.em : 1.2 * field.em, ...size };
}

/** Powers of ten, or what there is between two of them. */
function costTicks(x: ReturnType<typeof scalesOf>['x']): PlotTick[] {
  const decades = x.ticks().filter((value) => Math.log10(value) % 1 === 0);
  return (decades.length >= 2 ? decades : x.ticks(4)).map((value) => ({
    at: x(value),
    label: value >= 1 ? grouped(value) : String(value),
  }));
}

/** How much wider a name is in bold. */
const BOLD = 1.06;

function names(
  spots: readonly Spot[],
  chosen: string,
  field: Field,
  taken: readonly Box[],
): TemplateResult[] {
  const nameOf = ({ id, name }: FrontierMark): string =>
    id === chosen ? `${name}, selected` : name;
  const wishes = spots.map(({ mark, x, y }) => ({
    x,
    y,
    radius: (mark.id === chosen ? 11 : 6) * field.mark,
    ...labelSize(nameOf(mark), field.em * (mark.id === chosen ? BOLD : 1)),
  }));
  const places = labelMarks(wishes, fieldBox(field), taken);
  return spots.flatMap((spot, i) => {
    const place = places[i];
    const cls = spot.mark.id === chosen ? 'is-chosen' : '';
    return place ? [nameAt(nameOf(spot.mark), place, spot, field.em, cls)] : [];
  });
}
