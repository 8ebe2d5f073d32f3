import { html, nothing, render } from 'lit';
import { drawStill } from '../../canvas/thumbnail.ts';
import { createDerive } from '../../state/derive.ts';
import { provideExamples } from '../../state/example.ts';
import { exploreDetails } from '../../state/explore-details.ts';
import { GALLERY } from '../../state/gallery/index.ts';
import type { AppState } from '../../state/state.ts';
import { encode } from '../../state/url.ts';
import type { PageContext, PageView } from '../page.ts';
import { lessonStepOf, readSettings } from './lesson-step.ts';
import {
  type Channel,
  CLICKER_KEYS,
  type ClickerKey,
  openChannel,
  type Projected,
} from './presenter-channel.ts';
import { exploreParts, type PresenterParts, stepParts } from './presenter-parts.ts';
import './presenter.css';

/** Longest wait in ms for an answer from a window of the same browser. */
const ANSWER_MS = 2000;
/** The type size of the drawing's symbols, as presenter.css has it. */
const LABEL = 15;
const DRAWING = { width: 300, height: 170, scale: 0.7, label: LABEL };

const NO_ANSWER =
  'No window answers. This one follows the window in which it was opened, as long as a lesson or ' +
  'Explore is shown there.';
const LEFT = 'The other window shows neither a lesson nor Explore now.';
const NO_CHANNEL =
  'This browser opens no channel between two windows here (BroadcastChannel): this one follows ' +
  'no other.';

/** The presenter's window, beside a lesson or Explore: text, notes, what comes next, the time. */
export function mountPresenter(host: HTMLElement, context: PageContext, id: string): PageView {
  const { dispatch, changed } = context;
  host.classList.add('presenter');
  document.documentElement.classList.add('presenter-window');
  provideExamples(GALLERY);
  const deriveNext = createDerive(() => exploreDetails);
  let stage: Projected | null = null;
  let begun = Date.now();
  let notice = '';
  let channel: Channel | null = null;
  const say = (words: string): void => {
    notice = words;
    changed();
  };
  const silence = setTimeout(() => say(NO_ANSWER), ANSWER_MS);
  try {
    channel = openChannel(id, (message) => {
      if (message.type !== 'shown') return;
      clearTimeout(silence);
      ({ stage } = message);
      // With Explore's link this window would show Explore itself.
      if (stage && !stage.look) dispatch({ type: 'link', hash: stage.hash });
      say(stage ? '' : LEFT);
    });
    channel.send({ type: 'hello' });
  } catch {
    clearTimeout(silence);
    notice = NO_CHANNEL;
  }
  const press = (key: ClickerKey): void => channel?.send({ type: 'key', key });
  const turn = (by: 1 | -1): void => press(by === 1 ? 'PageDown' : 'PageUp');

  // The projected window becomes black, and not this one; a clicker's keys are for that one too.
  window.addEventListener(
    'keydown',
    (event) => {
      const { key, altKey, ctrlKey, metaKey } = event;
      const isPlain = !(altKey || ctrlKey || metaKey);
      const known = CLICKER_KEYS.find((one) => one === key);
      if (!isPlain || !known) return;
      event.preventDefault();
      event.stopImmediatePropagation();
      if (!event.repeat) press(known);
    },
    true,
  );

  const clock = document.createElement('p');
  clock.className = 'presenter-clock';
  const restart = (): void => {
    begun = Date.now();
    tick();
  };
  function tick(): void {
    const now = new Date();
    const time = `${two(now.getHours())}:${two(now.getMinutes())}`;
    const seconds = Math.max(0, Math.floor((now.getTime() - begun) / 1000));
    const passed = `${Math.floor(seconds / 60)}:${two(seconds % 60)}`;
    render(
      html`<time class="now">${time}</time>
        <span>since the start <time class="passed">${passed}</time></span>
        <button type="button" class="bordered" @click=${restart}>Start again</button>`,
      clock,
    );
  }
  tick();
  setInterval(tick, 1000);

  const frame = document.createElement('div');
  host.append(frame);
  const drawing = document.createElement('div');
  drawing.className = 'presenter-drawing';

  const show = ({ of, title, text, aside, next, drawn }: PresenterParts): void => {
    draw(drawn);
    render(
      html`<header class="presenter-head"><p>${of}</p><h2>${title}</h2></header>
        <section class="presenter-text" aria-label="Text">${text}</section>
        <section class="presenter-notes" aria-label=${aside.name}>
          <h3>${aside.name}</h3>${aside.content}
        </section>
        <section class="presenter-next" aria-label="Next">
          <h3>Next: ${next}</h3>
          ${drawn ? drawing : nothing}
        </section>
        <p class="presenter-notice" data-say>${notice}</p>
        <footer class="presenter-foot">
          ${clock}
          <button type="button" class="bordered" @click=${() => turn(-1)}>Back</button>
          <button type="button" class="bordered" @click=${() => press('.')}>Black screen</button>
          <button type="button" class="primary" @click=${() => turn(1)}>Next</button>
        </footer>`,
      frame,
    );
  };

  let drawn = '';
  const draw = (state: AppState | null): void => {
    const link = state ? encode(state) : '';
    if (link === drawn) return;
    drawn = link;
    drawing.replaceChildren();
    if (state) drawStill(drawing, deriveNext(state).scene, DRAWING);
  };

  return {
    render(state) {
      const settings = state.settings.lesson;
      const place = lessonStepOf(settings);
      if (stage?.look) show(exploreParts(stage));
      else if (place) show(stepParts(settings, place, stage?.numbers ?? {}));
      else render(html`<p class="presenter-notice" data-say>${notice || LEFT}</p>`, frame);
    },
    read: readSettings,
    exports: () => [],
    turn,
  };
}

const two = (x: number): string => String(x).padStart(2, '0');
