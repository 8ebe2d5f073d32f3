import type { ExploreModel } from '../../state/derive.ts';
import { answerOf, opened, readMessage, type ToHost } from '../../state/host-messages.ts';
import type { AppState } from '../../state/state.ts';
import type { Store } from '../../state/store.ts';
import { decode, encode } from '../../state/url.ts';
import { watchForms } from '../../ui/forms.ts';
import { leaveKeys } from './host-keys.ts';

/** The page's side of the communication with the host. */
interface Framed {
  readonly store: Store;
  /** What Explore shows; null on another page. */
  readonly model: (state: AppState) => ExploreModel | null;
  /** Right answers and questions asked, where the page asks. */
  readonly score: () => { readonly right: number; readonly asked: number } | null;
  /** The element that grows with its content. */
  readonly content: HTMLElement;
}

/** Keys of controls that take text or numbers. */
const TYPED = 'input, textarea, select, [role=slider], [contenteditable]';

/**
 * Graze in a frame: answers messages of its host, sends keys and the height, and restores the state
 * after the frame was reloaded. Messages are accepted from the parent window alone, and from the
 * first origin that it uses; states are sent to that origin alone.
 */
export function watchHost({ store, model, score, content }: Framed): { drawn(): void } {
  const first = encode(store.get());
  let origin: string | null = null;
  let subscribed = false;
  let told = '';
  let toldScore = '';
  let height = 0;

  const post = (message: ToHost, to = '*'): void => {
    window.parent.postMessage({ graze: 1, ...message }, to === 'null' ? '*' : to);
  };
  const tellState = (): void => {
    if (origin === null) return;
    const state = store.get();
    post({ type: 'state', ...answerOf(state, model(state)) }, origin);
  };
  const hear = (event: MessageEvent): void => {
    if (event.source !== window.parent || (origin !== null && event.origin !== origin)) return;
    const message = readMessage(event.data, store.get().page);
    if (message === null) return;
    origin = event.origin;
    if ('error' in message) post({ type: 'error', reason: message.error }, origin);
    else if (message.type === 'get') tellState();
    else if (message.type === 'subscribe') {
      subscribed = true;
      tellState();
    } else {
      const link = message.type === 'reset' ? first : message.link;
      store.dispatch({ type: 'open', state: (now) => opened(link, now) });
      for (const reason of store.get().problems) post({ type: 'error', reason }, origin);
    }
  };
  window.addEventListener('message', hear);
  watchForms(document);

  leaveKeys(window, ({ key }) => post({ type: 'key', key }));
  window.addEventListener('keydown', (event) => {
    const { key, target, defaultPrevented } = event;
    const isModified = event.altKey || event.ctrlKey || event.metaKey;
    const isTyped = target instanceof Element && target.closest(TYPED) !== null;
    if (defaultPrevented || isModified || (isTyped && key !== 'Escape')) return;
    if (/^(Escape|Arrow\w+)$/.test(key)) post({ type: 'key', key });
  });

  const measure = (): void => {
    // Measured without the frame's height, so that the content can also shrink.
    content.classList.add('natural');
    const px = Math.ceil(content.scrollHeight);
    content.classList.remove('natural');
    if (px === height) return;
    height = px;
    post({ type: 'height', px });
  };
  new ResizeObserver(measure).observe(content);

  const kept = keptFor(first);
  const before = kept.read();
  // Not if the person has changed the state before this code was loaded.
  if (before !== null && encode(store.get()) === first) {
    store.dispatch({ type: 'open', state: (now) => decode(before, now) });
  }
  post({ type: 'ready' });

  return {
    drawn() {
      measure();
      const now = encode(store.get());
      if (now !== told) kept.write(now);
      if (subscribed && now !== told) tellState();
      told = now;
      const scored = score();
      const words = JSON.stringify(scored);
      if (scored && words !== toldScore) post({ type: 'score', ...scored });
      toldScore = words;
    },
  };
}

/**
 * Storage of the latest state of a frame, by the link that it was opened with: window.name survives
 * a reload of the frame, sessionStorage a reload of the host. Both are written at each change, as
 * browsers may drop what a page writes while it is unloaded.
 */
function keptFor(link: string): { read(): string | null; write(state: string): void } {
  const key = `graze.frame ${link}`;
  const isOurs = (): boolean => window.name === '' || window.name.startsWith('graze.frame ');
  return {
    read() {
      if (window.name.startsWith(`${key}\n`)) return window.name.slice(key.length + 1);
      try {
        return sessionStorage.getItem(key);
      } catch {
        // A frame without an origin has no session.
        return null;
      }
    },
    write(state) {
      if (isOurs()) window.name = `${key}\n${state}`;
      try {
        sessionStorage.setItem(key, state);
      } catch {
        // window.name alone keeps the state.
      }
    },
  };
}
