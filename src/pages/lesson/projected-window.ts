import type { AppState } from '../../state/state.ts';
import { encode } from '../../state/url.ts';
import type { Announce } from '../../ui/announcer.ts';
import { type Channel, openChannel, type Projected } from './presenter-channel.ts';

/** Why there is no second window, with its address for a link that opens it. */
export interface WindowProblem {
  readonly words: string;
  readonly address: string;
  readonly target: string;
}

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
    // Without the id, a reload of this window ends the connection.
  }
}

let only: ReturnType<typeof createProjected> | null = null;

/** This window as the projected one: it sends what it shows to the presenter's window. */
export const projectedWindow = (): ReturnType<typeof createProjected> =>
  (only ??= createProjected());

function createProjected() {
  let id = kept();
  let channel: Channel | null = null;
  let shown: () => Projected | null = () => null;
  /** The message that was sent last, so that none is sent twice. */
  let told = '';

  const tell = (stage = shown()): void => channel?.send({ type: 'shown', stage });
  const connect = (as: string): void => {
    channel ??= openChannel(as, (message) => {
      if (message.type === 'hello') tell();
      if (message.type !== 'key') return;
      const init = { key: message.key, bubbles: true, cancelable: true };
      document.body.dispatchEvent(new KeyboardEvent('keydown', init));
      document.body.dispatchEvent(new KeyboardEvent('keyup', init));
    });
  };
  const connected = (): boolean => {
    try {
      id ??= Math.random().toString(36).slice(2);
      connect(id);
      keep(id);
      return true;
    } catch {
      return false;
    }
  };
  if (id !== null) connected();
  window.addEventListener('pagehide', () => channel?.send({ type: 'shown', stage: null }));

  return {
    /** What this window shows now, asked where somebody listens; null for another page. */
    show(next: () => Projected | null): void {
      shown = next;
      if (!channel) return;
      const stage = shown();
      const words = JSON.stringify(stage);
      if (words === told) return;
      told = words;
      tell(stage);
    },
    /** Opens the presenter's window, or brings it to the front; says why that could not be done. */
    open(): WindowProblem | null {
      if (!connected()) {
        const words =
          'This browser opens no channel between two windows here (BroadcastChannel), so there ' +
          'is no presenter’s window.';
        return { words, address: '', target: '' };
      }
      const hash = shown()?.hash ?? '';
      const link = hash.startsWith('#/lesson/') ? hash : '#/lesson';
      const address = `${location.href.split(/[?#]/)[0]}?presenter=${id}${link}`;
      const target = `graze-presenter-${id}`;
      const opened = window.open(address, target, 'popup,width=1000,height=700');
      opened?.focus();
      const words = 'The browser kept the presenter’s window from opening';
      return opened ? null : { words, address, target };
    },
  };
}

/** Tells the presenter's window what Explore shows; a lesson tells it itself. */
export function followExplore(state: AppState): void {
  if (state.page === 'lesson') return;
  const { revealed, told, example } = state;
  projectedWindow().show(() =>
    state.page === 'explore'
      ? { hash: encode(state), numbers: {}, look: { revealed, told, example } }
      : null,
  );
}

export const OPENED = 'The presenter’s window is open.';

/** Opens the presenter's window beside Explore; returns why that could not be done. */
export function presentExplore(announce: Announce): string | null {
  const problem = projectedWindow().open();
  if (!problem) {
    announce(OPENED, 'deed');
    return null;
  }
  const advice = ': allow windows of this site to open, and press the key again';
  return problem.address ? problem.words + advice : problem.words;
}
