import { html, nothing, type TemplateResult } from 'lit';
import { type Channel, openChannel } from './two-windows.ts';

type Words = TemplateResult | typeof nothing;

const KEPT = 'graze.presenter';

/** A reloaded window is found again by its presenter's one. */
function kept(): string | null {
  try {
    return sessionStorage.getItem(KEPT);
  } catch {
    return null;
  }
}

function keep(id: string): void {
  try {
    sessionStorage.setItem(KEPT, id);
  } catch {
    // Then they part when this one is reloaded.
  }
}

/** The projected window's side: it shows, and the presenter's window is told what. */
export function createProjected(changed: () => void) {
  let id = kept();
  let channel: Channel | null = null;
  let hash: string | null = null;
  let problem: Words = nothing;

  const tell = (): void => channel?.send({ type: 'shown', hash });
  const connect = (as: string): void => {
    channel ??= openChannel(as, (message) => {
      if (message.type === 'hello') tell();
      if (message.type !== 'key') return;
      const init = { key: message.key, bubbles: true, cancelable: true };
      document.body.dispatchEvent(new KeyboardEvent('keydown', init));
      document.body.dispatchEvent(new KeyboardEvent('keyup', init));
    });
  };
  const say = (words: Words): void => {
    problem = words;
    changed();
  };
  const connected = (): boolean => {
    try {
      id ??= Math.random().toString(36).slice(2);
      connect(id);
      keep(id);
      return true;
    } catch {
      say(html`This browser opens no channel between two windows here (BroadcastChannel), so there
        is no presenter's window.`);
      return false;
    }
  };
  if (id !== null) connected();
  window.addEventListener('pagehide', () => channel?.send({ type: 'shown', hash: null }));

  return {
    /** Why there is no second window, with what helps. */
    problem: (): Words => problem,
    /** What this window shows now; null where that is no step of a lesson. */
    show(next: string | null): void {
      if (next === hash) return;
      hash = next;
      tell();
    },
    /** Opens the presenter's window, or brings it to the front. */
    open(): void {
      if (!connected()) return;
      const address = `${location.href.split(/[?#]/)[0]}?presenter=${id}${hash ?? ''}`;
      const opened = window.open(address, `graze-presenter-${id}`, 'popup,width=1000,height=700');
      opened?.focus();
      const link = html`<a href=${address} target=${`graze-presenter-${id}`}>open it here</a>`;
      say(opened ? nothing : html`The browser kept the presenter’s window from opening: ${link}.`);
    },
  };
}
