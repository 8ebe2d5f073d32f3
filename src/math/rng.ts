import { scale } from './float/bits.ts';

/** Doubles in [0, 1), the same sequence for the same seed everywhere. */
export type Random = () => number;

/**
 * Mulberry32 (Tommy Ettinger, public domain): 32 bits a call and a period of 2^32, enough for test
 * rays and exercises, no good for secrets. Two calls make one double, so that all 53 bits vary:
 * 32-bit inputs would hide the very rounding errors that these numbers are meant to show.
 *
 * @param seed a whole number; its lower 32 bits count.
 * @example
 * seeded(7)() === seeded(7)(); // → true
 */
export function seeded(seed: number): Random {
  let state = seed | 0;
  const word = (): number => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return (t ^ (t >>> 14)) >>> 0;
  };
  return () => {
    const high = word() >>> 5;
    return (high * 2 ** 26 + (word() >>> 6)) / 2 ** 53;
  };
}

/**
 * Uniform in [low, high).
 *
 * @param random where chance comes from.
 * @param low and `high` have one unit; low < high.
 * @returns in the unit of `low` and `high`.
 * @see NUMERICS.md, section 6
 * @example
 * const x = uniform(seeded(7), 2, 3);
 * x >= 2 && x < 3; // → true
 */
export const uniform = (random: Random, low: number, high: number): number =>
  low + (high - low) * random();

/**
 * A whole number from low to high, both included.
 *
 * @param random where chance comes from.
 * @param low and `high` are whole numbers; low ≤ high.
 * @returns a whole number.
 * @see NUMERICS.md, section 6
 * @example
 * const faces = Array.from({ length: 50 }, ((random) => () => integer(random, 1, 6))(seeded(7)));
 * [Math.min(...faces), Math.max(...faces)]; // → [1, 6]
 */
export const integer = (random: Random, low: number, high: number): number =>
  low + Math.floor(random() * (high - low + 1));

/**
 * −1 or 1.
 *
 * @param random where chance comes from.
 * @returns no unit: −1 or 1.
 * @see NUMERICS.md, section 6
 * @example
 * Math.abs(randomSign(seeded(7))); // → 1
 */
export const randomSign = (random: Random): number => (random() < 0.5 ? -1 : 1);

/**
 * One of a list, each as likely as the others.
 *
 * @param random where chance comes from.
 * @param from at least one.
 * @example
 * pick(seeded(7), ['only']); // → 'only'
 */
export function pick<T>(random: Random, from: readonly [T, ...T[]]): T {
  return from[Math.floor(random() * from.length)] ?? from[0];
}

/**
 * Either sign, exponent uniform over [low, high], all fraction bits random; the default spans every
 * finite double, subnormals included (those then carry fewer bits).
 *
 * @param random where chance comes from.
 * @param low and `high` are exponents of two: whole numbers from −1074 to 1023, low ≤ high.
 * @returns no unit; any finite double of the range.
 * @see NUMERICS.md, section 6
 * @example
 * const x = Math.abs(wide(seeded(7), 3, 3));
 * x >= 8 && x < 16; // → true
 */
export function wide(random: Random, low = -1074, high = 1023): number {
  const fraction = randomSign(random) * (1 + random());
  return scale(fraction, integer(random, low, high));
}
