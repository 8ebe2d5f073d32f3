import type { Verdict } from '../math/index.ts';

/** How a method's class compares with the exact one. */
export type Judgement = 'right' | 'misses' | 'invents' | 'misnames' | 'undecided';

const POINTS: Readonly<Record<Verdict, number>> = {
  none: 0,
  one: 1,
  tangent: 1,
  two: 2,
  contained: Number.POSITIVE_INFINITY,
  undecided: Number.NaN,
};

/**
 * 'misses': fewer points than there are; 'invents': more; 'misnames': as many in another class (a
 * tangent for a single root).
 */
export function judge(verdict: Verdict, truth: Verdict): Judgement {
  if (verdict === 'undecided') return 'undecided';
  if (verdict === truth) return 'right';
  const more = POINTS[verdict] - POINTS[truth];
  return more < 0 ? 'misses' : more > 0 ? 'invents' : 'misnames';
}

export const JUDGEMENTS: Readonly<Record<Judgement, string>> = {
  right: 'right',
  misses: 'misses a hit',
  invents: 'sees a hit that is not there',
  misnames: 'wrong kind of hit',
  undecided: 'cannot tell',
};
