/*
 * A lesson in two windows: the one that is projected, and the presenter's with notes and clock. It
 * is the same page with ?presenter=ID in its address; they speak over a channel of that name.
 */

/** What the windows tell each other. */
export type Message =
  /** From the projected window: the link of what it shows; null where that is no lesson. */
  | { readonly type: 'shown'; readonly hash: string | null }
  /** From the presenter's window: which link is shown? */
  | { readonly type: 'hello' }
  /** From the presenter's window: a key of the clicker, for the projected one. */
  | { readonly type: 'key'; readonly key: ClickerKey };

export const CLICKER_KEYS = ['PageDown', 'PageUp', 'b', '.'] as const;
export type ClickerKey = (typeof CLICKER_KEYS)[number];

/** A link with a long lesson of one's own has some ten thousand characters. */
const LONGEST_LINK = 1_000_000;

const isRecord = (data: unknown): data is Readonly<Record<string, unknown>> =>
  typeof data === 'object' && data !== null;

/** The message, where it is one: any page of this origin may send anything. */
export function readMessage(data: unknown): Message | null {
  if (!isRecord(data)) return null;
  const { type, hash, key } = data;
  if (type === 'hello') return { type };
  if (type === 'key') {
    const known = CLICKER_KEYS.find((one) => one === key);
    return known ? { type, key: known } : null;
  }
  if (type !== 'shown') return null;
  if (hash === null) return { type, hash };
  const isLink =
    typeof hash === 'string' && hash.startsWith('#/lesson/') && hash.length <= LONGEST_LINK;
  return isLink ? { type, hash } : null;
}

/** The id in the address of a presenter's window; null in any other one. */
export function presenterIn(search: string): string | null {
  const id = new URLSearchParams(search).get('presenter');
  return id !== null && /^[a-z\d]{1,32}$/.test(id) ? id : null;
}

export interface Channel {
  send(message: Message): void;
}

/** Throws where the browser has no channels between windows, or does not open one here. */
export function openChannel(id: string, receive: (message: Message) => void): Channel {
  const channel = new BroadcastChannel(`graze.presenter.${id}`);
  channel.addEventListener('message', ({ data }) => {
    const message = readMessage(data);
    if (message) receive(message);
  });
  return { send: (message) => channel.postMessage(message) };
}
