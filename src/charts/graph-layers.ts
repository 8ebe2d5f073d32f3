import { svg, type TemplateResult } from 'lit';
import type { GraphModel } from '../state/graph-model.ts';
import { coordinate } from '../text/coordinate.ts';
import { clamp } from './axis-steps.ts';
import { areaPath, curvePath, type Parabola, parabolaOf } from './graph-curve.ts';
import { LETTER } from './graph-frame.ts';
import type { Scales } from './graph-scales.ts';

/** The t axis at f = 0, in the ray's own line styles, with its ticks. */
export function rayAxis(model: GraphModel, scales: Scales): TemplateResult {
  const { top, bottom, mark } = scales.frame;
  const y = coordinate(clamp(scales.y(0), top, bottom));
  const ticks = scales.tTicks
    .filter(({ value }) => value !== 0)
    .map(({ at }) => `M${coordinate(at)},${coordinate(y - 5 * mark)}v${coordinate(10 * mark)}`);
  return svg`<g data-symbol="d">
    ${visible(model, scales).map(
      ({ from, to, stretch }) =>
        svg`<line class="graph-ray graph-${stretch}" x1=${from} x2=${to} y1=${y} y2=${y}></line>`,
    )}
    <path class="graph-ray graph-mark" d=${ticks.join('')}></path>
  </g>`;
}

/** The words "behind", "outside", "inside" under their stretches, if they fit. */
export function words(model: GraphModel, scales: Scales): TemplateResult {
  const { bottom, em } = scales.frame;
  const y = coordinate(bottom - 0.5 * em);
  return svg`${visible(model, scales)
    .filter(({ from, to, place }) => to - from > ((place ?? '').length * LETTER + 0.4) * em)
    .map(
      ({ from, to, place }) =>
        svg`<text class="graph-word" text-anchor="middle" x=${coordinate((from + to) / 2)}
          y=${y}>${place ?? ''}</text>`,
    )}`;
}

function visible({ stretches }: GraphModel, { frame, x }: Scales) {
  const inPlot = (t: number) => coordinate(clamp(x(t), frame.left, frame.right));
  return stretches
    .map(({ from, to, ...kept }) => ({ from: inPlot(from), to: inPlot(to), ...kept }))
    .filter(({ from, to }) => to > from);
}

/** The ghost's graph and its roots. */
export function ghost(model: GraphModel, scales: Scales, id: string): TemplateResult {
  if (!model.ghost) return svg``;
  const { roots, ...coefficients } = model.ghost;
  // Drawn from coefficients alone, without roots, since it has no marks that it has to meet.
  const kept = parabolaOf({ ...model, ...coefficients, roots: [] });
  const { frame, x } = scales;
  const y = coordinate(clamp(scales.y(0), frame.top, frame.bottom));
  const seen = roots.map(x).filter((at) => at >= frame.left && at <= frame.right);
  return svg`${
    kept &&
    svg`<path class="graph-ghost" clip-path="url(#${id}-plot)"
      d=${curvePath(kept, frame)}></path>`
  }${seen.map(
    (at) => svg`<circle class="graph-ghost" cx=${coordinate(at)} cy=${y}
          r=${4 * frame.mark}></circle>`,
  )}`;
}

/** Of the plot's height, for the whole way of a number that played. */
const WAY = 0.55;

/**
 * The roots at other values of a number, larger ones above, through those of the present one on the
 * axis; and f where the class changes.
 */
export function trail(model: GraphModel, scales: Scales, id: string): TemplateResult {
  if (!model.trail) return svg``;
  const { frame, x } = scales;
  const { left, right, top, bottom } = frame;
  const zero = clamp(scales.y(0), top, bottom);
  const dots = model.trail.roots
    .map(({ t, above }) => [x(t), zero - above * WAY * (bottom - top)] as const)
    .filter(([px, py]) => px >= left && px <= right && py >= top && py <= bottom)
    .map(([px, py]) => `M${coordinate(px)},${coordinate(py)}h0`);
  const curves = model.trail.curves.flatMap((f) => parabolaOf({ ...model, ...f, roots: [] }) ?? []);
  return svg`${curves.map(
    (kept) => svg`<path class="graph-turn" clip-path="url(#${id}-plot)"
      d=${curvePath(kept, frame)}></path>`,
  )}<path class="graph-trail" d=${dots.join('')}></path>`;
}

/** The region where f < 0, and the graph. */
export function area(parabola: Parabola, { frame }: Scales, id: string): TemplateResult {
  return svg`<path class="graph-area" clip-path="url(#${id}-below)"
    d=${areaPath(parabola, frame)}></path>`;
}

export function curve(parabola: Parabola, { frame }: Scales, id: string): TemplateResult {
  return svg`<path class="graph-curve" data-symbol="f" clip-path="url(#${id}-plot)"
    d=${curvePath(parabola, frame)}></path>`;
}
