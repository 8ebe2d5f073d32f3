import { lazily } from '../lazily.ts';

const scratch = lazily(() => new DataView(new ArrayBuffer(8)));
const MAGNITUDE = 0x7fffffffffffffffn;
/** The bits of the largest double. */
const LARGEST = 0x7fefffffffffffffn;

/**
 * The double that is `count` steps from double to double above x, or below it for a negative count.
 * Both zeros are one place, as for `ulpDistance`; what would lie beyond the largest double is that.
 *
 * @param x any finite double, of any unit; with a count of 0 it comes back as it is.
 * @param count a whole number up to 2^53 in size.
 * @returns in the unit of x.
 * @throws RangeError for an x that is not finite, or a count that is no such number.
 * @see IEEE 754
 * @example
 * stepped(1, 3) - 1; // → 3 * 2 ** -52
 * stepped(0, -1); // → -5e-324
 */
export function stepped(x: number, count: number): number {
  if (!Number.isFinite(x)) throw new RangeError(`a finite number is needed, got ${x}`);
  if (!Number.isSafeInteger(count)) throw new RangeError(`${count} is no number of steps`);
  if (count === 0) return x;
  const view = scratch();
  view.setFloat64(0, x);
  const bits = view.getBigInt64(0);
  const place = (bits < 0n ? -(bits & MAGNITUDE) : bits) + BigInt(count);
  const size = place < 0n ? -place : place;
  view.setBigInt64(0, size > LARGEST ? LARGEST : size);
  return place < 0n ? -view.getFloat64(0) : view.getFloat64(0);
}
