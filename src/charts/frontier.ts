import { scaleLinear, scaleLog } from 'd3-scale';
import { html, render, svg, type TemplateResult } from 'lit';
import { frontier, steps } from '../lab/pareto.ts';
import { grouped } from '../lab/sentence.ts';
import type { Quartiles } from '../lab/stats.ts';
import type { Mounted } from '../ui/mounted.ts';
import { type Box, placeLabels } from './place-labels.ts';
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
import { watchMetrics } from './strip-metrics.ts';

export interface FrontierMark {
  readonly id: string;
  /** What stands beside the mark. */
  readonly name: string;
  /** The whole truth in words, for the screen reader. */
  readonly words: string;
  readonly cost: Quartiles;
  /** Larger is better. */
  readonly worth: number;
}

export interface FrontierModel {
  readonly marks: readonly FrontierMark[];
  readonly chosen: string;
  readonly costTitle: string;
  readonly worthTitle: string;
  /** The worths that the axis shows, from the worst to the best, and their labels. */
  readonly worthTicks: readonly { readonly value: number; readonly label: string }[];
}

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

function plot(model: FrontierModel, field: Field, choose: (id: string) => void): TemplateResult {
  const { marks, worthTicks } = model;
  const costs = marks.flatMap(({ cost }) => [cost.low, cost.high]);
  const x = scaleLog(
    [Math.min(...costs) / MARGIN, Math.max(...costs) * MARGIN],
    [field.left, field.right],
  );
  const worths = worthTicks.map(({ value }) => value);
  const y = scaleLinear(
    [Math.min(...worths), Math.max(...worths)],
    [field.bottom - 0.9 * field.em, field.top + 0.5 * field.em],
  );
  const at = marks.map((mark) => ({ mark, x: x(mark.cost.median), y: y(mark.worth) }));
  const front = frontier(
    at.map((one) => ({ ...one, cost: one.mark.cost.median, worth: one.mark.worth })),
  );
  const best = new Set(front.map(({ mark }) => mark.id));
  const scale = field.mark;
  const isChosen = (id: string): boolean => id === model.chosen;
  // The chosen one first, then what is on the frontier: they have the best places for their names.
  const rank = ({ mark }: (typeof at)[number]): number =>
    isChosen(mark.id) ? 0 : best.has(mark.id) ? 1 : 2;
  const ordered = [...at].sort((p, q) => rank(p) - rank(q) || p.x - q.x);
  const note = {
    text: 'further up and to the left is better',
    ...labelSize('further up and to the left is better', field.em),
  };
  const noteBox = {
    left: field.right - note.width,
    top: field.bottom - 2.6 * field.em,
    width: note.width,
    height: note.height,
  };
  const nameOf = (mark: FrontierMark): string =>
    isChosen(mark.id) ? `${mark.name}, selected` : mark.name;
  const places = placeLabels(
    ordered.map(({ mark, x: cx, y: cy }) => ({
      x: cx,
      y: cy,
      radius: (isChosen(mark.id) ? 11 : 6) * scale,
      ...labelSize(nameOf(mark), field.em * (isChosen(mark.id) ? 1.06 : 1)),
    })),
    fieldBox(field),
    [
      noteBox,
      ...lineBoxes(
        front.map(({ x: cx, y: cy }) => ({ cost: cx, worth: cy })),
        field,
      ),
    ],
  );
  const decades = x.ticks().filter((value) => Math.log10(value) % 1 === 0);
  const labelled = decades.length >= 2 ? decades : x.ticks(4);
  const xTicks: PlotTick[] = labelled.map((value) => ({
    at: x(value),
    label: value >= 1 ? grouped(value) : String(value),
  }));
  const yTicks = worthTicks.map(({ value, label }) => ({ at: y(value), label }));
  return html`<svg class="plot-svg" width=${field.width} height=${field.height} role="group" aria-label=${`${model.worthTitle} against ${model.costTitle}`}>
    ${axes(
      field,
      { ticks: xTicks, minor: x.ticks().map((value) => x(value)), title: `${model.costTitle} →` },
      { ticks: yTicks, title: model.worthTitle },
    )}
    ${stepLine(
      front.map(({ x: cx, y: cy }) => ({ cost: cx, worth: cy })),
      field,
    )}
    <text class="plot-name quiet" x=${px(noteBox.left)} y=${px(noteBox.top + field.em)}>${note.text}</text>
    ${at.map(({ mark, y: cy }) => svg`<line class="plot-whisker" x1=${px(x(mark.cost.low))} x2=${px(x(mark.cost.high))} y1=${px(cy)} y2=${px(cy)}></line>`)}
    ${ordered.map(({ mark, x: cx, y: cy }, i) => {
      const place = places[i];
      return (
        place &&
        nameAt(
          nameOf(mark),
          place,
          { x: cx, y: cy },
          field.em,
          isChosen(mark.id) ? 'is-chosen' : '',
        )
      );
    })}
    ${[...ordered].reverse().map(({ mark, x: cx, y: cy }) => dot(mark, cx, cy, best.has(mark.id), isChosen(mark.id), scale, choose))}
  </svg>`;
}

/** The step line as thin boxes, so that no name lies on it. */
function lineBoxes(
  front: readonly { cost: number; worth: number }[],
  { right, bottom }: Field,
): Box[] {
  const [first] = front;
  const last = front.at(-1);
  if (!first || !last) return [];
  const corners = [[first.cost, bottom] as const, ...steps(front), [right, last.worth] as const];
  return corners.slice(1).map(([x, y], i) => {
    const [fromX, fromY] = corners[i] ?? [x, y];
    return {
      left: Math.min(x, fromX) - 1,
      top: Math.min(y, fromY) - 1,
      width: Math.abs(x - fromX) + 2,
      height: Math.abs(y - fromY) + 2,
    };
  });
}

/** In px: up to the first worth, along the steps, and on to the right. */
function stepLine(
  front: readonly { cost: number; worth: number }[],
  { right, bottom }: Field,
): TemplateResult {
  const [first] = front;
  const last = front.at(-1);
  if (!first || !last) return svg``;
  const corners = steps(front).map(([x, y]) => `L${px(x)},${px(y)}`);
  const line = `M${px(first.cost)},${bottom}${corners.join('')}L${right},${px(last.worth)}`;
  return svg`<path class="plot-reach" d=${`${line}L${right},${bottom}Z`}></path><path class="plot-step" d=${line}></path>`;
}

function dot(
  mark: FrontierMark,
  x: number,
  y: number,
  isBest: boolean,
  chosen: boolean,
  scale: number,
  choose: (id: string) => void,
): TemplateResult {
  const key = (event: KeyboardEvent): void => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    choose(mark.id);
  };
  return svg`<g class="plot-mark" role="button" tabindex="0" data-method=${mark.id}
      aria-pressed=${chosen} aria-label=${mark.words} transform="translate(${px(x)},${px(y)})"
      @click=${() => choose(mark.id)} @keydown=${key}>
    <circle class="plot-touch" r="14"></circle>
    ${chosen ? svg`<circle class="plot-ring" r=${11 * scale}></circle>` : ''}
    <circle class=${isBest ? 'plot-dot full' : 'plot-dot'} r=${(chosen ? 6.5 : 5) * scale}></circle>
    <circle class="plot-focus" r=${(chosen ? 14 : 10) * scale}></circle>
  </g>`;
}
