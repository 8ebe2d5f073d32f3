import { html, render, type TemplateResult } from 'lit';
import { algebra } from '../../panels/algebra.ts';
import { compactControls, equations } from '../../panels/compact-controls.ts';
import { controls } from '../../panels/controls.ts';
import type * as Ends from '../../panels/ends.ts';
import type { normalLine as NormalLine } from '../../panels/normal-line.ts';
import { shapePicker } from '../../panels/shape-picker.ts';
import type { Dispatch } from '../../state/actions.ts';
import { type ExploreModel, isFull } from '../../state/derive.ts';
import { INITIAL } from '../../state/state.ts';
import type { Announce } from '../../ui/announcer.ts';
import { lazy } from '../../ui/lazy.ts';
import { lazyScene, type Scene } from '../lazy-scene.ts';
import { lazyView } from '../lazy-view.ts';
import type { exampleQuestion as ExampleQuestion } from './example-question.ts';
import { lazyGraph } from './lazy-graph.ts';
import type { MarkedModels } from './predict-card.ts';
import { type SceneBarTools, sceneBar } from './scene-bar.ts';
import type { SecondView } from './second-view.ts';
import type { MountedWalk } from './walk.ts';
import './explore-page.css';
import './projector.css';

/** Number of performance measures that are kept for the bench and the browser's profiler. */
const KEPT_MEASURES = 200;

export interface ExploreTools extends SceneBarTools {
  /** Draws the example's question; null until the gallery is loaded. */
  readonly exampleQuestion: typeof ExampleQuestion | null;
  /** The line of N; null until it is loaded. */
  readonly normalLine: typeof NormalLine | null;
  /** Controls and lines for a shape's ends; null until they are loaded. */
  readonly ends: typeof Ends | null;
  readonly secondView: SecondView | null;
  /** Theme projector: one parameter is shown at a time, as on a phone. */
  readonly large: boolean;
}

export interface Explore {
  render(model: ExploreModel, tools: ExploreTools): void;
  dispose(): void;
  readonly scene: Scene;
  /** The graph of f as an element, for the export. */
  graph(): SVGSVGElement | null;
}

/**
 * Scene and graph on the left, parameters and algebra on the right. The scene comes when it has
 * been loaded.
 */
export function mountExplore(
  host: HTMLElement,
  dispatch: Dispatch,
  changed: () => void,
  announce: Announce,
): Explore {
  host.classList.add('explore');
  const picker = section(host, 'picker-area');
  const stage = section(host, 'scene-area');
  const question = section(host, 'example-question');
  question.hidden = true;
  const graphArea = section(host, 'graph-area');
  const panel = section(host, 'panel-area');
  const walkArea = section(host, 'walk-area');
  let walk: ReturnType<typeof lazyWalk> | null = null;
  const bar = section(stage, 'scene-bar');
  const graph = lazyGraph(section(graphArea, 'graph-host'), dispatch);
  const scene = lazyScene(section(stage, 'scene-host'), dispatch);
  let untouched = true;
  /** Whether the page was opened with an empty address; null before it is first shown. */
  let visit: boolean | null = null;
  const predict = lazyCard(
    () =>
      lazy(() => import('./predict-card.ts')).then(({ createPredictCard }) =>
        createPredictCard(dispatch),
      ),
    changed,
  );
  const challenges = lazyCard(
    () =>
      lazy(() => import('./challenges.ts')).then(({ createChallenges }) =>
        createChallenges(changed, announce),
      ),
    changed,
  );
  const narrow = matchMedia('(max-width: 559px), (max-width: 899px) and (max-height: 499px)');
  const wide = matchMedia('(min-width: 900px)');
  narrow.addEventListener('change', changed);
  wide.addEventListener('change', changed);
  // Parameters come before the algebra, in reading and focus order.
  const panelContent = (model: ExploreModel, card: TemplateResult, tools: ExploreTools) => {
    const compact = narrow.matches || (tools.large && wide.matches);
    const params = compact
      ? compactControls(model, dispatch, changed, tools.ends?.endsControls ?? null)
      : controls(model, dispatch, tools.ends?.endsControls ?? null);
    const body = compact ? html`${equations(model, dispatch)}${card}` : card;
    return wide.matches
      ? html`${params}${predict.host}${body}`
      : html`${predict.host}${body}${params}`;
  };
  return {
    scene,
    graph: () => graphArea.querySelector('svg'),
    render(model, tools) {
      const begun = performance.now();
      const marked = predict.render(model, model.state.revealed !== null);
      render(shapePicker(model, dispatch), picker);
      const walking = model.state.derive !== null;
      if (walking) walk ??= lazyWalk(walkArea, dispatch, changed, announce);
      host.classList.toggle('walking', walking);
      walk?.render(model);
      const card = algebra(model, dispatch, tools.normalLine, tools.ends?.endsLines);
      render(panelContent(model, card, tools), panel);
      const isFirst = model.state.E.every((x, i) => x === INITIAL.E[i]);
      visit ??= isFirst;
      untouched &&= isFirst && model.example === null;
      challenges.render(model, visit && !untouched);
      render(sceneBar(model, tools, untouched, challenges.host), bar);
      tools.exampleQuestion?.(question, model, dispatch);
      if (!isFull(model)) return;
      const beside = walking ? walk?.view() : null;
      const shown = beside?.scene(model) ?? marked?.scene ?? model.scene;
      tools.secondView?.render(stage, shown);
      graph.render(beside?.graph(model) ?? marked?.graph ?? model.graph);
      const drawn = performance.now();
      scene.render(shown);
      measure('graze step', begun, drawn);
      measure('graze scene', drawn, performance.now());
    },
    dispose() {
      narrow.removeEventListener('change', changed);
      wide.removeEventListener('change', changed);
      walk?.dispose();
      graph.dispose();
      scene.dispose();
    },
  };
}

/** The walk beside the scene, whose code is loaded when it is first opened. */
function lazyWalk(host: HTMLElement, dispatch: Dispatch, changed: () => void, announce: Announce) {
  const opener = document.activeElement;
  return lazyView<ExploreModel, typeof import('./walk.ts'), MountedWalk>(
    host,
    () => lazy(() => import('./walk.ts')),
    ({ mountWalk }) => {
      // The walk also changes what scene and graph show.
      changed();
      return mountWalk(host, dispatch, opener, changed, announce);
    },
    { waiting: 'loading…', failed: 'This could not be loaded.' },
  );
}

/** Draws into its element; returns models of scene and graph to show in place of the page's. */
type Card = (host: HTMLElement, model: ExploreModel) => MarkedModels;

/** A part of the page whose code is loaded when it is first wanted. */
function lazyCard(
  create: () => Promise<Card>,
  changed: () => void,
): { readonly host: HTMLElement; render(model: ExploreModel, wanted: boolean): MarkedModels } {
  const host = document.createElement('div');
  let card: Card | null = null;
  let asked = false;
  const load = (): void => {
    asked = true;
    create().then(
      (created) => {
        card = created;
        changed();
      },
      // Loads again at the next change.
      () => {
        asked = false;
      },
    );
  };
  return {
    host,
    render(model, wanted) {
      if (card) return card(host, model);
      if (wanted && !asked) load();
      return null;
    },
  };
}

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
