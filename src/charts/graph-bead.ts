import { html, svg, type TemplateResult } from 'lit';
import type { Vec3 } from '../math/index.ts';
import type { GraphModel } from '../state/graph-model.ts';
import { coordinate } from '../text/coordinate.ts';
import { display, displayTriple, shortest } from '../text/format.ts';
import { clamp } from './axis-steps.ts';
import { heightAt, type Parabola } from './graph-curve.ts';
import type { Frame } from './graph-frame.ts';
import { halo } from './graph-roots.ts';
import type { Scales } from './graph-scales.ts';

/**
 * The bead on the graph, a slider for keyboard and screen readers; its touch area is 44 px wide.
 */
export function bead(
  model: GraphModel,
  scales: Scales,
  parabola: Parabola | null,
  onKey: (event: KeyboardEvent) => void,
): TemplateResult {
  const { frame } = scales;
  const { t } = model.bead;
  const x = coordinate(clamp(scales.x(t), frame.left, frame.right));
  const y = coordinate(beadHeight(model, scales, parabola));
  const label = model.mark?.isOpen ? `t, ${model.mark.title} on the ray` : 't on the ray';
  const isOff = t < model.from || t > model.to;
  return svg`
    ${
      model.square
        ? ''
        : svg`<line class="graph-plumb" x1=${x} x2=${x} y1=${frame.top} y2=${frame.bottom}></line>`
    }
    <g class="graph-bead ${isOff ? 'graph-off' : ''}" data-symbol="t"
      transform="translate(${x},${y})"
      role="slider" tabindex="0" aria-label=${label} aria-valuemin=${Math.min(model.from, t)}
      aria-valuemax=${Math.max(model.to, t)} aria-valuenow=${t} aria-valuetext=${inWords(model)}
        @keydown=${onKey}>
      <circle class="graph-touch" r="22"></circle>
      <circle class="graph-focus" r=${10.5 * frame.mark}></circle>
      ${halo(5.6, frame.mark)}<circle class="graph-handle" r=${5.6 * frame.mark}></circle>
    </g>`;
}

/** The bead's y in px: on the drawn curve, or at the edge of the plot. */
function beadHeight(model: GraphModel, scales: Scales, parabola: Parabola | null): number {
  const { top, floor, bottom } = scales.frame;
  const u = (model.bead.t - model.from) / (model.to - model.from);
  const y = parabola ? floor + heightAt(parabola, clamp(u, 0, 1)) * (top - floor) : scales.y(0);
  return clamp(y, top, bottom);
}

function inWords({ bead: { t, f } }: GraphModel): string {
  return Number.isFinite(f) ? `t ${display(t)}, f ${display(f)}` : `t ${display(t)}`;
}

const titleOf = (t: number, f: number, point: Vec3): string =>
  [
    ...(Number.isFinite(f) ? [`f(${display(t)}) = ${display(f)}`] : []),
    `R(t) = ${displayTriple(point)}`,
  ].join(', ');

/** f(t) and R(t) of the bead, at a fixed place above the plot. */
export function readout({ bead: { t, f, point } }: GraphModel, frame: Frame): TemplateResult {
  const digits = frame.narrow ? 4 : 6;
  const part = (name: string, value: number, precision = 6) =>
    Number.isFinite(value)
      ? html`<span data-quantity="bead.${name}"
        data-value=${shortest(value)}>${display(value, precision)}</span>`
      : html`–`;
  if (!Number.isFinite(t)) return html``;
  const at = frame.narrow ? '' : `(${display(t)})`;
  const [x, y, z] = point;
  return html`<p class="graph-readout ${frame.narrow ? 'graph-narrow' : ''}"
    .style=${`left:${frame.left + 0.8 * frame.em}px;height:${frame.top}px`}
      title=${titleOf(t, f, point)}>
    <span class="graph-key"></span>
    <span class="graph-value"><i>𝑓</i>(${part('t', t)}) = ${part('f', f)}</span>
    <span><i>𝑅</i>${at} = (${part('x', x, digits)}, ${part('y', y, digits)}, ${part(
      'z',
      z,
      digits,
    )})</span>
  </p>`;
}
