import { scaleLinear } from 'd3-scale';
import { html, render, type TemplateResult } from 'lit';
import type { Mounted } from '../ui/mounted.ts';
import { watchMetrics } from './graph-metrics.ts';
import { lineOf } from './hardness-line.ts';
import type { HardnessActions, HardnessModel } from './hardness-model.ts';
import { lineNames } from './hardness-names.ts';
import { styleOf } from './line-style.ts';
import { axes, type Field, fieldOf } from './plot.ts';

/** Room at the right for the names of the lines, in em. */
const NAMES = 9.5;
const MOST = 16;

/** The plot of right digits against difficulty, a line for each method. */
export function mountHardness(host: HTMLElement, actions: HardnessActions): Mounted<HardnessModel> {
  let model: HardnessModel | null = null;
  host.classList.add('plot');
  const watch = watchMetrics(host, draw);

  function draw(): void {
    const metrics = watch.metrics();
    if (model && metrics) render(plot(model, fieldOf(metrics, NAMES), actions), watch.slot);
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

function plot(model: HardnessModel, field: Field, actions: HardnessActions): TemplateResult {
  const x = scaleLinear([...model.range], [field.left, field.right]);
  const y = scaleLinear([0, MOST], [field.bottom - 0.9 * field.em, field.top]);
  const scales = { x, y };
  const most = Math.max(3, Math.floor((field.right - field.left) / (5 * field.em)));
  const xTicks = x
    .ticks(most)
    .filter(Number.isInteger)
    .map((k) => ({ at: x(k), label: model.tick(k) }));
  const yTicks = [0, 4, 8, 12, 16].map((digits) => ({ at: y(digits), label: String(digits) }));
  const drawn = model.lines.map((line, i) => ({ line, style: styleOf(i) }));
  return html`<svg class="plot-svg" width=${field.width} height=${field.height} role="group"
    aria-label=${`${model.digitsTitle} against difficulty: ${model.dialTitle}`}>
    ${axes(
      field,
      { ticks: xTicks, title: `${model.dialTitle} →` },
      { ticks: yTicks, title: model.digitsTitle },
    )}
    ${drawn.map(({ line, style }) => lineOf(line, style, model, scales, field, actions))}
    ${lineNames(model, scales, field)}
  </svg>`;
}
