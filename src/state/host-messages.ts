import type { Fate } from '../math/index.ts';
import { quote } from '../math/shapes.ts';
import type { ExploreModel } from './derive.ts';
import type { AppState } from './state.ts';
import { decode, encode } from './url.ts';

/*
 * Messages between Graze in a frame and its host page (docs/EMBEDDING.md).
 * Every message is an object with `graze: 1` and a `type`; anything else is ignored.
 */

type FromHost =
  | { readonly type: 'get' }
  /** `link`: of the page that is shown, or of another one. */
  | { readonly type: 'set'; readonly link: string }
  | { readonly type: 'reset' }
  | { readonly type: 'subscribe' };

export type ToHost =
  | { readonly type: 'ready' }
  | ({ readonly type: 'state' } & Answer)
  | { readonly type: 'height'; readonly px: number }
  | { readonly type: 'key'; readonly key: string }
  | { readonly type: 'score'; readonly right: number; readonly asked: number }
  | { readonly type: 'error'; readonly reason: string };

/** A state for the host: its link's query, and unless results are hidden the class and roots. */
export interface Answer {
  readonly state: string;
  readonly class: string | null;
  readonly t: readonly number[];
  /** Of a shape with ends: every root and cap in order of t, and its fate. */
  readonly fates?: readonly { readonly t: number; readonly fate: Fate }[];
}

/** Characters of a link that a message may carry; a longer one is refused. */
const LONGEST_LINK = 20_000;

/** A message as it came, from anyone; null for what is no message to Graze. */
export function readMessage(data: unknown, page: string): FromHost | { error: string } | null {
  if (typeof data !== 'object' || data === null) return null;
  const { graze, type, state } = data as Readonly<Record<string, unknown>>;
  if (graze !== 1) return null;
  if (type === 'get' || type === 'reset' || type === 'subscribe') return { type };
  if (type !== 'set') return null;
  if (typeof state !== 'string')
    return { error: `state must be a link's text, got ${kindOf(state)}` };
  if (state.length > LONGEST_LINK) {
    return { error: `state has ${state.length} characters, at most ${LONGEST_LINK} are read` };
  }
  return {
    type: 'set',
    link: /^#?\//.test(state)
      ? state.replace(/^#?/, '#')
      : `#/${page}?${state.replace(/^[#?]+/, '')}`,
  };
}

/** Describes a value without calling any function of it, not even toString. */
const kindOf = (value: unknown): string =>
  value === null || typeof value !== 'object' ? quote(value) : 'an object';

/** The state of a host's link; embed, lock and theme stay if the link does not have them. */
export function opened(link: string, now: AppState): AppState {
  const next = decode(link, now);
  const says = (key: string): boolean => new RegExp(`[?&]${key}=`).test(link);
  return {
    ...next,
    embed: says('embed') ? next.embed : now.embed,
    lock: says('lock') ? next.lock : now.lock,
    theme: says('theme') ? next.theme : now.theme,
  };
}

/** The query of a state's link, and, where they are shown on Explore, what the method found. */
export function answerOf(state: AppState, model: ExploreModel | null): Answer {
  const query = encode(state).replace(/^[^?]*\??/, '');
  const found = model?.shown.hits ? model.found : null;
  const ended = model?.shown.hits ? model.ended : null;
  return {
    state: query,
    class: found?.class ?? null,
    t: found?.hits.map(({ t }) => t) ?? [],
    ...(ended ? { fates: ended.fates } : {}),
  };
}
