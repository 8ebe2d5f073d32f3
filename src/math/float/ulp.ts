import { lazily } from '../lazily.ts';

const scratch = lazily(() => new DataView(new ArrayBuffer(8)));
const TWO_32 = 2 ** 32;

/** The double whose magnitude is `by` (±1) steps from that of x, with x's sign. */
function stepMagnitude(x: number, by: 1 | -1): number {
  const view = scratch();
  view.setFloat64(0, x);
  const low = view.getUint32(4) + by;
  if (low < 0 || low >= TWO_32) view.setUint32(0, view.getUint32(0) + by);
  view.setUint32(4, low);
  return view.getFloat64(0);
}

/**
 * The least double above x, as IEEE 754's nextUp: MAX_VALUE gives Infinity, the negative number
 * nearest 0 gives −0, either zero the smallest subnormal, Infinity and NaN themselves.
 *
 * @param x any double, of any unit.
 * @returns in the unit of x.
 * @see IEEE 754
 * @example
 * nextUp(1) - 1; // → 2 ** -52
 */
export function nextUp(x: number): number {
  if (x === 0) return Number.MIN_VALUE;
  if (x === Infinity || Number.isNaN(x)) return x;
  return stepMagnitude(x, x > 0 ? 1 : -1);
}

/**
 * The greatest double below x: −nextUp(−x).
 *
 * @param x any double, of any unit.
 * @returns in the unit of x.
 * @see IEEE 754
 * @example
 * 1 - nextDown(1); // → 2 ** -53
 */
export const nextDown = (x: number): number => -nextUp(-x);

/**
 * How many steps from double to double lead from a to b: a whole number ≥ 0, whatever the order of
 * a and b. +0 and −0 are the same place, steps are counted through it, and Infinity is one step
 * beyond MAX_VALUE. Exact up to 2^53; beyond that (opposite ends of the line: 1.8e19) the nearest
 * double to the count.
 *
 * @param a any double, as b, of one unit; NaN gives NaN.
 * @returns steps: a whole number, or NaN.
 * @see IEEE 754
 * @example
 * ulpDistance(0.1 + 0.2, 0.3); // → 1
 * ulpDistance(-0, 0); // → 0
 */
export function ulpDistance(a: number, b: number): number {
  if (Number.isNaN(a) || Number.isNaN(b)) return Number.NaN;
  const view = scratch();
  view.setFloat64(0, a);
  const signA = Math.sign(a);
  const highA = (view.getUint32(0) & 0x7fffffff) * signA;
  const lowA = view.getUint32(4) * signA;
  view.setFloat64(0, b);
  const signB = Math.sign(b);
  const highB = (view.getUint32(0) & 0x7fffffff) * signB;
  const lowB = view.getUint32(4) * signB;
  return Math.abs((highA - highB) * TWO_32 + (lowA - lowB));
}
