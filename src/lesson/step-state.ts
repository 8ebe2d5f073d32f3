import type { Changes } from '../state/actions.ts';
import { type AppState, INITIAL, type Settings } from '../state/state.ts';
import { decode, encode } from '../state/url.ts';
import type { Step } from './lesson.ts';

/*
 * The state that a step shows: that of the step's link with later changes. The lesson's link has
 * the changes as pairs beside its own keys: #/lesson/d-decides?step=3&r=1.25
 */

/** Keys of the lesson itself; all others belong to the state that the step shows. */
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

/** The link of a state without whether results are hidden, which is kept apart. */
const linkOf = (state: AppState): string => encode({ ...state, revealed: null });

/** The step's link with the settings' changes; an empty text resets a key to its default. */
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

/** Whether a question is open: neither answered nor its answer shown. */
export const isAsked = ({ guess }: Step, settings: Settings): boolean =>
  guess !== null && settings.guess === undefined && settings.shown === undefined;

/** Whether results are hidden: while they are asked for, or until they are revealed. */
export function isHidden(step: Step, settings: Settings): boolean {
  const { guess } = step;
  // What is free may be moved, and what is only asked may be looked for, with the results in view.
  if (guess !== null && guess.type !== 'free' && guess.type !== 'open') {
    return isAsked(step, settings);
  }
  return step.hide && settings.shown === undefined;
}

/** The settings for a state: its differences from the step's, and null for all other keys. */
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

/** Goes to another step and drops the changes and the guess of the present one. */
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
