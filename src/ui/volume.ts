import { recall, remember } from './storage.ts';

const KEY = 'graze.volume';
/** Loud enough to be found, and no fright. */
const INITIAL = 0.4;

/** The volume of what is heard, 0 to 1, as it was set on this device. */
export function volume(): number {
  const kept = Number(recall(KEY) ?? INITIAL);
  return kept >= 0 && kept <= 1 ? kept : INITIAL;
}

export const setVolume = (loudness: number): void => remember(KEY, String(loudness));
