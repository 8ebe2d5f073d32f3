import { html, render } from 'lit';
import { mountStrip } from '../charts/strip.ts';
import { algebra } from '../panels/algebra.ts';
import { controls, shapePicker } from '../panels/controls.ts';
import type { Dispatch } from '../state/actions.ts';
import { createDerive } from '../state/derive.ts';
import type { SceneModel } from '../state/scene-model.ts';
import type { AppState } from '../state/state.ts';
import type { Mounted } from '../ui/mounted.ts';
import './explore.css';

/** Scene and graph on the left, parameters and algebra on the right. The scene comes when it has been loaded. */
export function mountExplore(host: HTMLElement, dispatch: Dispatch): Mounted<AppState> {
  const derive = createDerive();
  host.classList.add('explore');
  host.innerHTML = '';
  const scene = section(host, 'scene-area');
  const graph = section(host, 'strip-area');
  const panel = section(host, 'panel-area');
  const strip = mountStrip(graph, dispatch);
  const late = lateScene(scene, dispatch);
  return {
    render(state) {
      const model = derive(state);
      render(
        html`${shapePicker(model, dispatch)}${controls(model, dispatch)}${algebra(model, dispatch)}`,
        panel,
      );
      strip.render(model.strip);
      late.render(model.scene);
    },
    dispose() {
      strip.dispose();
      late.dispose();
    },
  };
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
