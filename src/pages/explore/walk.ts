import { html, nothing, render, type TemplateResult } from 'lit';
import { walkOf } from '../../math/formula.ts';
import { symbol } from '../../panels/formula.ts';
import { rayHandles, shapeHandles } from '../../panels/params-of.ts';
import { classOf } from '../../panels/symbols.ts';
import type { Dispatch } from '../../state/actions.ts';
import type { ExploreModel, FullModel } from '../../state/derive.ts';
import type { GraphModel } from '../../state/graph-model.ts';
import type { SceneModel } from '../../state/scene-model.ts';
import { stepShown } from '../../state/state.ts';
import { graphAt, isAboutF, type NormalChoice, sceneAt } from '../../state/walk-figures.ts';
import { display, displayTriple } from '../../text/format.ts';
import type { Announce } from '../../ui/announcer.ts';
import type { Mounted } from '../../ui/mounted.ts';
import { type NormalsShown, type Step, stepOf } from './walk-steps.ts';
import { animateTerms, isAnimating, lightTerms, termRectangles } from './walk-terms.ts';
import { drawThreads, fitLines } from './walk-threads.ts';
import '../../ui/dialog.css';
import './walk.css';

/** The steps; fewer if A is exactly 0, unless results are hidden: their number would show it. */
function stepsOf({ shape, exactly, shown }: ExploreModel): readonly Step[] {
  const { details } = exactly.found;
  return walkOf(shape, shown.hits && details.family === 'curved' && details.signs.A === 0);
}

export interface MountedWalk extends Mounted<ExploreModel> {
  /** The scene and the graph to show beside the present step. */
  scene(model: FullModel): SceneModel;
  graph(model: FullModel): GraphModel;
}

const MOVES: Readonly<Record<string, (at: number, last: number) => number>> = {
  Home: () => 1,
  End: (_, last) => last,
};

/**
 * The walk: the derivation's lines up to the present step, and a bar to go to any other. `opener`
 * gets the focus back when it is closed.
 */
export function mountWalk(
  host: HTMLElement,
  dispatch: Dispatch,
  opener: Element | null,
  changed: () => void,
  announce: Announce,
): MountedWalk {
  let back = opener;
  let choice: NormalChoice = { unit: false, facing: false };
  const choose = (next: NormalChoice): void => {
    choice = next;
    changed();
  };
  /** The step that was drawn last; null while it is closed. */
  let drawn: number | null = null;
  let last = 0;
  /** The id of that step; '' while it is closed. */
  let present = '';
  const go = (to: number): void => dispatch({ type: 'derive', step: to });
  const close = (): void => dispatch({ type: 'derive', step: null });
  const key = (event: KeyboardEvent): void => {
    if (event.defaultPrevented || event.altKey || event.ctrlKey || event.metaKey) return;
    if (document.querySelector('dialog[open]')) return;
    if (event.key !== 'Escape' || drawn === null) return;
    event.preventDefault();
    close();
  };
  document.addEventListener('keydown', key);
  host.addEventListener('keydown', (event) => {
    const to = MOVES[event.key]?.(drawn ?? 1, last);
    if (!to || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    go(to);
  });
  lightTerms(host);
  const draw = (): void => {
    fitLines(host);
    if (!isAnimating(host)) drawThreads(host);
  };
  const resized = new ResizeObserver(draw);
  resized.observe(host);
  // Formulas are wider or narrower once their font is there.
  document.fonts.addEventListener('loadingdone', draw);

  /** Scrolls the present step into view, from its beginning if it does not fit. */
  const showPresent = (): void => {
    const steps = host.querySelector('.walk-steps');
    const present = host.querySelector('.walk-step.present');
    if (!steps || !present) return;
    const isLong = present.clientHeight > steps.clientHeight;
    present.scrollIntoView({ block: isLong ? 'start' : 'nearest' });
  };
  /** On a phone the graph takes room from the steps, so it is shown with those about f alone. */
  const showGraph = (on: boolean): void => {
    host.parentElement?.classList.toggle('about-f', on);
  };
  const open = (): void => {
    const section = host.querySelector<HTMLElement>('.walk');
    // If a link opened the walk, the focus is not moved.
    if (back && back !== document.body) section?.focus({ preventScroll: true });
  };
  return {
    render(model) {
      const at = stepShown(model.state);
      present = '';
      if (at === null) {
        showGraph(false);
        render(nothing, host);
        if (drawn !== null && back instanceof HTMLElement) back.focus({ preventScroll: true });
        drawn = back = null;
        return;
      }
      const isNew = drawn === null;
      if (isNew && !back) back = document.activeElement;
      const steps = stepsOf(model);
      last = steps.length;
      present = steps[at - 1]?.id ?? '';
      showGraph(isAboutF(model, present));
      const before = drawn !== null && drawn !== at ? termRectangles(host) : null;
      render(walk(model, steps, at, { go, close, normals: { choice, choose } }), host);
      draw();
      if (isNew) open();
      if (drawn !== at) {
        showPresent();
        const step = steps[at - 1];
        announce(`Step ${at} of ${steps.length}, ${step?.name}: ${step?.why}`, 'walk');
      }
      if (before) animateTerms(host, before, draw);
      drawn = at;
    },
    scene: (model) => sceneAt(model, present, choice),
    graph: (model) => graphAt(model, present),
    dispose() {
      showGraph(false);
      document.removeEventListener('keydown', key);
      document.fonts.removeEventListener('loadingdone', draw);
      resized.disconnect();
      render(nothing, host);
    },
  };
}

interface Going {
  go(to: number): void;
  close(): void;
  readonly normals: NormalsShown;
}

function walk(
  model: ExploreModel,
  steps: readonly Step[],
  at: number,
  { go, close, normals }: Going,
): TemplateResult {
  const isCurved = model.found.details.family === 'curved';
  const what = isCurved ? html`<i>A</i>, <i>B</i>, <i>C</i> come from` : html`<i>t</i> comes from`;
  return html`<section class="walk" tabindex="-1" aria-label="The derivation, step by step">
    <header class="walk-head">
      <h2>Where ${what}</h2>
      <span class="walk-shape">${model.title}</span>
      ${given(model)}
      <button type="button" class="walk-close" aria-label="Close the derivation"
        title="Close (Esc)" @click=${close}>×</button>
    </header>
    <div class="walk-steps" tabindex="0" role="group" aria-label="Steps up to the present one">
      <ol>${steps
        .slice(0, at)
        .map((one, i) => stepOf(one, i + 1, i + 1 === at, model, normals))}</ol>
      <svg class="walk-threads" aria-hidden="true"></svg>
    </div>
    ${bar(steps, at, go)}
  </section>`;
}

/** E, d and the shape's parameters with their values. */
function given(model: ExploreModel): TemplateResult {
  const none = (): void => {};
  const all = [...rayHandles(model, none), ...shapeHandles(model, none)];
  return html`<p class="walk-given">${all.map(({ param, value }) => {
    const cls = `sym ${classOf(param.symbol, param.type === 'vector' ? 'vector' : 'scalar')}`;
    const text =
      typeof value === 'object'
        ? displayTriple(value)
        : typeof value === 'number'
          ? display(value)
          : value;
    return html`<span>${
      param.symbol.length === 1 ? symbol(param.symbol, null, cls, param.symbol) : param.symbol
    } = <span class=${cls}>${text}</span></span> `;
  })}</p>`;
}

function bar(steps: readonly Step[], at: number, go: (to: number) => void): TemplateResult {
  /** A drag along the bar shows the nearest step. */
  const scrub = (event: PointerEvent): void => {
    if (event.buttons !== 1) return;
    const stops = [...(event.currentTarget as Element).children];
    const away = stops.map((stop) => {
      const { left, width } = stop.getBoundingClientRect();
      return Math.abs(event.clientX - left - width / 2);
    });
    const nearest = away.indexOf(Math.min(...away)) + 1;
    if (nearest !== at) go(nearest);
  };
  return html`<div class="walk-bar" role="group" aria-label="Steps of the derivation">
    <button type="button" class="button" aria-disabled=${at === 1}
      @click=${() => go(at - 1)}>Back</button>
    <ol @pointermove=${scrub}>
      ${steps.map(
        ({ name }, i) =>
          html`<li><button type="button"
            class=${i < at ? 'walk-stop done' : 'walk-stop'}
            aria-current=${i + 1 === at ? 'step' : nothing}
            @click=${() => go(i + 1)}><span>${name}</span></button></li>`,
      )}
    </ol>
    <button type="button" class="button primary" aria-disabled=${at === steps.length}
      @click=${() => go(at + 1)}>Next</button>
  </div>`;
}
