/*
 * How much of a long test `npm test` does. The unit tests and the browser tests of
 * `npm run test:long` have LONG and do all of it.
 */

const isLong = Boolean(process.env.LONG);

/** A number of random cases, an eighth of all; the same seed begins with the same ones. */
export const many = (all: number): number => (isLong ? all : Math.ceil(all / 8));

/** Of a list every nth, from another entry on each turn. */
export const byTurns = <T>(all: readonly T[], turn = 0, nth = 2): T[] =>
  all.filter((_, i) => isLong || (i + turn) % nth === 0);

/** Of a list every fourth. */
export const share = <T>(all: readonly T[]): T[] => byTurns(all, 0, 4);
