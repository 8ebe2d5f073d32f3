import { html, svg, type TemplateResult } from 'lit';
import type { StripModel } from '../state/strip-model.ts';
import { bead, readout } from './strip-bead.ts';
import { type Parabola, parabolaOf } from './strip-curve.ts';
import type { Frame } from './strip-frame.ts';
import { definitions, grid } from './strip-grid.ts';
import { area, curve, rayAxis, words } from './strip-layers.ts';
import { roots } from './strip-roots.ts';
import type { Scales } from './strip-scales.ts';

/** What the strip does when it is touched. They stay the same from one drawing to the next. */
export interface Handlers {
  readonly key: (event: KeyboardEvent) => void;
  readonly down: (event: PointerEvent) => void;
  readonly move: (event: PointerEvent) => void;
  readonly up: (event: PointerEvent) => void;
  readonly cancel: (event: PointerEvent) => void;
}

const CONTAINED = 'f(t) = 0 for every t';
const NOT_DRAWN = 'f leaves the range of numbers here and cannot be drawn';

/** The whole strip: description, picture, bead, numbers, and a note where something cannot be shown. */
export function page(
  model: StripModel,
  frame: Frame,
  scales: Scales | null,
  id: string,
  handlers: Handlers,
): TemplateResult {
  const parabola = scales && parabolaOf(model);
  const note = noteOf(model, parabola);
  // The picture is a group, not an image: the bead within it must stay reachable.
  return html`<p class="strip-text" id="${id}-text">${model.description}</p>
    <svg class="strip-svg" role="group" aria-label="graph of f on the ray" aria-describedby="${id}-text"
      width=${frame.width} height=${frame.height} @pointerdown=${handlers.down} @pointermove=${handlers.move}
      @pointerup=${handlers.up} @pointercancel=${handlers.cancel}>
      ${scales ? svg`<g aria-hidden="true">${layers(model, scales, parabola, id)}</g>${bead(model, scales, parabola, handlers.key)}` : ''}
    </svg>
    ${readout(model, frame)}
    ${note === null ? '' : html`<p class="strip-note" .style=${`top:${frame.top}px`}>${note}</p>`}`;
}

function noteOf({ note, contained }: StripModel, parabola: Parabola | null): string | null {
  if (note !== null) return note;
  if (parabola === null) return NOT_DRAWN;
  return contained ? CONTAINED : null;
}

function layers(
  model: StripModel,
  scales: Scales,
  parabola: Parabola | null,
  id: string,
): TemplateResult {
  return svg`${definitions(scales, id)}${grid(scales, id)}
    ${parabola ? area(parabola, scales, id) : ''}${rayAxis(model, scales)}
    ${parabola ? curve(parabola, scales, id) : ''}${words(model, scales)}${roots(model, scales)}`;
}
