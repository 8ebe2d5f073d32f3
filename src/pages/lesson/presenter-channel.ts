import type { ShownValue } from './prose-view.ts';

/*
 * Messages between the projected window of a lecture and the presenter's window with notes and a
 * clock: the same page with ?presenter=ID in its address, over a BroadcastChannel of that id.
 */

/** What the projected window shows. */
export interface Projected {
  /** The link of a step of a lesson, or of Explore. */
  readonly hash: string;
  /** What a lesson's text tells of another page than Explore, as it stands there. */
  readonly numbers: Readonly<Record<string, ShownValue>>;
  /** State of Explore that no link carries; null for a lesson. */
  readonly look: {
    /** How many lines of the result are shown; null for all of them. */
    readonly revealed: number | null;
    /** Whether the example's answer is shown. */
    readonly told: boolean;
    /** The id of the example that the state was made from. */
    readonly example: string | null;
  } | null;
}

/** What the windows tell each other. */
export type Message =
  /** From the projected window; null where it shows neither a lesson nor Explore. */
  | { readonly type: 'shown'; readonly stage: Projected | null }
  /** From the presenter's window: which link is shown? */
  | { readonly type: 'hello' }
  /** From the presenter's window: a key of the clicker, for the projected one. */
  | { readonly type: 'key'; readonly key: ClickerKey };

export const CLICKER_KEYS = ['PageDown', 'PageUp', 'b', '.'] as const;
export type ClickerKey = (typeof CLICKER_KEYS)[number];

/** A link with a long lesson of one's own has some ten thousand characters. */
const LONGEST_LINK = 1_000_000;
/** A step's text has some ten live numbers. */
const MOST_NUMBERS = 500;
const LONGEST_TEXT = 200;

const isRecord = (data: unknown): data is Readonly<Record<string, unknown>> =>
  typeof data === 'object' && data !== null;

/** The message, checked: any page of this origin may send anything. Null for no message. */
export function readMessage(data: unknown): Message | null {
  if (!isRecord(data)) return null;
  const { type, stage, key } = data;
  if (type === 'hello') return { type };
  if (type === 'key') {
    const known = CLICKER_KEYS.find((one) => one === key);
    return known ? { type, key: known } : null;
  }
  if (type !== 'shown') return null;
  if (stage === null) return { type, stage };
  const read = readProjected(stage);
  return read && { type, stage: read };
}

const isShort = (data: unknown): data is string =>
  typeof data === 'string' && data.length <= LONGEST_TEXT;

function readProjected(data: unknown): Projected | null {
  if (!isRecord(data)) return null;
  const { hash } = data;
  if (typeof hash !== 'string' || hash.length > LONGEST_LINK) return null;
  const numbers = readNumbers(data.numbers);
  if (!numbers) return null;
  if (hash.startsWith('#/lesson/'))
    return data.look === null ? { hash, numbers, look: null } : null;
  const look = readLook(data.look);
  return look && hash.startsWith('#/explore') ? { hash, numbers, look } : null;
}

function readNumbers(data: unknown): Projected['numbers'] | null {
  if (!isRecord(data)) return null;
  const all = Object.entries(data);
  if (all.length > MOST_NUMBERS) return null;
  const read: [string, ShownValue][] = [];
  for (const [name, shown] of all) {
    if (!isShort(name) || !isRecord(shown)) return null;
    const { value, text } = shown;
    if (!isShort(text) || !(typeof value === 'number' || isShort(value))) return null;
    read.push([name, { value, text }]);
  }
  return Object.fromEntries(read);
}

function readLook(data: unknown): Projected['look'] {
  if (!isRecord(data)) return null;
  const { revealed, told, example } = data;
  const isCount = revealed === null || (Number.isInteger(revealed) && Number(revealed) >= 0);
  if (!isCount || typeof told !== 'boolean' || !(example === null || isShort(example))) return null;
  return { revealed: revealed as number | null, told, example };
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
