import { html, svg, type TemplateResult } from 'lit';
import type { GraphModel } from '../state/graph-model.ts';
import { bead, readout } from './graph-bead.ts';
import { type Parabola, parabolaOf } from './graph-curve.ts';
import { type Frame, frameOf, type Metrics } from './graph-frame.ts';
import { definitions, grid } from './graph-grid.ts';
import { area, curve, ghost, rayAxis, trail, words } from './graph-layers.ts';
import { mark } from './graph-mark.ts';
import { caps, roots } from './graph-roots.ts';
import { type Scales, scalesOf } from './graph-scales.ts';
import { square } from './graph-square.ts';

/** Event handlers of the graph; the same functions at every render. */
export interface Handlers {
  readonly key: (event: KeyboardEvent) => void;
  readonly down: (event: PointerEvent) => void;
  readonly move: (event: PointerEvent) => void;
  readonly up: (event: PointerEvent) => void;
  readonly cancel: (event: PointerEvent) => void;
}

const CONTAINED = 'f(t) = 0 for every t';
const CONCEALED = 'f is hidden';
const NOT_DRAWN = 'f leaves the range of numbers here and cannot be drawn';

/** The whole graph: description, picture, bead, readout, and a note on what is not shown. */
export function page(
  model: GraphModel,
  frame: Frame,
  scales: Scales | null,
  id: string,
  handlers: Handlers,
): TemplateResult {
  const parabola = scales && parabolaOf(model);
  const note = noteOf(model, parabola);
  // The picture has the role of a group, since the bead in an image could not be reached.
  return html`<p class="graph-text" id="${id}-text">${model.description}</p>
    <svg class="graph-svg" role="group" aria-label="graph of f on the ray"
      aria-describedby="${id}-text"
      width=${frame.width} height=${frame.height} @pointerdown=${handlers.down}
        @pointermove=${handlers.move}
      @pointerup=${handlers.up} @pointercancel=${handlers.cancel}>
      ${
        scales
          ? svg`<g
        aria-hidden="true">${layers(model, scales, parabola, id)}</g>${bead(
          model,
          scales,
          parabola,
          handlers.key,
        )}`
          : ''
      }
    </svg>
    ${readout(model, frame)}
    ${note === null ? '' : html`<p class="graph-note" .style=${`top:${frame.top}px`}>${note}</p>`}`;
}

const UNTOUCHED: Handlers = { key() {}, down() {}, move() {}, up() {}, cancel() {} };

/** The graph for paper, which nobody touches. `id` is its own in the document. */
export function stillGraph(model: GraphModel, metrics: Metrics, id: string): TemplateResult {
  const frame = frameOf(metrics);
  return page(model, frame, scalesOf(model, frame), id, UNTOUCHED);
}

function noteOf(
  { note, contained, concealed }: GraphModel,
  parabola: Parabola | null,
): string | null {
  if (concealed) return CONCEALED;
  if (note !== null) return note;
  if (parabola === null) return NOT_DRAWN;
  return contained ? CONTAINED : null;
}

function layers(
  model: GraphModel,
  scales: Scales,
  parabola: Parabola | null,
  id: string,
): TemplateResult {
  const shown = model.concealed ? { ...scales, fTicks: [] } : scales;
  return svg`${definitions(scales, id)}${grid(shown, id)}
    ${parabola ? area(parabola, scales, id) : ''}${rayAxis(model, scales)}
    ${ghost(model, scales, id)}${trail(model, scales, id)}
    ${parabola ? curve(parabola, scales, id) : ''}
    ${model.square || model.mark?.gap ? '' : words(model, scales)}
    ${square(model, scales)}${roots(model, scales)}${caps(model, scales)}
    ${mark(model, scales)}`;
}
