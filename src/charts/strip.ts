import './strip.css';
import { html, render, svg, type TemplateResult } from 'lit';
import type { Dispatch } from '../state/actions.ts';
import type { StripModel } from '../state/strip-model.ts';
import type { Mounted } from '../ui/mounted.ts';
import { bead, readout } from './strip-bead.ts';
import { type Parabola, parabolaOf } from './strip-curve.ts';
import { type Frame, frameOf } from './strip-frame.ts';
import { definitions, grid } from './strip-grid.ts';
import { area, curve, rayAxis, words } from './strip-layers.ts';
import { watchMetrics } from './strip-metrics.ts';
import { keyTarget, pointerMoves, type Shown } from './strip-move.ts';
import { roots } from './strip-roots.ts';
import { type Scales, scalesOf } from './strip-scales.ts';

const NOT_DRAWN = 'f leaves the range of numbers here and cannot be drawn';
let strips = 0;

/** The graph of f on the ray's own t, with a bead that can be moved. Fills its host; draws only when asked or resized. */
export function mountStrip(host: HTMLElement, dispatch: Dispatch): Mounted<StripModel> {
  const id = `strip-${++strips}`;
  let model: StripModel | null = null;
  let shown: Shown | null = null;
  host.classList.add('strip');
  const pointer = pointerMoves(() => shown, dispatch);
  const key = (event: KeyboardEvent) => {
    const t = shown && keyTarget(event, shown);
    if (t === null || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    dispatch({ type: 'bead', t });
  };
  const watch = watchMetrics(host, draw);

  function draw(): void {
    const metrics = watch.metrics();
    if (model === null || metrics === null) return;
    const frame = frameOf(metrics);
    const scales = scalesOf(model, frame);
    shown = scales && { model, scales };
    render(page(model, frame, scales), watch.slot);
  }

  function page(model: StripModel, frame: Frame, scales: Scales | null): TemplateResult {
    const parabola = scales && parabolaOf(model);
    const note = model.note ?? (parabola ? null : NOT_DRAWN);
    return html`<p class="strip-text" id="${id}-text">${model.description}</p>
      <svg class="strip-svg" role="group" aria-label="graph of f on the ray" aria-describedby="${id}-text"
        width=${frame.width} height=${frame.height} @pointerdown=${on(pointer.down)} @pointermove=${on(pointer.move)}
        @pointerup=${on(pointer.up)} @pointercancel=${pointer.cancel}>
        ${scales ? svg`<g aria-hidden="true">${layers(model, scales, parabola)}</g>${bead(model, scales, parabola, key)}` : ''}
      </svg>
      ${readout(model, frame)}
      ${note === null ? '' : html`<p class="strip-note" style="top:${frame.top}px">${note}</p>`}`;
  }

  function layers(model: StripModel, scales: Scales, parabola: Parabola | null): TemplateResult {
    return svg`${definitions(scales, id)}${grid(scales, id)}
      ${parabola ? area(parabola, scales, id) : ''}${rayAxis(model, scales)}
      ${parabola ? curve(parabola, scales, id) : ''}${words(model, scales)}${roots(model, scales)}`;
  }

  return {
    render(next) {
      model = next;
      draw();
    },
    dispose() {
      watch.dispose();
      host.classList.remove('strip');
    },
  };
}

const on = (handle: (event: PointerEvent, svg: Element) => void) => (event: PointerEvent) => {
  if (event.currentTarget instanceof Element) handle(event, event.currentTarget);
};
