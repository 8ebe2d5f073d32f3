import { html, nothing, type TemplateResult } from 'lit';
import type { ExploreModel } from '../../state/derive.ts';
import { titleOf } from '../../state/example.ts';
import type { Command } from '../commands.ts';
import './scene-bar.css';

export interface SceneBarTools {
  readonly command: (id: string) => Command | undefined;
  readonly playing: boolean;
  readonly soundOn: boolean;
  readonly second: boolean;
}

/** Words on what this is and what to do, before a first change; true of shapes that have a D. */
const INVITATION = 'Where does a ray meet a surface? Drag E. Watch D change its sign.';

/** The bar over the scene: the example, and commands for the ray. */
export function sceneBar(
  { state, example, found }: ExploreModel,
  { command, playing, soundOn, second }: SceneBarTools,
  untouched: boolean,
  challenges: HTMLElement,
): TemplateResult {
  const run = (id: string) => () => command(id)?.run();
  const hidden = state.revealed !== null;
  const hideWord = hidden ? 'show results' : 'hide results';
  const invites = untouched && !hidden && found.details.family === 'curved';
  return html`<div class="example" role="group" aria-label="Examples">
      <button type="button" class="example-name" aria-haspopup="dialog" @click=${run('gallery')}>
        <span class="words">example:</span>
        <strong>${example ? titleOf(example, hidden) : 'choose one'}</strong>
        <span aria-hidden="true">▾</span>
      </button>
      <span class="steps-through">
        ${step('Previous example', 'M10 4L5.5 8L10 12', run('previous'))}
        ${step('Next example', 'M6 4L10.5 8L6 12', run('next'))}
      </span>
      ${
        invites
          ? html`<p class="invitation"><span>${INVITATION}</span>
              <a href="#/lesson/ray">First lesson</a></p>`
          : example
            ? nothing
            : challenges
      }
    </div>
    <div class="ray-tools" role="group" aria-label="This ray">
      ${toggle(playing ? 'stop' : 'play', playing, run('play'), 'Play the bead along the ray (p)')}
      ${toggle('hear', soundOn, run('hear'), 'Hear f along the ray (m)')}
      ${toggle('ghost', state.ghost !== null, run('ghost'), 'Keep this ray as a ghost (g)')}
      ${toggle('two views', second, run('second'), 'A second view beside this one (v)')}
      ${action('reset', run('reset'), 'Reset the ray and this shape (Shift+R)')}
      ${toggle(hideWord, hidden, run('hide'), 'Hide the results to predict them (h)')}
      ${hidden ? action('reveal next', run('reveal'), 'Reveal the next line (n)') : nothing}
    </div>`;
}

function step(label: string, path: string, run: () => void): TemplateResult {
  return html`<button type="button" class="step-through" aria-label=${label} title=${label}
    @click=${run}>
    <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d=${path} /></svg>
  </button>`;
}

function action(text: string, run: () => void, title: string): TemplateResult {
  return html`<button type="button" class="ray-tool" title=${title} @click=${run}>${text}</button>`;
}

function toggle(text: string, pressed: boolean, run: () => void, title: string): TemplateResult {
  return html`<button type="button" class="ray-tool" data-tool=${text} aria-pressed=${pressed}
    title=${title} @click=${run}>${text}</button>`;
}
