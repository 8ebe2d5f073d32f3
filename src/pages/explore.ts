import { html, render } from 'lit';
import { mountStrip } from '../charts/strip.ts';
import { algebra } from '../panels/algebra.ts';
import { compactControls, equations } from '../panels/compact-controls.ts';
import { controls } from '../panels/controls.ts';
import { shapePicker } from '../panels/shape-picker.ts';
import type { Dispatch } from '../state/actions.ts';
import { createDerive } from '../state/derive.ts';
import type { SceneModel } from '../state/scene-model.ts';
import type { AppState } from '../state/state.ts';
import type { Mounted } from '../ui/mounted.ts';
import './explore.css';

const KEPT_MEASURES = 200;

/** Scene and graph on the left, parameters and algebra on the right. The scene comes when it has been loaded. */
export function mountExplore(host: HTMLElement, dispatch: Dispatch): Mounted<AppState> {
  const derive = createDerive();
  host.classList.add('explore');
  host.innerHTML = '';
  const picker = section(host, 'picker-area');
  const scene = section(host, 'scene-area');
  const graph = section(host, 'strip-area');
  const panel = section(host, 'panel-area');
  const strip = mountStrip(graph, dispatch);
  const late = lateScene(scene, dispatch);
  const narrow = matchMedia('(max-width: 559px)');
  let latest: AppState | null = null;
  const relayout = (): void => {
    if (latest) mounted.render(latest);
  };
  narrow.addEventListener('change', relayout);
  const mounted: Mounted<AppState> = {
    render(state) {
      latest = state;
      const begun = performance.now();
      const model = derive(state);
      render(shapePicker(model, dispatch), picker);
      const card = algebra(model, dispatch);
      render(
        narrow.matches
          ? html`${equations(model, dispatch)}${card}${compactControls(model, dispatch, relayout)}`
          : html`${card}${controls(model, dispatch)}`,
        panel,
      );
      strip.render(model.strip);
      const drawn = performance.now();
      late.render(model.scene);
      measure('graze step', begun, drawn);
      measure('graze scene', drawn, performance.now());
    },
    dispose() {
      narrow.removeEventListener('change', relayout);
      strip.dispose();
      late.dispose();
    },
  };
  return mounted;
}

/** For the bench and the browser's own profiler; only the latest are kept. */
function measure(name: string, start: number, end: number): void {
  if (performance.getEntriesByName(name).length >= KEPT_MEASURES) performance.clearMeasures(name);
  performance.measure(name, { start, end });
}

function section(host: HTMLElement, className: string): HTMLElement {
  const element = document.createElement('div');
  element.className = className;
  host.append(element);
  return element;
}

/** three.js is a chunk of its own: formulas stand on the page before it arrives, and without it if it does not. */
function lateScene(host: HTMLElement, dispatch: Dispatch): Mounted<SceneModel> {
  let model: SceneModel | null = null;
  let mounted: Mounted<SceneModel> | null = null;
  let disposed = false;
  const waiting = setTimeout(() => {
    host.dataset.waiting = 'drawing…';
  }, 300);
  const done = (): void => {
    clearTimeout(waiting);
    delete host.dataset.waiting;
  };
  import('../canvas/scene.ts').then(
    ({ mountScene }) => {
      done();
      if (disposed) return;
      mounted = mountScene(host, dispatch);
      if (model) mounted.render(model);
    },
    () => {
      done();
      host.dataset.waiting =
        'The picture could not be loaded. All numbers, formulas and the plot work.';
    },
  );
  return {
    render(next) {
      model = next;
      mounted?.render(next);
    },
    dispose() {
      disposed = true;
      mounted?.dispose();
    },
  };
}
