import { html, nothing, render } from 'lit';
import { drawStill } from '../../canvas/thumbnail.ts';
import type { Step } from '../../lesson/lesson.ts';
import { innerState, isAsked, isHidden } from '../../lesson/step-state.ts';
import { closerLook } from '../../state/closer-look.ts';
import { createDerive } from '../../state/derive.ts';
import type { Settings } from '../../state/state.ts';
import type { PageContext, PageView } from '../page.ts';
import { exploreValue } from './prose-tools.ts';
import { type ProseTools, proseView } from './prose-view.ts';
import { type Place, placeOf, readSettings } from './source.ts';
import { type Channel, CLICKER_KEYS, type ClickerKey, openChannel } from './two-windows.ts';
import './presenter.css';

/** So long an answer takes at most, from a window of the same browser. */
const ANSWER_MS = 2000;
/** The type size of the drawing's symbols, as presenter.css has it. */
const LABEL = 15;
const DRAWING = { width: 300, height: 170, scale: 0.7, label: LABEL };

const NO_ANSWER =
  'No window answers. This one follows the window in which it was opened, as long as a lesson is ' +
  'shown there.';
const LEFT = 'The other window does not show a lesson now.';
const NO_CHANNEL =
  'This browser opens no channel between two windows here (BroadcastChannel): this one follows ' +
  'no other.';

/** The page of a lesson in the presenter's window: text, notes, what comes next, and the time. */
export function mountPresenter(host: HTMLElement, context: PageContext, id: string): PageView {
  const { dispatch, changed } = context;
  host.classList.add('presenter');
  document.documentElement.classList.add('presenter-window');
  const derive = createDerive(() => closerLook);
  const deriveNext = createDerive(() => closerLook);
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
      if (message.hash !== null) dispatch({ type: 'link', hash: message.hash });
      say(message.hash === null ? LEFT : '');
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

  const show = (settings: Settings, place: Place): void => {
    const { lesson, number, step } = place;
    const next = lesson.steps[number];
    const inner = innerState(step, { ...settings, shown: '1' });
    const model = inner.page === 'explore' ? derive(inner) : null;
    const tools: ProseTools = {
      model,
      slider: () => nothing,
      isHidden: () => false,
      room: (_, digits) => digits,
      value: (name) => (model ? exploreValue(model, name) : null),
    };
    drawNext(next);
    render(
      html`<header class="presenter-head">
          <p>${lesson.title}</p>
          <h2>${number} of ${lesson.steps.length}: ${step.title}</h2>
        </header>
        <section class="presenter-text" aria-label="Text">
          ${proseView(step.text, tools)}
          ${
            step.guess
              ? html`<h3>Question</h3>${proseView(step.question, tools)}
                <h3>Answer</h3>${proseView(step.answer, tools)}`
              : nothing
          }
        </section>
        <section class="presenter-notes" aria-label="Notes"><h3>Notes</h3>
          ${step.notes.length > 0 ? proseView(step.notes, tools) : html`<p>None for this step.</p>`}
        </section>
        <section class="presenter-next" aria-label="Next">
          <h3>Next: ${nextWords(settings, step, next)}</h3>
          ${next ? drawing : nothing}
        </section>
        <p class="presenter-notice" role="status">${notice}</p>
        <footer class="presenter-foot">
          ${clock}
          <button type="button" class="bordered" @click=${() => turn(-1)}>Back</button>
          <button type="button" class="bordered" @click=${() => press('.')}>Black screen</button>
          <button type="button" class="primary" @click=${() => turn(1)}>Next</button>
        </footer>`,
      frame,
    );
  };

  let drawn: Step | undefined;
  const drawNext = (next: Step | undefined): void => {
    if (next === drawn) return;
    drawn = next;
    drawing.replaceChildren();
    const state = next && innerState(next, {});
    if (state?.page === 'explore') drawStill(drawing, deriveNext(state).scene, DRAWING);
  };

  return {
    render(state) {
      const settings = state.settings.lesson;
      const place = placeOf(settings);
      if (place) show(settings, place);
      else render(html`<p class="presenter-notice" role="status">${notice || LEFT}</p>`, frame);
    },
    read: readSettings,
    exports: () => [],
    turn,
  };
}

const two = (x: number): string => String(x).padStart(2, '0');

/** What the next press of the clicker shows. */
function nextWords(settings: Settings, step: Step, next: Step | undefined): string {
  const after = next ? next.title : 'nothing, this is the last step';
  if (isAsked(step, settings)) return `the answer, then ${after}`;
  return isHidden(step, settings) ? `the results, then ${after}` : after;
}
