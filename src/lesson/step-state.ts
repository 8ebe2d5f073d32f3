import type { Changes } from '../state/actions.ts';
import { type AppState, INITIAL, type Settings } from '../state/state.ts';
import { decode, encode } from '../state/url.ts';
import type { Step } from './lesson.ts';

/*
 * A step shows a state of its own: the step's link, with what has been moved since. The lesson's
 * link carries the second as pairs beside its own keys, so that it restores what is shown:
 * #/lesson/d-decides?step=3&r=1.25
 */

/** Keys of a lesson's own; every other one belongs to what the step shows. */
export const LESSON_KEYS = ['id', 'step', 'guess', 'shown', 'file'] as const;
const isOwn = (key: string): boolean => LESSON_KEYS.some((one) => one === key);

type Pairs = ReadonlyMap<string, string>;

function pairsOf(hash: string): Pairs {
  const query = hash.split('?').slice(1).join('?');
  const pairs = query.split('&').filter(Boolean);
  return new Map(
    pairs.map((pair): [string, string] => {
      const [key = '', ...value] = pair.split('=').map(decodeURIComponent);
      return [key, value.join('=')];
    }),
  );
}

/** Whether results are hidden is the step's own affair. */
const linkOf = (state: AppState): string => encode({ ...state, revealed: null });

/** What the settings add to the step's link: an empty text takes a key back to its default. */
function hashOf({ link }: Step, settings: Settings): string {
  const base = decode(link);
  const pairs = new Map(pairsOf(linkOf(base)));
  for (const [key, value] of Object.entries(settings)) {
    if (isOwn(key)) continue;
    if (value === '') pairs.delete(key);
    else pairs.set(key, value);
  }
  const query = [...pairs].map(([key, value]) => `${key}=${encodeURIComponent(value)}`);
  return `#/${base.page}?${query.join('&')}`;
}

export function innerState(step: Step, settings: Settings): AppState {
  const state = decode(hashOf(step, settings), INITIAL);
  return { ...state, revealed: isHidden(step, settings) ? 0 : null };
}

/** Whether a question is open: nobody has answered it or asked for the answer. */
export const isAsked = ({ guess }: Step, settings: Settings): boolean =>
  guess !== null && settings.guess === undefined && settings.shown === undefined;

/** The results are hidden while they are what is asked for, or until somebody wants to see them. */
export function isHidden(step: Step, settings: Settings): boolean {
  if (step.guess !== null && step.guess.type !== 'free') return isAsked(step, settings);
  return step.hide && settings.shown === undefined;
}

/** The settings that stand for a state: what differs from the step's own, and null for the rest. */
export function changesOf(step: Step, state: AppState, settings: Settings): Changes {
  const base = pairsOf(linkOf(decode(step.link)));
  const now = pairsOf(linkOf(state));
  const keys = new Set([...base.keys(), ...now.keys(), ...Object.keys(settings)]);
  const changes = [...keys]
    .filter((key) => !isOwn(key))
    .map((key): [string, string | null] => {
      const value = now.get(key);
      return [key, value === base.get(key) ? null : (value ?? '')];
    });
  return Object.fromEntries(changes);
}

/** Another step: what was moved and said in the present one is left. */
export function toStep(number: number): (now: Settings) => Changes {
  return (now) => ({
    ...Object.fromEntries(
      Object.keys(now)
        .filter((key) => key !== 'id' && key !== 'file')
        .map((key) => [key, null]),
    ),
    step: number === 1 ? null : String(number),
  });
}
