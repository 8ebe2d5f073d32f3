import type { Verdict } from '../../math/index.ts';
import { nextDown, nextUp } from '../../math/shapes.ts';
import { MOST_DIGITS, rightDigitsOfDouble } from '../digits.ts';

/** What can be said of a pixel; a byte of a map is a place in this list. */
export const MARKS = ['right', 'misses', 'invents', 'count', 'undecided', 'nothing'] as const;
export type Mark = (typeof MARKS)[number];
export const markByte = (mark: Mark): number => MARKS.indexOf(mark);
/** The byte of a pixel that is not there yet. */
export const PENDING = 255;

/** A byte for a verdict is a place in this list. */
export const VERDICTS: readonly Verdict[] = [
  'none',
  'one',
  'two',
  'tangent',
  'contained',
  'undecided',
];
const ROOTS: Readonly<Record<Verdict, number>> = {
  none: 0,
  one: 1,
  tangent: 1,
  two: 2,
  contained: Number.POSITIVE_INFINITY,
  undecided: Number.NaN,
};

/** 'count': there is something to hit, and another number or kind of it was found. */
export function markOf(said: Verdict, truth: Verdict): Mark {
  if (said === 'undecided') return 'undecided';
  if (said === truth) return 'right';
  if (ROOTS[said] === 0) return 'misses';
  return ROOTS[truth] === 0 ? 'invents' : 'count';
}

/** Tenths of a decimal digit are what a byte of `lost` counts. */
export const TENTHS = 10;

/** In tenths, of the worse root; NaN stands for no root. */
export function lostDigits(own: readonly number[], truth: readonly number[]): number {
  let most = 0;
  truth.forEach((t, i) => {
    if (Number.isNaN(t)) return;
    const mine = own[i] ?? Number.NaN;
    // Of two doubles around a root either may be the one that was found.
    if (mine === nextUp(t) || mine === nextDown(t)) return;
    most = Math.max(most, MOST_DIGITS - rightDigitsOfDouble(mine, t));
  });
  return Math.round(TENTHS * most);
}
