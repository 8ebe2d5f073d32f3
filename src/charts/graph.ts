import './graph.css';
import { html, render } from 'lit';
import type { Dispatch } from '../state/actions.ts';
import type { GraphModel } from '../state/graph-model.ts';
import type { Mounted } from '../ui/mounted.ts';
import { frameOf } from './graph-frame.ts';
import { watchMetrics } from './graph-metrics.ts';
import { type DrawnGraph, keyTarget, pointerMoves } from './graph-move.ts';
import { scalesOf } from './graph-scales.ts';
import { type Handlers, page } from './graph-view.ts';

const CONCEALED = html`<p class="graph-concealed">Hidden. Predict first: where is f zero?</p>`;

let graphs = 0;

/** The graph of f over t with a movable bead. It fills its host, and draws on render and resize. */
export function mountGraph(host: HTMLElement, dispatch: Dispatch): Mounted<GraphModel> {
  const id = `graph-${++graphs}`;
  let model: GraphModel | null = null;
  let shown: DrawnGraph | null = null;
  // A key may come before the next frame: it continues from the t that was sent last.
  const send: Dispatch = (action) => {
    if (action.type === 'bead' && typeof action.t === 'number')
      shown = shown && moved(shown, action.t);
    dispatch(action);
  };
  const handlers = handlersOf(() => shown, send);
  host.classList.add('graph');
  const watch = watchMetrics(host, draw);

  function draw(): void {
    const metrics = watch.metrics();
    if (model === null || metrics === null) return;
    if (model.concealed && !model.mark) {
      shown = null;
      render(CONCEALED, watch.slot);
      return;
    }
    const frame = frameOf(metrics);
    const scales = scalesOf(model, frame);
    shown = scales && { model, scales };
    render(page(model, frame, scales, id, handlers), watch.slot);
  }

  return {
    render(next) {
      model = next;
      draw();
    },
    dispose() {
      watch.dispose();
      host.classList.remove('graph');
    },
  };
}

function moved({ model, scales }: DrawnGraph, t: number): DrawnGraph {
  return { scales, model: { ...model, bead: { ...model.bead, t } } };
}

function handlersOf(shown: () => DrawnGraph | null, dispatch: Dispatch): Handlers {
  return {
    ...pointerMoves(shown, dispatch),
    key(event) {
      const now = shown();
      const t = now && keyTarget(event, now);
      if (t === null || event.altKey || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      if (t !== now?.model.bead.t) dispatch({ type: 'bead', t });
    },
  };
}
