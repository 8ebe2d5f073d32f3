/*
 * How much of a long test `npm test` does: a quarter. The unit tests and the browser tests of
 * `npm run test:long` have LONG and do all of it.
 */

const isLong = Boolean(process.env.LONG);

/** A number of random cases; the same seed begins with the same ones. */
export const many = (all: number): number => (isLong ? all : Math.ceil(all / 4));

/** Of a list every fourth. */
export const share = <T>(all: readonly T[]): T[] => all.filter((_, i) => isLong || i % 4 === 0);
