import { html, nothing, render, type TemplateResult } from 'lit';
import { algebra } from '../../panels/algebra.ts';
import { controls } from '../../panels/controls.ts';
import { endsControls, endsLines } from '../../panels/ends.ts';
import { hitTable } from '../../panels/hits.ts';
import type { Dispatch } from '../../state/actions.ts';
import { type ExploreModel, isFull } from '../../state/derive.ts';
import { PARTS, type Part } from '../../state/embed.ts';
import type { AppState } from '../../state/state.ts';
import { encode } from '../../state/url.ts';
import type { Mounted } from '../../ui/mounted.ts';
import { lazyGraph } from '../explore/lazy-graph.ts';
import { lazyScene } from '../lazy-scene.ts';
import './embed.css';

/** The whole of Graze with the same ray, shape and look. */
const wholePage = (state: AppState): string =>
  encode({ ...state, embed: null, lock: [], theme: null });

/**
 * Parts of Explore for a page that is not Graze's own. They take the room that `host` has; keys
 * that no control takes are the host's. `home`: address of the full page, without a hash; null
 * where it is not known, and then the mark is no link.
 */
export function mountEmbed(
  host: HTMLElement,
  dispatch: Dispatch,
  home: string | null,
): Mounted<ExploreModel> {
  host.classList.add('embed');
  const grid = document.createElement('div');
  grid.className = 'embed-grid';
  host.append(grid);
  const area = (name: string): HTMLElement => {
    const element = document.createElement('div');
    element.className = `embed-${name}`;
    grid.append(element);
    return element;
  };
  // In reading order.
  const [caption, sceneArea, graphArea] = [area('caption'), area('scene'), area('graph')];
  const [panel, mark] = [area('panel'), area('mark')];
  // Their code is loaded when they are shown for the first time.
  let scene: ReturnType<typeof lazyScene> | null = null;
  let graph: ReturnType<typeof lazyGraph> | null = null;
  return {
    render(model) {
      const parts: readonly Part[] = model.state.embed ?? PARTS;
      const has = (part: Part): boolean => parts.includes(part);
      grid.dataset.parts = parts.join(' ');
      sceneArea.hidden = !has('scene');
      graphArea.hidden = !has('graph');
      render(captionOf(model, has('caption')), caption);
      render(panelOf(model, has, dispatch), panel);
      render(markOf(model.state, home), mark);
      if (!isFull(model)) return;
      if (has('scene')) {
        scene ??= lazyScene(sceneArea, dispatch);
        scene.render(model.scene);
      }
      if (has('graph')) {
        graph ??= lazyGraph(graphArea, dispatch);
        graph.render(model.graph);
      }
    },
    dispose() {
      scene?.dispose();
      graph?.dispose();
      host.replaceChildren();
    },
  };
}

function panelOf(
  model: ExploreModel,
  has: (part: Part) => boolean,
  dispatch: Dispatch,
): TemplateResult {
  const hits = model.shown.hits ? html`${hitTable(model)}${endsLines(model, dispatch)}` : nothing;
  const lines = has('algebra') ? algebra(model, dispatch, undefined, endsLines) : null;
  return html`${has('parameters') ? controls(model, dispatch, endsControls) : nothing}
    ${lines ?? (has('hits') ? hits : nothing)}`;
}

/** The example's title, or what the shape is, and the verdict; what was wrong with the link. */
function captionOf(model: ExploreModel, wanted: boolean): TemplateResult {
  const { state, example, title, verdict, shown } = model;
  const name = example?.changed === false && shown.verdict ? example.entry.title : title;
  return html`${
    wanted
      ? html`<p class="embed-title"><strong>${name}</strong>${
          shown.verdict ? `: ${verdict.text}` : ''
        }</p>`
      : nothing
  }${state.problems.map(
    (words) => html`<p class="embed-problem" data-say="problem">${words}</p>`,
  )}`;
}

function markOf(state: AppState, home: string | null): TemplateResult {
  const link = home && `${home}${wholePage(state)}`;
  return link
    ? html`<a href=${link} target="_blank" rel="noopener"
        title="Open this ray and shape in Graze, in a new tab">Graze</a>`
    : html`<span>Graze</span>`;
}
